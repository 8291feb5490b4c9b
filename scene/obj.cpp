// obj.cpp: Wavefront OBJ files. tinyobjloader reads and triangulates the faces; the check before it
// finds what that library passes over in silence: "nan" becomes 0 there, and a bad index loses its
// face.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "scene/document.h"
#include "scene/mesh.h"

namespace litmus {
namespace {

/// Cutting a polygon into triangles takes time that grows with the square of its corners.
constexpr std::size_t kMostCorners = 4096;

[[noreturn]] void fail(int line, const std::string& message) {
  throw std::runtime_error(fmt::format(":{}: {}", line, message));
}

/// Cuts the next word off the front of the text; empty at its end.
std::string_view next_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t\r", begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

/// The whole word as a number.
template <class T>
bool parse(std::string_view word, T& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

/// What a file holds before tinyobjloader sees it.
struct Contents {
  std::vector<Point> vertices;  ///< to the last bit; tinyobjloader's own are a few ulp off
  std::size_t normals = 0, texture_points = 0, triangles = 0;
};

Point three_numbers(std::string_view rest, int line, const char* what) {
  Point point;
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = next_word(rest);
    if (!parse(word, point[i]) || !std::isfinite(point[i]))
      fail(line, fmt::format("a {} must be three finite numbers, not \"{}\"", what, word));
  }
  return point;
}

/// An index counts from 1, or back from the latest if negative.
void check_index(std::string_view word, std::size_t count, int line, const char* what) {
  std::int64_t index = 0;
  const bool is_number = parse(word, index);
  if (!is_number || index == 0 || std::size_t(std::abs(index)) > count)
    fail(line, fmt::format("\"{}\" names no {}; there are {} so far", word, what, count));
}

/// One corner of a face: v, v/vt, v//vn or v/vt/vn.
void check_corner(std::string_view word, const Contents& so_far, int line) {
  const std::size_t counts[] = {so_far.vertices.size(), so_far.texture_points, so_far.normals};
  constexpr const char* kNames[] = {"vertex", "texture point", "normal"};
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const bool skipped = part == 1 && slash == 0 && slash < word.size();
    if (!skipped) check_index(word.substr(0, slash), counts[part], line, kNames[part]);
    if (slash == word.size()) return;
    word.remove_prefix(slash + 1);
  }
  fail(line, "a corner of a face is v, v/vt, v//vn or v/vt/vn");
}

void check_face(std::string_view rest, int line, std::size_t most_triangles, Contents& contents) {
  std::size_t corners = 0;
  for (std::string_view word = next_word(rest); !word.empty() && word[0] != '#';
       word = next_word(rest)) {
    check_corner(word, contents, line);
    ++corners;
  }
  if (corners < 3) fail(line, fmt::format("a face needs at least 3 corners, not {}", corners));
  if (corners > kMostCorners)
    fail(line, fmt::format("a face may have {} corners, not {}", kMostCorners, corners));
  contents.triangles += corners - 2;
  if (contents.triangles > most_triangles)
    fail(line, fmt::format("more than {} triangles, the most that this scene has room for",
                           most_triangles));
}

Contents check(std::string_view text, std::size_t most_triangles) {
  Contents contents;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view keyword = next_word(rest);
    if (keyword == "v") contents.vertices.push_back(three_numbers(rest, line, "vertex"));
    if (keyword == "vn") three_numbers(rest, line, "normal"), ++contents.normals;
    if (keyword == "vt") ++contents.texture_points;
    if (keyword == "f") check_face(rest, line, most_triangles, contents);
  }
  if (contents.triangles == 0) fail(1, "the file holds no faces (lines that start with f)");
  return contents;
}

/// Gives each pair of vertex and normal that occurs a vertex of its own, so that an edge between
/// two normals stays sharp. False, and the mesh unusable, if a corner has no normal of a length.
bool use_file_normals(const tinyobj::attrib_t& attributes,
                      const std::vector<tinyobj::index_t>& corners, Mesh& mesh) {
  std::map<std::pair<int, int>, std::int32_t> pairs;
  Mesh split;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [v, n] = std::pair(corners[i].vertex_index, corners[i].normal_index);
    if (n < 0) return false;
    const auto [entry, is_new] =
        pairs.emplace(std::pair(v, n), std::int32_t(split.vertices.size()));
    if (is_new) {
      const double* from = &attributes.normals[3 * std::size_t(n)];
      const Vector normal = glm::normalize(Vector(from[0], from[1], from[2]));
      if (!std::isfinite(normal.x + normal.y + normal.z)) return false;
      split.vertices.push_back(mesh.vertices[std::size_t(v)]);
      split.normals.push_back(normal);
    }
    if (i % 3 == 0) split.triangles.push_back({});
    split.triangles.back()[i % 3] = entry->second;
  }
  mesh = std::move(split);
  return true;
}

}  // namespace

Mesh read_obj(const std::filesystem::path& file, bool smooth, std::size_t most_triangles) {
  std::string text;
  try {
    text = read_limited(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(": ") + error.what());
  }
  Contents contents = check(text, most_triangles);

  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(std::move(text));
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream))
    throw std::runtime_error(": " + error);
  if (attributes.vertices.size() != 3 * contents.vertices.size())
    throw std::runtime_error(": cannot be read as OBJ");

  Mesh mesh;
  mesh.vertices = std::move(contents.vertices);
  std::vector<tinyobj::index_t> corners;
  for (const tinyobj::shape_t& shape : shapes)
    corners.insert(corners.end(), shape.mesh.indices.begin(), shape.mesh.indices.end());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    mesh.triangles.push_back(
        {corners[i].vertex_index, corners[i + 1].vertex_index, corners[i + 2].vertex_index});
  if (mesh.triangles.size() != contents.triangles)
    throw std::runtime_error(": holds a polygon that cannot be cut into triangles");
  if (smooth && !use_file_normals(attributes, corners, mesh)) smooth_normals(mesh);
  return mesh;
}

}  // namespace litmus

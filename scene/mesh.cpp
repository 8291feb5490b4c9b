// mesh.cpp: triangle meshes made by formula.
#include "scene/mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <unordered_map>

namespace litmus {
namespace {

/// The unit icosahedron: vertices at the cyclic permutations of (0, +-1, +-phi).
Mesh icosahedron() {
  const double t = std::numbers::phi;
  Mesh mesh;
  mesh.vertices = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                   {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  for (Point& vertex : mesh.vertices) vertex = glm::normalize(vertex);
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// Cuts each triangle of a unit sphere into four.
void subdivide(Mesh& mesh) {
  std::unordered_map<std::uint64_t, std::int32_t> middles;
  const auto middle = [&](std::int32_t a, std::int32_t b) {
    const std::uint64_t edge = std::uint64_t(std::min(a, b)) << 32 | std::uint32_t(std::max(a, b));
    const auto [entry, is_new] = middles.emplace(edge, std::int32_t(mesh.vertices.size()));
    if (is_new)
      mesh.vertices.push_back(
          glm::normalize(mesh.vertices[std::size_t(a)] + mesh.vertices[std::size_t(b)]));
    return entry->second;
  };
  decltype(mesh.triangles) finer;
  finer.reserve(mesh.triangles.size() * 4);
  for (const auto [a, b, c] : mesh.triangles) {
    const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(finer);
}

/// Cosine and sine of 2 pi i / n, rounded from long double so that they do not vary with the C
/// library's double routines, which differ by processor: a scene's fingerprint includes its
/// vertices.
std::pair<double, double> circle(int i, int n) {
  const long double angle = 2 * std::numbers::pi_v<long double> * i / n;
  return {double(std::cos(angle)), double(std::sin(angle))};
}

}  // namespace

Mesh icosphere(Point center, double radius, int level, bool smooth) {
  Mesh mesh = icosahedron();
  for (int i = 0; i < level; ++i) subdivide(mesh);
  if (smooth) mesh.normals = mesh.vertices;
  for (Point& vertex : mesh.vertices) vertex = center + radius * vertex;
  return mesh;
}

Mesh torus(Point center, Vector axis, double major, double minor, int segments, int sides,
           bool smooth) {
  // p, q, w: right-handed, w along the axis, p across the axis's smallest component.
  const Vector w = glm::normalize(axis);
  const Vector size = glm::abs(w);
  const int smallest = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  Vector helper(0);
  helper[smallest] = 1;
  const Vector p = glm::normalize(glm::cross(helper, w)), q = glm::cross(w, p);
  Mesh mesh;
  for (int i = 0; i < segments; ++i) {
    const auto [cos_a, sin_a] = circle(i, segments);
    const Vector outward = cos_a * p + sin_a * q;
    for (int j = 0; j < sides; ++j) {
      const auto [cos_b, sin_b] = circle(j, sides);
      const Vector normal = cos_b * outward + sin_b * w;
      mesh.vertices.push_back(center + major * outward + minor * normal);
      if (smooth) mesh.normals.push_back(glm::normalize(normal));
      const int next_i = (i + 1) % segments, next_j = (j + 1) % sides;
      const std::int32_t a = i * sides + j, b = next_i * sides + j, c = next_i * sides + next_j,
                         d = i * sides + next_j;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

Mesh grid(Point origin, Vector u, Vector v, int columns, int rows, bool smooth) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      mesh.vertices.push_back(origin + (double(i) / columns) * u + (double(j) / rows) * v);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::int32_t a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  if (smooth)
    mesh.normals.assign(mesh.vertices.size(),
                        glm::normalize(glm::cross(glm::normalize(u), glm::normalize(v))));
  return mesh;
}

void smooth_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.vertices.size(), Vector(0));
  for (const auto [a, b, c] : mesh.triangles) {
    const Point& corner = mesh.vertices[std::size_t(a)];
    const Point &second = mesh.vertices[std::size_t(b)], &third = mesh.vertices[std::size_t(c)];
    if (degenerate(corner, second, third)) continue;
    // The cross product's length is twice the area: the weight.
    const Vector weighted = glm::cross(second - corner, third - corner);
    for (const std::int32_t vertex : {a, b, c}) mesh.normals[std::size_t(vertex)] += weighted;
  }
  for (Vector& normal : mesh.normals) {
    const double length = glm::length(normal);
    normal = length > 0 && std::isfinite(length) ? normal / length : Vector(0, 0, 1);
  }
}

bool degenerate(const Point& a, const Point& b, const Point& c) {
  const Vector cross = glm::cross(b - a, c - a);
  const double sum = std::abs(cross.x) + std::abs(cross.y) + std::abs(cross.z);
  return !(sum > 0 && std::isfinite(sum));
}

std::int64_t drop_degenerate(Mesh& mesh) {
  return std::int64_t(std::erase_if(mesh.triangles, [&](const std::array<std::int32_t, 3>& t) {
    return degenerate(mesh.vertices[std::size_t(t[0])], mesh.vertices[std::size_t(t[1])],
                      mesh.vertices[std::size_t(t[2])]);
  }));
}

}  // namespace litmus

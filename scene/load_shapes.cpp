// load_shapes.cpp: one [[object]]'s shape, with the mesh it generates or reads from an OBJ file.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "scene/load_parts.h"
#include "scene/mesh.h"

namespace litmus {
namespace {

constexpr int kFinestLevel = 7;  // 327,680 triangles

using Shape = decltype(Object::shape);

Sphere read_sphere(const Fields& fields) {
  return {fields.point("center"), fields.number("radius", kPositive)};
}

Plane read_plane(const Fields& fields) {
  return {fields.point("point"), fields.direction("normal")};
}

Box read_box(const Fields& fields) {
  const Box box{fields.point("min"), fields.point("max")};
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.min[axis] < box.max[axis]))
      fields.refuse("max",
                    fmt::format("must be greater than min on every axis; {} is not ({} <= {})",
                                "xyz"[axis], box.max[axis], box.min[axis]));
  return box;
}

Triangle read_triangle(const Fields& fields, std::int64_t& dropped) {
  const Triangle triangle{fields.point("a"), fields.point("b"), fields.point("c")};
  if (degenerate(triangle.a, triangle.b, triangle.c)) ++dropped;
  return triangle;
}

/// Refuses at the key that asks for more triangles than the scene has room for.
void check_room(const Fields& fields, std::string_view key, std::int64_t triangles,
                std::int64_t room) {
  if (triangles > room)
    fields.refuse(key, fmt::format("{} triangles, where a scene may hold {} primitives ({} left)",
                                   triangles, kMostPrimitives, room));
}

Mesh read_generated(const Fields& fields, std::int64_t room, bool smooth) {
  enum class Generator { Icosphere, Torus, Grid };
  const int most = int(kMostPrimitives);
  switch (fields.choice<Generator>("generator", {{"icosphere", Generator::Icosphere},
                                                 {"torus", Generator::Torus},
                                                 {"grid", Generator::Grid}})) {
    case Generator::Icosphere: {
      fields.only({"name", "shape", "material", "camera_visible", "generator", "smooth", "center",
                   "radius", "level"});
      const Point center = fields.point("center");
      const double radius = fields.number("radius", kPositive);
      const int level = fields.integer("level", 0, kFinestLevel);
      check_room(fields, "level", 20LL << (2 * level), room);
      return icosphere(center, radius, level, smooth);
    }
    case Generator::Torus: {
      fields.only({"name", "shape", "material", "camera_visible", "generator", "smooth", "center",
                   "axis", "major", "minor", "segments", "sides"});
      const Point center = fields.point("center");
      const Vector axis = fields.direction("axis");
      const double major = fields.number("major", kPositive);
      const double minor =
          fields.number("minor", {0, false, "a number > 0 and < major", major, false});
      const int segments = fields.integer("segments", 3, most);
      const int sides = fields.integer("sides", 3, most);
      check_room(fields, "segments", 2LL * segments * sides, room);
      return torus(center, axis, major, minor, segments, sides, smooth);
    }
    case Generator::Grid:
      break;
  }
  fields.only({"name", "shape", "material", "camera_visible", "generator", "smooth", "origin", "u",
               "v", "columns", "rows"});
  const Point origin = fields.point("origin");
  const Vector u = fields.direction("u"), v = fields.direction("v");
  if (nearly_parallel(u, v)) fields.refuse("v", "must not be parallel to u");
  const int columns = fields.integer("columns", 1, most), rows = fields.integer("rows", 1, most);
  check_room(fields, "columns", 2LL * columns * rows, room);
  return grid(origin, u, v, columns, rows, smooth);
}

Mesh read_mesh_file(const Fields& fields, std::int64_t room, bool smooth) {
  fields.only({"name", "shape", "material", "camera_visible", "generator", "file", "smooth",
               "scale", "translate"});
  if (!fields.has("file"))
    fields.refuse_missing("generator",
                          "\"icosphere\", \"torus\" or \"grid\", or else file = \"x.obj\"");
  const std::string name = fields.text("file");
  const double scale = fields.number("scale", kPositive, 1);
  const Vector translate = fields.point("translate", Point(0));
  Mesh mesh;
  try {
    mesh = read_obj(fields.file().parent_path() / name, smooth, std::size_t(room));
  } catch (const std::runtime_error& error) {
    fields.refuse("file", fmt::format("{}{}", name, error.what()));
  }
  for (Point& vertex : mesh.vertices) {
    vertex = vertex * scale + translate;
    if (!std::isfinite(vertex.x + vertex.y + vertex.z))
      fields.refuse("scale", "moves a vertex out of the range of double precision");
  }
  return mesh;
}

Mesh read_mesh(const Fields& fields, std::int64_t room, std::int64_t& dropped) {
  if (fields.has("generator") && fields.has("file"))
    fields.refuse("file", "a mesh has either a generator or a file, not both");
  const bool smooth = fields.boolean("smooth", false);
  Mesh mesh = fields.has("generator") ? read_generated(fields, room, smooth)
                                      : read_mesh_file(fields, room, smooth);
  dropped += drop_degenerate(mesh);
  return mesh;
}

}  // namespace

std::int64_t primitives(const Object& object) {
  const auto* mesh = std::get_if<Mesh>(&object.shape);
  return mesh ? std::int64_t(mesh->triangles.size()) : 1;
}

Shape read_shape(const Fields& fields, std::int64_t room, std::int64_t& dropped) {
  enum class Kind { Sphere, Plane, Box, Triangle, Mesh };
  const Kind kind = fields.choice<Kind>("shape", {{"sphere", Kind::Sphere},
                                                  {"plane", Kind::Plane},
                                                  {"box", Kind::Box},
                                                  {"triangle", Kind::Triangle},
                                                  {"mesh", Kind::Mesh}});
  check_room(fields, "shape", 1, room);
  switch (kind) {
    case Kind::Sphere:
      fields.only({"name", "shape", "material", "camera_visible", "center", "radius"});
      return read_sphere(fields);
    case Kind::Plane:
      fields.only({"name", "shape", "material", "camera_visible", "point", "normal"});
      return read_plane(fields);
    case Kind::Box:
      fields.only({"name", "shape", "material", "camera_visible", "min", "max"});
      return read_box(fields);
    case Kind::Triangle:
      fields.only({"name", "shape", "material", "camera_visible", "a", "b", "c"});
      return read_triangle(fields, dropped);
    case Kind::Mesh:
      break;
  }
  return read_mesh(fields, room, dropped);
}

}  // namespace litmus

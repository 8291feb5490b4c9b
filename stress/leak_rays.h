// leak_rays.h: closed meshes and rays from their inside at shared edges and vertices. Random rays
// find no gap in any mesh; these are aimed at where a gap would be.
//
// Compiled twice, see leaks_contracted.cpp: nothing here may be shared between the two.
#pragma once

#include <array>

#include "stress/naive.h"
#include "stress/random.h"

namespace litmus {

inline constexpr int kRaysPerMesh = 64;

/// A stretched icosahedron.
template <Real R>
struct ClosedMesh {
  std::array<Vec<R>, 12> vertices;
  std::array<std::array<Vec<R>, 3>, 20> triangles;
  Vec<R> center;
};

/// The corners of each triangle of an icosahedron.
inline constexpr int kCorners[20][3] = {
    {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};

/// At the origin or `offset` away from it, 10 to 1000 units large.
template <Real R>
ClosedMesh<R> closed_mesh(Draw& draw, double offset) {
  constexpr double kGolden = std::numbers::phi;
  const double base[12][3] = {{-1, kGolden, 0},  {1, kGolden, 0},   {-1, -kGolden, 0},
                              {1, -kGolden, 0},  {0, -1, kGolden},  {0, 1, kGolden},
                              {0, -1, -kGolden}, {0, 1, -kGolden},  {kGolden, 0, -1},
                              {kGolden, 0, 1},   {-kGolden, 0, -1}, {-kGolden, 0, 1}};
  const double size = draw.decades(10, 1000);
  const Vec<double> x = draw.direction(), y = draw.across(x), z = cross(x, y),
                    away = offset * draw.direction();
  const double sx = size, sy = size * draw.decades(0.1, 1), sz = size * draw.decades(0.1, 1);
  ClosedMesh<R> mesh;
  const auto rounded = [](const Vec<double>& v) { return Vec<R>{R(v.x), R(v.y), R(v.z)}; };
  for (int i = 0; i < 12; ++i) {
    mesh.vertices[std::size_t(i)] =
        rounded(away + (sx * base[i][0]) * x + (sy * base[i][1]) * y + (sz * base[i][2]) * z);
  }
  for (std::size_t i = 0; i < 20; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      mesh.triangles[i][k] = mesh.vertices[std::size_t(kCorners[i][k])];
  }
  mesh.center = rounded(away);
  return mesh;
}

/// A ray from near the centre at a vertex (a third of them) or at a point of an edge.
template <Real R>
Ray<R> aimed_ray(Draw& draw, const ClosedMesh<R>& mesh) {
  const auto& corners = kCorners[draw.below(20)];
  const Vec<R>& a = mesh.vertices[std::size_t(corners[0])];
  const Vec<R>& b = mesh.vertices[std::size_t(corners[1])];
  const R along = draw.below(3) == 0 ? R(0) : R(draw.uniform());
  const R off = R(draw.uniform(0, 0.3));
  const Vec<R> origin =
      mesh.center + off * (mesh.vertices[std::size_t(draw.below(12))] - mesh.center);
  return {origin, (1 - along) * a + along * b - origin};
}

template <Real R>
bool leaks_moeller_trumbore(const ClosedMesh<R>& mesh, const Ray<R>& ray) {
  for (const auto& triangle : mesh.triangles)
    if (naive::moeller_trumbore(triangle, ray) > 0) return false;
  return true;
}

template <Real R>
bool leaks_watertight(const ClosedMesh<R>& mesh, const Ray<R>& ray) {
  const ShearedRay<R> sheared(ray.direction);
  for (const auto& triangle : mesh.triangles)
    if (intersect(triangle, ray, sheared).t > 0) return false;
  return true;
}

}  // namespace litmus

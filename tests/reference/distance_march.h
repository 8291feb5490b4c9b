// distance_march.h: what a ray meets, found without any intersection formula: by steps as long as
// the distance from the nearest surface (Hart, Sphere tracing, The Visual Computer 12, 1996).
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "reference/closed_form_light.h"
#include "scene/overload.h"
#include "scene/scene.h"

namespace litmus {

inline Exact segment_distance(const ExactVec& p, const ExactVec& a, const ExactVec& b) {
  const ExactVec way = b - a;
  const Exact t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), Exact(0), Exact(1));
  return glm::distance(p, a + t * way);
}

inline Exact triangle_distance(const ExactVec& p, const ExactVec& a, const ExactVec& b,
                               const ExactVec& c) {
  const ExactVec n = glm::cross(b - a, c - a);
  const Exact u = glm::dot(glm::cross(b - a, p - a), n), v = glm::dot(glm::cross(c - b, p - b), n),
              w = glm::dot(glm::cross(a - c, p - c), n);
  if (u >= 0 && v >= 0 && w >= 0) return std::fabs(glm::dot(p - a, n)) / glm::length(n);
  return std::min(
      {segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
}

/// An object with a ball around it; only meshes have one.
struct Solid {
  const Object* object = nullptr;
  ExactVec middle{0};
  Exact radius = 0;
};

inline Solid solid_of(const Object& object) {
  Solid solid{&object};
  const auto* mesh = std::get_if<Mesh>(&object.shape);
  if (!mesh) return solid;
  for (const Point& v : mesh->vertices) solid.middle += ExactVec(v) / Exact(mesh->vertices.size());
  for (const Point& v : mesh->vertices)
    solid.radius = std::max(solid.radius, glm::distance(solid.middle, ExactVec(v)));
  return solid;
}

/// From the surface, inside or outside; far from a mesh at least from the ball around it.
inline Exact distance_from(const Solid& solid, const ExactVec& p) {
  const Exact ball = glm::distance(p, solid.middle) - solid.radius;
  if (solid.radius > 0 && ball > solid.radius / 4) return ball;
  return std::visit(
      Overload{[&](const Sphere& s) {
                 return std::fabs(glm::distance(p, ExactVec(s.center)) - Exact(s.radius));
               },
               [&](const Plane& plane) {
                 return std::fabs(
                     glm::dot(p - ExactVec(plane.point), glm::normalize(ExactVec(plane.normal))));
               },
               [&](const Box& box) {
                 const ExactVec middle = (ExactVec(box.min) + ExactVec(box.max)) * Exact(0.5);
                 const ExactVec out = glm::abs(p - middle) - (ExactVec(box.max) - middle);
                 const Exact most = std::max({out.x, out.y, out.z});
                 return most <= 0 ? -most : glm::length(glm::max(out, ExactVec(0)));
               },
               [&](const Triangle& t) {
                 return triangle_distance(p, ExactVec(t.a), ExactVec(t.b), ExactVec(t.c));
               },
               [&](const Mesh& mesh) {
                 Exact least = std::numeric_limits<Exact>::infinity();
                 for (const auto& [i, j, k] : mesh.triangles)
                   least =
                       std::min(least, triangle_distance(p, ExactVec(mesh.vertices[std::size_t(i)]),
                                                         ExactVec(mesh.vertices[std::size_t(j)]),
                                                         ExactVec(mesh.vertices[std::size_t(k)])));
                 return least;
               }},
      solid.object->shape);
}

/// The normal as the direction in which the distance from the surface grows, found a few steps off
/// it: towards the eye, and then along the normal itself.
inline ExactVec normal_at(const Solid& solid, const ExactVec& at, const ExactVec& eye, Exact step) {
  ExactVec normal = eye;
  for (int round = 0; round < 3; ++round) {
    const ExactVec out = at + normal * (4 * step);
    ExactVec slope(0);
    for (int axis = 0; axis < 3; ++axis) {
      ExactVec more = out, less = out;
      more[axis] += step, less[axis] -= step;
      slope[axis] = distance_from(solid, more) - distance_from(solid, less);
    }
    normal = glm::normalize(slope);
  }
  return normal;
}

/// Where a walk ended.
struct Marched {
  enum class End { Clear, Met, Undecided } end = End::Undecided;
  const Solid* solid = nullptr;  ///< that was met
  Exact far = 0;                 ///< from the start
};

/// From `start` along the unit vector for `length` units past the solids. One that the way comes
/// nearer to than `near`, without coming to within a millionth of that, leaves it undecided.
inline Marched march(const std::vector<const Solid*>& solids, const ExactVec& start,
                     const ExactVec& along, Exact length, Exact near) {
  Exact far = 0, nearest_ever = std::numeric_limits<Exact>::infinity();
  for (int step = 0; step < 20000; ++step) {
    if (far >= length) break;
    Exact least = std::numeric_limits<Exact>::infinity();
    const Solid* nearest = nullptr;
    for (const Solid* solid : solids)
      if (const Exact d = distance_from(*solid, start + far * along); d < least)
        least = d, nearest = solid;
    if (!nearest) return {Marched::End::Clear, nullptr, length};
    nearest_ever = std::min(nearest_ever, least);
    if (least < 1e-6L * near) return {Marched::End::Met, nearest, far};
    far += least;
  }
  if (far < length || nearest_ever < near) return {};
  return {Marched::End::Clear, nullptr, length};
}

}  // namespace litmus

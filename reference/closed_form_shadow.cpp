// closed_form_shadow.cpp: one inequality for each shape.
#include "reference/closed_form_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/overload.h"

namespace litmus {
namespace {

constexpr Exact kBand = kBoundaryBand;

ExactVec step(const Passage& passage) {
  return passage.sun ? passage.to : passage.to - passage.from;
}

Way decide(Exact margin) {
  return margin > kBand ? Way::Blocked : margin < -kBand ? Way::Open : Way::Unsure;
}

Way by_sphere_to_sun(const ExactVec& centre, Exact radius, const Passage& passage) {
  const ExactVec apart = centre - passage.from;
  const Exact along = glm::dot(apart, passage.to);
  if (along < 0) return Way::Open;
  // The distance from the sphere's axis is that of a point from a line.
  return decide(1 - glm::length(glm::cross(apart, passage.to)) / radius);
}

Way by_sphere(const Sphere& sphere, const Passage& passage) {
  const ExactVec centre(sphere.center);
  const Exact radius = sphere.radius;
  const Exact out = glm::length(passage.from - centre) / radius - 1;
  if (std::fabs(out) < kBand) return Way::Unsure;
  if (passage.sun) return out < 0 ? Way::Blocked : by_sphere_to_sun(centre, radius, passage);
  const ExactVec apart = centre - passage.to;
  const Exact far = glm::length(apart);
  if (std::fabs(far / radius - 1) < kBand) return Way::Unsure;
  if ((out < 0) != (far < radius)) return Way::Blocked;
  if (out < 0) return Way::Open;
  const ExactVec way = passage.from - passage.to;
  const Exact length = glm::length(way), tangent = far * far - radius * radius;
  if (length * length <= tangent) return Way::Open;  // before the sphere, or beside it
  return decide(glm::dot(way, apart) / (length * far) - std::sqrt(tangent) / far);
}

Way by_plane(const Plane& plane, const Passage& passage) {
  const ExactVec n = glm::normalize(ExactVec(plane.normal)), point(plane.point);
  const Exact begin = glm::dot(passage.from - point, n), rise = glm::dot(step(passage), n);
  const Exact end = passage.sun ? rise * std::numeric_limits<Exact>::infinity() : begin + rise;
  if (rise == 0 || std::fabs(begin) < kBand * std::fabs(rise)) return Way::Open;
  return begin * end < 0 ? Way::Blocked : Way::Open;
}

Way by_box(const Box& box, const Passage& passage) {
  const ExactVec d = step(passage);
  Exact low = 0, high = passage.sun ? std::numeric_limits<Exact>::infinity() : Exact(1);
  bool along_a_face = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Exact below = Exact(box.min[axis]) - passage.from[axis];
    const Exact above = Exact(box.max[axis]) - passage.from[axis];
    if (d[axis] == 0) {
      const Way beside = decide(std::min(-below, above) / (above - below));
      if (beside == Way::Open) return beside;
      along_a_face |= beside == Way::Unsure;
      continue;
    }
    low = std::max(low, std::min(below / d[axis], above / d[axis]));
    high = std::min(high, std::max(below / d[axis], above / d[axis]));
  }
  if (low == 0 && high < kBand) return Way::Open;  // begins on a face and leaves the box
  const Exact scale = std::isinf(high) ? low : std::max(std::fabs(low), std::fabs(high));
  const Way way = decide(std::isinf(high) ? 1 : scale > 0 ? (high - low) / scale : -1);
  return way == Way::Blocked && along_a_face ? Way::Unsure : way;
}

Exact volume(const ExactVec& a, const ExactVec& b, const ExactVec& c) {
  return glm::dot(glm::cross(a, b), c);
}

Way by_triangle(const Point& p, const Point& q, const Point& r, const Passage& passage) {
  const ExactVec d = step(passage);
  const ExactVec a = ExactVec(p) - passage.from, b = ExactVec(q) - passage.from,
                 c = ExactVec(r) - passage.from;
  const Exact u = volume(b, c, d), v = volume(c, a, d), w = volume(a, b, d);
  const Exact total = u + v + w;
  const Exact size = std::fabs(u) + std::fabs(v) + std::fabs(w);
  if (size == 0 || total == 0) return Way::Open;  // the way lies in the triangle's plane
  const Exact inside = std::min({u / total, v / total, w / total});
  if (inside < -kBand) return Way::Open;
  const Exact t = volume(a, b, c) / total;
  const Exact end = passage.sun ? std::numeric_limits<Exact>::infinity() : Exact(1);
  if (t < kBand || t > end - kBand) return Way::Open;
  return decide(inside);
}

/// The box around all vertices, a little larger.
Box bounds_of(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Point& vertex : mesh.vertices)
    box = {glm::min(box.min, vertex), glm::max(box.max, vertex)};
  const Vector margin = 1e-6 * (box.max - box.min + glm::length(box.max - box.min));
  return {box.min - margin, box.max + margin};
}

Way by_mesh(const Mesh& mesh, const Passage& passage) {
  if (by_box(bounds_of(mesh), passage) == Way::Open) return Way::Open;
  bool unsure = false;
  for (const auto& [i, j, k] : mesh.triangles) {
    const auto at = [&](std::int32_t index) { return mesh.vertices[std::size_t(index)]; };
    const Way way = by_triangle(at(i), at(j), at(k), passage);
    if (way == Way::Blocked) return way;
    unsure |= way == Way::Unsure;
  }
  return unsure ? Way::Unsure : Way::Open;
}

}  // namespace

Way passage_by(const Object& object, const Passage& passage) {
  return std::visit(Overload{[&](const Sphere& sphere) { return by_sphere(sphere, passage); },
                             [&](const Plane& plane) { return by_plane(plane, passage); },
                             [&](const Box& box) { return by_box(box, passage); },
                             [&](const Triangle& t) { return by_triangle(t.a, t.b, t.c, passage); },
                             [&](const Mesh& mesh) { return by_mesh(mesh, passage); }},
                    object.shape);
}

Way passage_through(const Scene& scene, const Passage& passage, const Object* skipped,
                    bool seen_only) {
  bool unsure = false;
  for (const Object& object : scene.objects) {
    if (&object == skipped || (seen_only && !object.camera_visible)) continue;
    const Way way = passage_by(object, passage);
    if (way == Way::Blocked) return way;
    unsure |= way == Way::Unsure;
  }
  return unsure ? Way::Unsure : Way::Open;
}

}  // namespace litmus

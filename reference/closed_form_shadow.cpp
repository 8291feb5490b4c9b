// closed_form_shadow.cpp: one inequality for each shape.
#include "reference/closed_form_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <type_traits>

#include "scene/overload.h"

namespace litmus {
namespace {

/// In double, which asks the extended precision wherever it is not sure, a wide band stands for
/// all that rounding may move.
template <class T>
constexpr T kBand = std::is_same_v<T, double> ? T(1e-7) : T(kBoundaryBand);

template <class T>
using Vec = glm::vec<3, T>;

template <class T>
constexpr T kNoEnd = std::numeric_limits<T>::infinity();

template <class T>
struct WayOf {
  Vec<T> from{0}, to{0}, step{0};
  bool sun = false;
};

template <class T>
WayOf<T> way_of(const Passage& passage) {
  WayOf<T> way{Vec<T>(passage.from), Vec<T>(passage.to), {}, passage.sun};
  way.step = way.sun ? way.to : way.to - way.from;
  return way;
}

template <class T>
Way decide(T margin) {
  return margin > kBand<T> ? Way::Blocked : margin < -kBand<T> ? Way::Open : Way::Unsure;
}

/// Outside, inside or on the sphere: positive, negative or within the band of 0.
template <class T>
T beyond(const Vec<T>& apart, T radius) {
  return (glm::dot(apart, apart) / (radius * radius) - 1) / 2;
}

/// 1 - distance / radius of the centre from the line, near 0.
template <class T>
Way by_sphere(const Sphere& sphere, const WayOf<T>& way) {
  const T radius = T(sphere.radius);
  const Vec<T> apart = Vec<T>(sphere.center) - way.from;
  const T out = beyond(apart, radius);
  if (std::fabs(out) < kBand<T>) return Way::Unsure;
  const T along = glm::dot(apart, way.step), length2 = glm::dot(way.step, way.step);
  if (way.sun) {
    if (out < 0) return Way::Blocked;
    if (along < 0) return Way::Open;
  } else {
    const T end = beyond(Vec<T>(sphere.center) - way.to, radius);
    if (std::fabs(end) < kBand<T>) return Way::Unsure;
    if ((out < 0) != (end < 0)) return Way::Blocked;
    // Between two points outside, the way is nearest to the centre at an end or where it passes.
    if (out < 0 || along <= 0 || along >= length2) return Way::Open;
  }
  const Vec<T> aside = glm::cross(apart, way.step);
  return decide((1 - glm::dot(aside, aside) / (radius * radius * length2)) / 2);
}

template <class T>
Way by_plane(const Plane& plane, const WayOf<T>& way) {
  const Vec<T> n(plane.normal);
  const T begin = glm::dot(way.from - Vec<T>(plane.point), n), rise = glm::dot(way.step, n);
  const bool begins_on_it = std::fabs(begin) < kBand<T> * std::fabs(rise);
  if constexpr (std::is_same_v<T, double>)
    if (begins_on_it || std::fabs(begin + rise) < kBand<T> * std::fabs(rise)) return Way::Unsure;
  const T end = way.sun ? rise * kNoEnd<T> : begin + rise;
  if (rise == 0 || begins_on_it) return Way::Open;
  return begin * end < 0 ? Way::Blocked : Way::Open;
}

template <class T>
T largest(const Vec<T>& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

template <class T>
Way by_box(const Box& box, const WayOf<T>& way) {
  const Vec<T>& d = way.step;
  T low = 0, high = way.sun ? kNoEnd<T> : T(1);
  bool along_a_face = false;
  for (int axis = 0; axis < 3; ++axis) {
    const T below = T(box.min[axis]) - way.from[axis];
    const T above = T(box.max[axis]) - way.from[axis];
    if (d[axis] == 0) {
      const Way beside = decide(std::min(-below, above) / (above - below));
      if (beside == Way::Open) return beside;
      along_a_face |= beside == Way::Unsure;
      continue;
    }
    low = std::max(low, std::min(below / d[axis], above / d[axis]));
    high = std::min(high, std::max(below / d[axis], above / d[axis]));
  }
  const bool in_double = std::is_same_v<T, double>;
  if (low == 0 && high < kBand<T>)  // begins on a face and leaves the box
    return in_double && high > -kBand<T> ? Way::Unsure : Way::Open;
  const T scale = std::isinf(high) ? low : std::max(std::fabs(low), std::fabs(high));
  // So near that rounding of the point itself counts.
  if (in_double && scale * largest(d) < kBand<T> * largest(way.from)) return Way::Unsure;
  const Way answer = decide(std::isinf(high) ? T(1) : scale > 0 ? (high - low) / scale : T(-1));
  return answer == Way::Blocked && along_a_face ? Way::Unsure : answer;
}

template <class T>
T volume(const Vec<T>& a, const Vec<T>& b, const Vec<T>& c) {
  return glm::dot(glm::cross(a, b), c);
}

template <class T>
Way by_triangle(const Point& p, const Point& q, const Point& r, const WayOf<T>& way) {
  const Vec<T> a = Vec<T>(p) - way.from, b = Vec<T>(q) - way.from, c = Vec<T>(r) - way.from;
  const T u = volume(b, c, way.step), v = volume(c, a, way.step), w = volume(a, b, way.step);
  const T total = u + v + w, size = std::fabs(u) + std::fabs(v) + std::fabs(w);
  if constexpr (std::is_same_v<T, double>) {
    // What rounding makes of each volume, against their sum.
    const T far = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
    if (std::fabs(total) < 1e-6 * far * glm::length(way.step)) return Way::Unsure;
  } else if (size == 0 || total == 0) {
    return Way::Open;  // the way lies in the triangle's plane
  }
  const T inside = std::min({u / total, v / total, w / total});
  if (inside < -kBand<T>) return Way::Open;
  const T t = volume(a, b, c) / total, end = way.sun ? kNoEnd<T> : T(1);
  const bool at_an_end = std::fabs(t) < kBand<T> || std::fabs(t - end) < kBand<T>;
  if (std::is_same_v<T, double> && at_an_end) return Way::Unsure;
  if (t < kBand<T> || t > end - kBand<T>) return Way::Open;
  return decide(inside);
}

using Facets = std::span<const std::int32_t>;

/// Of the triangles in question: a single one that holds the way is enough.
template <class T>
Way by_facets(const Mesh& mesh, Facets indices, const WayOf<T>& way) {
  bool unsure = false;
  for (const auto index : indices) {
    const auto& [i, j, k] = mesh.triangles[std::size_t(index)];
    const Way answer = by_triangle(mesh.vertices[std::size_t(i)], mesh.vertices[std::size_t(j)],
                                   mesh.vertices[std::size_t(k)], way);
    if (answer == Way::Blocked) return answer;
    unsure |= answer == Way::Unsure;
  }
  return unsure ? Way::Unsure : Way::Open;
}

/// `facets` are the triangles to ask, of a mesh.
template <class T>
Way by_object(const Object& object, Facets facets, const WayOf<T>& way) {
  return std::visit(Overload{[&](const Sphere& sphere) { return by_sphere(sphere, way); },
                             [&](const Plane& plane) { return by_plane(plane, way); },
                             [&](const Box& box) { return by_box(box, way); },
                             [&](const Triangle& t) { return by_triangle(t.a, t.b, t.c, way); },
                             [&](const Mesh& mesh) { return by_facets(mesh, facets, way); }},
                    object.shape);
}

/// Coordinates up to which double precision is a hundred times finer than its band.
double reach_of(const Object& object) {
  const auto size = [](const glm::dvec3& low, const glm::dvec3& high) {
    return largest<double>(high - low);
  };
  return std::visit(
      Overload{[&](const Sphere& sphere) { return 1e7 * sphere.radius; },
               [&](const Plane&) { return kNoEnd<double>; },
               [&](const Box& box) {
                 const glm::dvec3 sides = box.max - box.min;
                 return 1e7 * std::min({sides.x, sides.y, sides.z});
               },
               [&](const Triangle& t) { return 1e4 * std::max(size(t.a, t.b), size(t.a, t.c)); },
               [&](const Mesh& mesh) {
                 glm::dvec3 low = mesh.vertices.front(), high = low;
                 for (const Point& v : mesh.vertices)
                   low = glm::min(low, v), high = glm::max(high, v);
                 return 1e3 * size(low, high);
               }},
      object.shape);
}

std::vector<std::int32_t> all_facets(const Object& object) {
  const auto* mesh = std::get_if<Mesh>(&object.shape);
  std::vector<std::int32_t> all(mesh ? mesh->triangles.size() : 0);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

Way passage_by(const Object& object, const Passage& passage) {
  return by_object(object, all_facets(object), way_of<Exact>(passage));
}

Obstacles obstacles(const Scene& scene, const PencilEnd& end, bool seen_only) {
  Obstacles all;
  for (const Object& object : scene.objects) {
    if (seen_only && !object.camera_visible) continue;
    Obstacles::One one{&object, reach_of(object)};
    if (!end.parallel && largest(end.to) > one.reach) one.reach = -1;
    if (const auto* mesh = std::get_if<Mesh>(&object.shape)) one.facets.emplace(*mesh, end);
    all.each.push_back(std::move(one));
  }
  return all;
}

Way passage_through(const Obstacles& obstacles, const Passage& passage, const Object* skipped) {
  const WayOf<double> rounded = way_of<double>(passage);
  const double size = std::max(largest(rounded.from), passage.sun ? 0 : largest(rounded.to));
  bool unsure = false;
  for (const Obstacles::One& one : obstacles.each) {
    if (one.object == skipped) continue;
    const Facets facets = one.facets ? one.facets->near(rounded.from) : Facets();
    Way way = size <= one.reach ? by_object(*one.object, facets, rounded) : Way::Unsure;
    if (way == Way::Unsure) way = by_object(*one.object, facets, way_of<Exact>(passage));
    if (way == Way::Blocked) return way;
    unsure |= way == Way::Unsure;
  }
  return unsure ? Way::Unsure : Way::Open;
}

}  // namespace litmus

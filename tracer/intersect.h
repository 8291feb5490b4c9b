// intersect.h: where a ray meets a sphere, a plane, a box or a triangle.
#pragma once

#include <array>
#include <utility>

#include "tracer/value.h"

namespace litmus {

/// origin + t * direction for t in (0, limit). The direction need not be unit.
template <Real R>
struct Ray {
  Vec<R> origin, direction;
  R limit = std::numeric_limits<R>::infinity();
};

template <Real R>
struct SphereSurface {
  Vec<R> center;
  R radius;
};
template <Real R>
struct PlaneSurface {
  Vec<R> point, normal;  ///< normal is unit
};
template <Real R>
struct BoxSurface {
  Vec<R> min, max;
};

/// The two parameters where a line enters and leaves; enter > leave if it misses.
template <Real R>
struct Chord {
  R enter = 1, leave = 0;
  int enter_face = 0, leave_face = 0;  ///< boxes: axis * 2 + (1 for the upper face)
};

/// Haines, Guenther and Akenine-Moeller 2019 (Ray Tracing Gems, chapter 7): the discriminant from
/// the distance of the centre to the ray, which does not cancel for a small far sphere. A tangent
/// is a hit.
template <Real R>
Chord<R> intersect(const SphereSurface<R>& sphere, const Ray<R>& ray) {
  using std::sqrt;
  const Vec<R> f = ray.origin - sphere.center;
  const R a = dot(ray.direction, ray.direction);
  const R b = -dot(f, ray.direction);
  const R nearest = direction_of(f + (b / a) * ray.direction).length;
  const R discriminant = (sphere.radius - nearest) * (sphere.radius + nearest);
  if (!(discriminant >= 0)) return {};
  const R root = sqrt(a * discriminant);
  const R q = b < 0 ? b - root : b + root;
  if (q == 0) return {R(0), R(0)};
  const R distance = direction_of(f).length;
  const R c = (distance - sphere.radius) * (distance + sphere.radius);
  const R t0 = c / q, t1 = q / a;
  return t0 < t1 ? Chord<R>{t0, t1} : Chord<R>{t1, t0};
}

/// The one parameter where a line crosses a plane; negative if it is parallel to it.
template <Real R>
R intersect(const PlaneSurface<R>& plane, const Ray<R>& ray) {
  const R slope = dot(plane.normal, ray.direction);
  if (slope == 0) return R(-1);
  return dot(plane.point - ray.origin, plane.normal) / slope;
}

/// Slabs. The comparisons are ordered so that 0 * infinity (a ray in the plane of a face) changes
/// nothing.
template <Real R>
Chord<R> intersect(const BoxSurface<R>& box, const Ray<R>& ray) {
  constexpr R kInfinity = std::numeric_limits<R>::infinity();
  Chord<R> chord{-kInfinity, kInfinity};
  for (int axis = 0; axis < 3; ++axis) {
    const R inverse = 1 / ray.direction[axis];
    R low = (box.min[axis] - ray.origin[axis]) * inverse;
    R high = (box.max[axis] - ray.origin[axis]) * inverse;
    int low_face = 2 * axis, high_face = 2 * axis + 1;
    if (inverse < 0) {
      std::swap(low, high);
      std::swap(low_face, high_face);
    }
    if (low > chord.enter) chord.enter = low, chord.enter_face = low_face;
    if (high < chord.leave) chord.leave = high, chord.leave_face = high_face;
  }
  return chord;
}

/// A ray in the coordinates of Woop, Benthin and Wald 2013 (Watertight Ray/Triangle Intersection):
/// the largest component of its direction becomes z, and shearing makes it the z axis.
template <Real R>
struct ShearedRay {
  int kx, ky, kz;
  R sx, sy, sz;

  explicit ShearedRay(const Vec<R>& d) {
    using std::fabs;
    const R x = fabs(d.x), y = fabs(d.y), z = fabs(d.z);
    kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    if (d[kz] < 0) std::swap(kx, ky);
    sx = d[kx] / d[kz], sy = d[ky] / d[kz], sz = 1 / d[kz];
  }
};

/// t and barycentric weights of a, b, c; t is negative if the line misses.
template <Real R>
struct TriangleHit {
  R t{-1}, u{}, v{}, w{};
};

/// Watertight: neighbours that share an edge compute the same edge function, so nothing passes
/// between them. The edge functions are differences of products with one rounding, which
/// contraction by a compiler cannot change.
template <Real R>
TriangleHit<R> intersect(const std::array<Vec<R>, 3>& triangle, const Ray<R>& ray,
                         const ShearedRay<R>& s) {
  // Move the triangle so that the ray starts at the origin and runs along z.
  const Vec<R> a = triangle[0] - ray.origin, b = triangle[1] - ray.origin,
               c = triangle[2] - ray.origin;
  const R ax = a[s.kx] - s.sx * a[s.kz], ay = a[s.ky] - s.sy * a[s.kz];
  const R bx = b[s.kx] - s.sx * b[s.kz], by = b[s.ky] - s.sy * b[s.kz];
  const R cx = c[s.kx] - s.sx * c[s.kz], cy = c[s.ky] - s.sy * c[s.kz];

  // Ask on which side of each edge the axis passes.
  const R u = difference_of_products(cx, by, cy, bx);
  const R v = difference_of_products(ax, cy, ay, cx);
  const R w = difference_of_products(bx, ay, by, ax);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
  const R total = u + v + w;
  if (total == 0) return {};

  const R t = (u * (s.sz * a[s.kz]) + v * (s.sz * b[s.kz]) + w * (s.sz * c[s.kz])) / total;
  return {t, u / total, v / total, w / total};
}

}  // namespace litmus

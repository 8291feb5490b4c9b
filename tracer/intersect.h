// intersect.h: where a ray meets a sphere, a plane, a box or a triangle.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "tracer/value.h"

namespace litmus {

/// origin + t * direction for t in (0, limit). The direction need not be unit.
template <Value V>
struct Ray {
  Vec<V> origin, direction;
  V limit = std::numeric_limits<Scalar<V>>::infinity();
};

/// One lane of a ray.
template <Value V>
Ray<Scalar<V>> lane(const Ray<V>& ray, int i) {
  return {{lane(ray.origin.x, i), lane(ray.origin.y, i), lane(ray.origin.z, i)},
          {lane(ray.direction.x, i), lane(ray.direction.y, i), lane(ray.direction.z, i)},
          lane(ray.limit, i)};
}

template <Real R>
struct SphereSurface {
  Vec<R> center;
  R radius;
};
template <Real R>
struct PlaneSurface {
  Vec<R> point, normal;  ///< normal is unit
};
/// A ball around something.
template <Real R>
struct Ball {
  Vec<R> center;
  R radius{};
};

template <Real R>
struct BoxSurface {
  Vec<R> min, max;
};

/// A box with the ball around it.
template <Real R>
struct BoundedBox : BoxSurface<R> {
  Ball<R> ball;
};

/// Less than any square that matters; more than what is lost where squares underflow.
template <Real R>
inline const R kTiny = SafeSquares<R>::kSmall;

/// The ball around the box between two corners, wider than the rounding of its centre.
template <Real R>
Ball<R> box_ball(const Vec<R>& min, const Vec<R>& max) {
  const Vec<R> half = R(0.5) * (max - min);
  const R rounding = gamma_bound<R>(8) * (max_abs(min) + max_abs(max));
  return {min + half, direction_of(half).length + rounding};
}

template <Real R>
Ball<R> ball_around(const SphereSurface<R>& sphere) {
  return {sphere.center, sphere.radius};
}
template <Real R>
const Ball<R>& ball_around(const BoundedBox<R>& box) {
  return box.ball;
}

/// Where a ray may meet what is in a ball. Cheaper than meeting it, and wider than any rounding: of
/// the surface's own test, too, for 64 roundings of the ball's distance are more than both take.
template <Value V>
Mask<V> may_meet(const Ball<Scalar<V>>& ball, const Ray<V>& ray) {
  using R = Scalar<V>;
  const Vec<V> f = ray.origin - Vec<V>(ball.center);
  const V squared = dot(f, f), along = dot(f, ray.direction);
  const V a = dot(ray.direction, ray.direction);
  const R rounding = R(64) * kUnit<R>;
  const V reach = rounding * squared + V(ball.radius * ball.radius + kTiny<R>);
  const Mask<V> beside = squared * a - along * along > reach * a;
  const Mask<V> behind = (along > R(0)) & (squared > reach);
  return !(beside | behind);
}

/// The two parameters where a line enters and leaves; enter > leave if it misses.
template <Value V>
struct Chord {
  V enter = Scalar<V>(1), leave = Scalar<V>(0);
  /// Boxes: axis * 2 + (1 for the upper face).
  Index<V> enter_face = 0, leave_face = 0;
};

/// A sphere whose square would over- or underflow, with its ray, at a power of two of their size.
template <Value V>
Chord<V> intersect_scaled(SphereSurface<Scalar<V>> sphere, Ray<V> ray);

/// Haines, Guenther and Akenine-Moeller 2019 (Ray Tracing Gems, chapter 7): the discriminant from
/// the distance of the centre to the ray, which does not cancel for a small far sphere. A tangent
/// is a hit.
template <Value V>
Chord<V> intersect(const SphereSurface<Scalar<V>>& sphere, const Ray<V>& ray) {
  using std::sqrt;
  using R = Scalar<V>;
  const R radius = sphere.radius;
  if (!(radius * radius > SafeSquares<R>::kSmall && radius * radius < SafeSquares<R>::kLarge)) {
    return intersect_scaled(sphere, ray);
  }
  const Vec<V> f = ray.origin - Vec<V>(sphere.center);
  const V b = -dot(f, ray.direction);
  const V a = dot(ray.direction, ray.direction);
  const V inverse = R(1) / a;
  const Vec<V> nearest = f + (b * inverse) * ray.direction;
  const V discriminant = radius * radius - dot(nearest, nearest);
  const Mask<V> hits = discriminant >= R(0);
  if (none_of(hits)) return {};
  const V root = sqrt(select(hits, V(a * discriminant), V(R(0))));
  const V q = select(b < R(0), V(b - root), V(b + root));
  const V distance = direction_of(f).length;
  const V c = (distance - radius) * (distance + radius);
  const V t0 = select(q == R(0), V(R(0)), V(c / q)), t1 = q * inverse;
  const Mask<V> ordered = t0 < t1;
  return {select(hits, select(ordered, t0, t1), V(R(1))),
          select(hits, select(ordered, t1, t0), V(R(0)))};
}

template <Value V>
LITMUS_COLD Chord<V> intersect_scaled(SphereSurface<Scalar<V>> sphere, Ray<V> ray) {
  using std::frexp, std::ldexp;
  using R = Scalar<V>;
  int exponent = 0;
  frexp(sphere.radius, &exponent);
  const R scale = ldexp(R(1), std::min(-exponent, std::numeric_limits<R>::max_exponent - 2));
  const Chord<V> chord = intersect(SphereSurface<R>{scale * sphere.center, scale * sphere.radius},
                                   Ray<V>{V(scale) * ray.origin, ray.direction});
  return {chord.enter / scale, chord.leave / scale};
}

/// The one parameter where a ray crosses a plane; negative if it does not.
template <Value V>
V intersect(const PlaneSurface<Scalar<V>>& plane, const Ray<V>& ray) {
  using R = Scalar<V>;
  const Vec<V> normal(plane.normal);
  const V slope = dot(normal, ray.direction);
  const V height = dot(Vec<V>(plane.point) - ray.origin, normal);
  const Mask<V> ahead = ((height > R(0)) & (slope > R(0))) | ((height < R(0)) & (slope < R(0)));
  return none_of(ahead) ? V(R(-1)) : select(ahead, V(height / slope), V(R(-1)));
}

/// Slabs. The comparisons are ordered so that 0 * infinity (a ray in the plane of a face) changes
/// nothing.
template <Value V>
Chord<V> intersect(const BoxSurface<Scalar<V>>& box, const Ray<V>& ray) {
  using R = Scalar<V>;
  constexpr R kInfinity = std::numeric_limits<R>::infinity();
  Chord<V> chord{V(-kInfinity), V(kInfinity)};
  for (int axis = 0; axis < 3; ++axis) {
    const V inverse = R(1) / ray.direction[axis];
    const V one = (box.min[axis] - ray.origin[axis]) * inverse;
    const V other = (box.max[axis] - ray.origin[axis]) * inverse;
    const Mask<V> backwards = inverse < R(0);
    const V low = select(backwards, other, one), high = select(backwards, one, other);
    const Mask<V> enters = low > chord.enter, leaves = high < chord.leave;
    const Index<V> lower = 2 * axis, upper = 2 * axis + 1;
    chord.enter_face = select(enters, select(backwards, upper, lower), chord.enter_face);
    chord.leave_face = select(leaves, select(backwards, lower, upper), chord.leave_face);
    chord.enter = select(enters, low, chord.enter);
    chord.leave = select(leaves, high, chord.leave);
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

  /// A point with its coordinates in the order kx, ky, kz.
  Vec<R> turned(const Vec<R>& p) const { return {p[kx], p[ky], p[kz]}; }
};

/// Where a ray's line crosses a triangle.
template <Value V>
struct Crossing {
  V t = Scalar<V>(-1);       ///< negative if the line misses
  V u{}, v{}, w{}, total{};  ///< barycentric weights, times their total
};

/// t and barycentric weights of a, b, c; t is negative if the line misses.
template <Value V>
struct TriangleHit {
  V t = Scalar<V>(-1), u{}, v{}, w{};
};

/// One ray against one triangle, or against a packet of them, all turned as the ray is. Watertight:
/// neighbours that share an edge compute the same edge function, so nothing passes between them.
/// The edge functions are differences of products with one rounding, which contraction by a
/// compiler cannot change.
template <Real R, Value V>
Crossing<V> crossing(const Vec<V> (&corners)[3], const Vec<V>& origin, const ShearedRay<R>& s) {
  // Move the triangle so that the ray starts at the origin and runs along z.
  const V sx = s.sx, sy = s.sy, sz = s.sz;
  const Vec<V> a = corners[0] - origin, b = corners[1] - origin, c = corners[2] - origin;
  const V ax = a.x - sx * a.z, ay = a.y - sy * a.z;
  const V bx = b.x - sx * b.z, by = b.y - sy * b.z;
  const V cx = c.x - sx * c.z, cy = c.y - sy * c.z;

  // Ask on which side of each edge the axis passes.
  const V u = difference_of_products(cx, by, cy, bx);
  const V v = difference_of_products(ax, cy, ay, cx);
  const V w = difference_of_products(bx, ay, by, ax);
  const Mask<V> below = (u < R(0)) | (v < R(0)) | (w < R(0));
  const Mask<V> above = (u > R(0)) | (v > R(0)) | (w > R(0));
  const V total = u + v + w;
  const Mask<V> hits = !(below & above) & (total != R(0));
  if (none_of(hits)) return {};

  const V t = (u * (sz * a.z) + v * (sz * b.z) + w * (sz * c.z)) / total;
  return {select(hits, t, V(R(-1))), u, v, w, total};
}

/// One ray against one triangle.
template <Real R>
TriangleHit<R> intersect(const std::type_identity_t<std::array<Vec<R>, 3>>& triangle,
                         const Ray<R>& ray, const ShearedRay<R>& s) {
  const Vec<R> corners[3] = {s.turned(triangle[0]), s.turned(triangle[1]), s.turned(triangle[2])};
  const Crossing<R> all = crossing(corners, s.turned(ray.origin), s);
  if (!(all.t >= 0)) return {all.t};
  return {all.t, all.u / all.total, all.v / all.total, all.w / all.total};
}

}  // namespace litmus

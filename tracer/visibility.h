// visibility.h: whether anything stands between a point and a lamp.
#pragma once

#include "tracer/hit.h"

namespace litmus {

/// How far above a triangle a shadow ray starts, in half units of the last place of the largest
/// coordinate that its point was computed from.
inline constexpr int kTriangleOffset = 5;

/// A ray from the surface of a hit to a lamp.
template <Value V>
struct ShadowRay {
  Ray<V> ray;
  V slack{};  ///< a surface that passes the lamp by no more than that is at the lamp, scene units

  /// Whether what the ray meets at t lies strictly between. `slope` is the cosine between the ray
  /// and the surface's normal, so that the lamp's distance from the surface decides: along the ray
  /// the rounding error of t grows without limit as a surface is seen edge-on. `far` is the largest
  /// coordinate of the surface.
  Mask<V> meets(const V& t, const V& slope, Scalar<V> far) const {
    using std::fabs;
    using R = Scalar<V>;
    const V apart = (ray.limit - t) * fabs(slope);
    return (t > R(0)) & (t < ray.limit) & (apart > slack + gamma_bound<R>(8) * far);
  }
};

template <Value V>
ShadowRay<Scalar<V>> lane(const ShadowRay<V>& shadow, int i) {
  return {lane(shadow.ray, i), lane(shadow.slack, i)};
}

/// Off a triangle the ray starts above the rounding error of the hit point, so that its neighbours
/// are not met either. That error is 2 roundings of the point's coordinates and 5 of its distance
/// from the first corner.
template <Value V>
ShadowRay<V> shadow_ray(const Hit<V>& hit, const Incident<V>& light) {
  using R = Scalar<V>;
  constexpr R kInfinity = std::numeric_limits<R>::infinity();
  ShadowRay<V> shadow{{hit.point, light.direction, light.distance}};
  const Mask<V> on_triangle = sees(hit, Kind::Triangle);
  if (any_of(on_triangle)) {
    const Mask<V> away = dot(hit.geometric, light.direction) < R(0);
    const Vec<V> off = select(away, -hit.geometric, hit.geometric);
    shadow.ray.origin = select(
        on_triangle, hit.point + (gamma_bound<R>(kTriangleOffset) * hit.reach) * off, hit.point);
  }
  const V slack = gamma_bound<R>(16) * (max_abs(hit.point) + light.distance);
  shadow.slack = select(light.distance < kInfinity, slack, V(R(0)));
  return shadow;
}

/// How far a ray that starts on this sphere's own surface runs inside it; not positive if it leaves
/// at once. By the normal and not by the point, whose rounding error far from the origin may be
/// larger than the cosine between the normal and the ray.
template <Value V>
V own_exit(const SphereSurface<Scalar<V>>& sphere, const Hit<V>& hit, const Ray<V>& ray) {
  using R = Scalar<V>;
  const Mask<V> inside = dot(hit.point - Vec<V>(sphere.center), hit.geometric) < R(0);
  const V twice = select(inside, V(R(2) * sphere.radius), V(R(-2) * sphere.radius));
  const V inwards = twice * dot(hit.geometric, ray.direction);
  return none_of(inwards > R(0)) ? inwards : V(inwards / dot(ray.direction, ray.direction));
}

/// The same for a box; -1 if it leaves at once.
template <Value V>
V own_exit(const BoxSurface<Scalar<V>>& box, const Hit<V>& hit, const Ray<V>& ray) {
  using R = Scalar<V>;
  V outward = R(0);
  for (int axis = 0; axis < 3; ++axis) {
    const V& along = ray.direction[axis];
    outward = select(hit.face == Index<V>(2 * axis), V(-along), outward);
    outward = select(hit.face == Index<V>(2 * axis + 1), along, outward);
  }
  const Mask<V> leaves = outward >= R(0);
  return all_of(leaves) ? V(R(-1)) : select(leaves, V(R(-1)), intersect(box, ray).leave);
}

/// Whether a solid lies in the way of a shadow ray that does not start on it.
template <Value V>
Mask<V> blocks(const SphereSurface<Scalar<V>>& sphere, const ShadowRay<V>& shadow) {
  using R = Scalar<V>;
  const Chord<V> chord = intersect(sphere, shadow.ray);
  const V slope = (chord.leave - chord.enter) * (R(0.5) / sphere.radius);
  const R far = max_abs(sphere.center) + sphere.radius;
  return (chord.enter <= chord.leave) &
         (shadow.meets(chord.enter, slope, far) | shadow.meets(chord.leave, slope, far));
}

template <Value V>
Mask<V> blocks(const BoxSurface<Scalar<V>>& box, const ShadowRay<V>& shadow) {
  const Chord<V> chord = intersect(box, shadow.ray);
  const auto slope = [&](const Index<V>& face) {
    const Vec<V>& d = shadow.ray.direction;
    return select(face < Index<V>(2), d.x, select(face < Index<V>(4), d.y, d.z));
  };
  const Scalar<V> far = std::max(max_abs(box.min), max_abs(box.max));
  return (chord.enter <= chord.leave) & (shadow.meets(chord.enter, slope(chord.enter_face), far) |
                                         shadow.meets(chord.leave, slope(chord.leave_face), far));
}

/// A few numbers of a list; `all` stands for the whole list where it is too long for that.
struct ShortList {
  static constexpr std::size_t kMost = 32;
  bool all = true;
  int count = 0;
  std::array<int, kMost> numbers;

  bool empty() const { return !all && count == 0; }
};

/// What to ask for in the plan's lists.
struct Suspects {
  ShortList spheres, boxes, planes;
  bool triangles = true;
  bool own = true;  ///< the far sides of the solids that are hit, too

  bool empty() const {
    return !own && !triangles && spheres.empty() && boxes.empty() && planes.empty();
  }
};

inline const Suspects kEverything{};

/// Calls visit(i, part) -> bool for the suspects among a list's parts, until it returns true.
template <class Parts, class Visit>
bool visit_parts(const Parts& parts, const ShortList& list, Visit visit) {
  const int count = list.all ? int(parts.size()) : list.count;
  for (int k = 0; k < count; ++k) {
    const int i = list.all ? k : list.numbers[std::size_t(k)];
    if (visit(i, parts[std::size_t(i)])) return true;
  }
  return false;
}

/// Calls visit(object, mask of the lanes that it blocks) -> bool for the spheres, boxes and planes
/// along a shadow ray until that returns true, and returns whether it did. The surface hit is left
/// out where it is flat; where it is a sphere or a box, only its far side can be in the way.
template <Real R, Value V, class Visit>
bool visit_blockers(const Plan<R>& plan, const Hit<V>& hit, const ShadowRay<V>& shadow,
                    const Mask<V>& asked, const Suspects& suspects, Visit visit) {
  const auto visit_solid = [&](int, const auto& part) {
    const Mask<V> own = sees(hit, part.object), others = asked & !own;
    Mask<V> met = false;
    if (any_of(others)) {
      const Mask<V> may = others & may_meet(ball_around(part.shape), shadow.ray);
      if (any_of(may)) met = may & blocks(part.shape, shadow);
    }
    if (suspects.own && any_of(own)) {
      const V exit = own_exit(part.shape, hit, shadow.ray);
      met = met | (own & (exit > R(0)) & (exit < shadow.ray.limit - shadow.slack));
    }
    return any_of(met) && visit(part.object, met);
  };
  return visit_parts(plan.spheres, suspects.spheres, visit_solid) ||
         visit_parts(plan.boxes, suspects.boxes, visit_solid) ||
         visit_parts(plan.planes, suspects.planes, [&](int, const auto& part) {
           const Mask<V> own = sees(hit, part.object);
           if (none_of(asked & !own)) return false;
           const V slope = dot(Vec<V>(part.shape.normal), shadow.ray.direction);
           const V t = intersect(part.shape, shadow.ray);
           return visit(part.object, !own & shadow.meets(t, slope, max_abs(part.shape.point)));
         });
}

/// The object of a triangle that a shadow ray meets, not always the nearest, -1 if there is none.
/// `own` is the triangle that it leaves, or -1; W is as many triangles as are tested at once.
template <Value W, Real R>
int blocking_triangle(const Plan<R>& plan, const ShadowRay<R>& shadow, int own) {
  const Ray<R>& ray = shadow.ray;
  const BlockRay<W> block_ray(ray);
  int blocker = -1;
  const auto blocks = [&](int number, const R& t) {
    if (number == own) return false;
    const R slope = dot(plan.triangle_info[std::size_t(number)].normal, ray.direction);
    return shadow.meets(t, slope, max_abs(plan.triangles[std::size_t(number)][0]));
  };
  traverse<W, Order::Any>(plan.bvh, ray, [&](const TriangleBlock<R>& block, int count) {
    for (int first = 0; first < count; first += kLanes<W>) {
      const Crossing<W> met = block_ray.crossing(block, first);
      unsigned hits = lanes_of((met.t > R(0)) & (met.t < W(ray.limit)));
      for (; hits != 0; hits &= hits - 1) {
        const int i = std::countr_zero(hits), number = int(block.numbers[first + i]);
        if (!blocks(number, lane(met.t, i))) continue;
        blocker = int(block.objects[first + i]);
        return true;
      }
    }
    return false;
  });
  return blocker;
}

/// The triangle that lane i of a hit is on, or -1.
template <Value V>
int own_triangle(const Hit<V>& hit, int i) {
  const OneSurface one = surface_at(hit, i);
  return one.kind == Kind::Triangle ? one.index : -1;
}

/// The first object found strictly between a hit and a lamp, not always the nearest: an index into
/// Scene::objects, -1 if there is none.
template <Real R>
int first_blocker(const Plan<R>& plan, const Hit<R>& hit, const Incident<R>& light) {
  const ShadowRay<R> shadow = shadow_ray(hit, light);
  int blocker = -1;
  const bool found =
      visit_blockers(plan, hit, shadow, true, kEverything, [&](int object, bool blocked) {
        blocker = object;
        return blocked;
      });
  return found ? blocker : blocking_triangle<R>(plan, shadow, own_triangle(hit, 0));
}

/// Whether anything lies strictly between a hit and a lamp, for the lanes that are asked for. Only
/// the suspects are looked at (suspects.h).
template <Real R, Value V>
Mask<V> occluded(const Plan<R>& plan, const Hit<V>& hit, const Incident<V>& light,
                 const Mask<V>& asked = true, const Suspects& suspects = kEverything) {
  if (suspects.empty()) return false;
  const ShadowRay<V> shadow = shadow_ray(hit, light);
  Mask<V> blocked = !asked;
  const bool all_blocked =
      visit_blockers(plan, hit, shadow, asked, suspects, [&](int, const Mask<V>& by_one) {
        blocked = blocked | by_one;
        return all_of(blocked);
      });
  if (all_blocked || plan.triangles.empty() || !suspects.triangles) return blocked & asked;
  const Mask<V> may_meet = !blocked & meets_box(plan.bvh.min, plan.bvh.max, shadow.ray);
  for (unsigned left = lanes_of(may_meet); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left), own = own_triangle(hit, i);
    if (blocking_triangle<Abreast<V>>(plan, lane(shadow, i), own) >= 0) set_lane(blocked, i, true);
  }
  return blocked & asked;
}

}  // namespace litmus

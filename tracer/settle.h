// settle.h: a hit moved onto the surface that it is on.
#pragma once

#include "tracer/hit.h"

namespace litmus {

/// Calls visit(lane that is on it, mask of all lanes that are) for each surface of a mixed hit, all
/// triangles at once.
template <Value V, class Visit>
void for_each_surface(const Hit<V>& hit, Visit visit) {
  if constexpr (kLanes<V> == 1) {
    if (hit.object >= 0) visit(0, true);
  } else {
    for (Mask<V> left = hit.object >= Index<V>(0); any_of(left);) {
      const int i = first_of(left);
      const OneSurface one = surface_at(hit, i);
      Mask<V> on = left & (hit.kind == kind_value<V>(one.kind));
      if (one.kind != Kind::Triangle) on = on & (hit.index == Index<V>(one.index));
      visit(i, on);
      left = left & !on;
    }
  }
}

/// The point of a hit moved onto its surface, with its normals before they are turned.
template <Value V>
struct Settled {
  Vec<V> point, geometric, normal;
  V reach{};
  V outwards{};  ///< solids: positive where the normal points out of it
};

template <Value V>
Settled<V> settle(const SphereSurface<Scalar<V>>& sphere, const Hit<V>& hit) {
  const Vec<V> center(sphere.center);
  const Vec<V> normal = normalize<Divide::Once>(hit.point - center);
  const Vec<V> point = center + V(sphere.radius) * normal;
  return {point, normal, normal, max_abs(point), dot(point - center, normal)};
}

template <Value V>
Settled<V> settle(const PlaneSurface<Scalar<V>>& plane, const Hit<V>& hit) {
  const Vec<V> normal(plane.normal);
  const Vec<V> point = hit.point - dot(hit.point - Vec<V>(plane.point), normal) * normal;
  return {point, normal, normal, max_abs(point), {}};
}

template <Value V>
Settled<V> settle(const BoxSurface<Scalar<V>>& box, const Hit<V>& hit) {
  using R = Scalar<V>;
  Settled<V> settled{hit.point, {}, {}, {}, V(R(1))};
  V* const point[3] = {&settled.point.x, &settled.point.y, &settled.point.z};
  V* const normal[3] = {&settled.normal.x, &settled.normal.y, &settled.normal.z};
  for (int axis = 0; axis < 3; ++axis) {
    const Mask<V> lower = hit.face == Index<V>(2 * axis),
                  upper = hit.face == Index<V>(2 * axis + 1);
    *point[axis] = select(lower, V(box.min[axis]), select(upper, V(box.max[axis]), *point[axis]));
    *normal[axis] = select(lower, V(R(-1)), select(upper, V(R(1)), V(R(0))));
  }
  settled.geometric = settled.normal;
  settled.reach = max_abs(settled.point);
  return settled;
}

/// What the hits on triangles need to know of theirs, in each lane.
template <Value V>
struct HitTriangles {
  std::array<Vec<V>, 3> corners, normals;
  Vec<V> normal;
  Mask<V> smooth = false;
};

/// Collects those of the lanes that are on triangles.
template <Real R, Value V>
HitTriangles<V> triangles_of(const Plan<R>& plan, const Hit<V>& hit, const Mask<V>& on) {
  constexpr int kCount = 3 * 3 * 2 + 3;
  R lanes[kCount][kLanes<V>] = {};
  HitTriangles<V> all;
  for (int i = 0; i < kLanes<V>; ++i) {
    if (!lane(on, i)) continue;
    const auto index = std::size_t(lane(hit.index, i));
    const TriangleInfo<R>& info = plan.triangle_info[index];
    int place = 0;
    const auto put = [&](const Vec<R>& v) {
      lanes[place++][i] = v.x, lanes[place++][i] = v.y, lanes[place++][i] = v.z;
    };
    for (const Vec<R>& corner : plan.triangles[index]) put(corner);
    put(info.normal);
    if (!info.smooth) continue;
    set_lane(all.smooth, i, true);
    for (const Vec<R>& normal : info.normals) put(normal);
  }
  int place = 0;
  const auto take = [&](Vec<V>& v) {
    v = {load_lanes<V>(lanes[place]), load_lanes<V>(lanes[place + 1]),
         load_lanes<V>(lanes[place + 2])};
    place += 3;
  };
  for (Vec<V>& corner : all.corners) take(corner);
  take(all.normal);
  if (any_of(all.smooth)) {
    for (Vec<V>& normal : all.normals) take(normal);
  }
  return all;
}

/// From the first corner along the edges: the weights need not add up to 1 to the last digit.
template <Value V>
Settled<V> settle(const HitTriangles<V>& on, const Hit<V>& hit) {
  const auto& [a, b, c] = on.corners;
  const V at_a = max_abs(a), at_b = max_abs(b), at_c = max_abs(c);
  const V ab_reach = select(at_a < at_b, at_b, at_a);
  Settled<V> settled{a + (hit.v * (b - a) + hit.w * (c - a)),
                     on.normal,
                     on.normal,
                     select(ab_reach < at_c, at_c, ab_reach),
                     {}};
  if (none_of(on.smooth)) return settled;
  const auto& [na, nb, nc] = on.normals;
  const Vec<V> between = normalize<Divide::Once>(hit.u * na + hit.v * nb + hit.w * nc);
  settled.normal = select(on.smooth, between, on.normal);
  return settled;
}

/// Calls use(a hit moved onto a surface); `on` are the lanes that are on it. (A result that is
/// returned from the cases would be copied through memory.)
template <Real R, Value V, class Use>
void settle_on(const Plan<R>& plan, const Hit<V>& hit, const OneSurface& one, const Mask<V>& on,
               const Use& use) {
  const auto index = std::size_t(one.index);
  switch (one.kind) {
    case Kind::None:
      break;
    case Kind::Sphere:
      return use(settle(plan.spheres[index].shape, hit));
    case Kind::Plane:
      return use(settle(plan.planes[index].shape, hit));
    case Kind::Box:
      return use(settle(plan.boxes[index].shape, hit));
    case Kind::Triangle:
      return use(settle(triangles_of(plan, hit, on), hit));
  }
}

/// A hit moved onto the surface of each lane.
template <Real R, Value V>
Settled<V> settle_each(const Plan<R>& plan, const Hit<V>& hit) {
  Settled<V> all;
  for_each_surface(hit, [&](int i, const Mask<V>& on) {
    const auto keep = [&](const Settled<V>& one) {
      if (all_of(on)) {
        all = one;
        return;
      }
      all = {select(on, one.point, all.point), select(on, one.geometric, all.geometric),
             select(on, one.normal, all.normal), select(on, one.reach, all.reach),
             select(on, one.outwards, all.outwards)};
    };
    settle_on(plan, hit, surface_at(hit, i), on, keep);
  });
  return all;
}

/// Turns the normals of a hit towards the eye.
template <Real R, Value V>
void turn(const Plan<R>& plan, const Ray<V>& ray, const Settled<V>& all, Hit<V>& hit) {
  hit.point = all.point;
  const Mask<V> turned = dot(all.geometric, ray.direction) > R(0);
  hit.geometric = select(turned, -all.geometric, all.geometric);
  if (plan.shadows || plan.idle_shadows || kLanes<V> == 1) {
    hit.reach = all.reach;
    hit.inside = select(turned, -all.outwards, all.outwards) < R(0);
  }
  if (!plan.smooth) {
    if (kLanes<V> == 1) hit.normal = hit.geometric;
    return;
  }
  hit.normal = select(dot(all.normal, ray.direction) > R(0), -all.normal, all.normal);
}

/// The geometric and shading normal of a hit, and its point moved onto the surface.
template <Real R, Value V>
void settle(const Plan<R>& plan, const Ray<V>& ray, Hit<V>& hit) {
  if (!hit.mixed) {
    hit.point = ray.origin + hit.t * ray.direction;
    settle_on(plan, hit, hit.one, Mask<V>(true),
              [&](const Settled<V>& all) { turn(plan, ray, all, hit); });
  } else {
    const Mask<V> seen = seen_by(hit);
    hit.point = ray.origin + select(seen, hit.t, V(R(0))) * ray.direction;
    turn(plan, ray, settle_each(plan, hit), hit);
  }
}

}  // namespace litmus

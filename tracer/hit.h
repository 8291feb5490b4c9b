// hit.h: what a ray from the eye hits first.
#pragma once

#include "tracer/spans.h"

namespace litmus {

enum class Kind { None, Sphere, Plane, Box, Triangle };

/// A Kind, or a lane each.
template <Value V>
using KindOf = std::conditional_t<kLanes<V> == 1, Kind, Index<V>>;

template <Value V>
KindOf<V> kind_value(Kind kind) {
  if constexpr (kLanes<V> == 1) {
    return kind;
  } else {
    return Index<V>(Scalar<V>(int(kind)));
  }
}

/// The point seen. `kind` and `index` name the entry of the plan's list; `face` the face of a box.
template <Value V>
struct Hit {
  KindOf<V> kind = kind_value<V>(Kind::None);
  Index<V> index = -1, face = 0, object = -1;
  V t = std::numeric_limits<Scalar<V>>::infinity();
  V u{}, v{}, w{};         ///< triangles: barycentric weights
  Vec<V> point;            ///< on the surface itself, not just on the ray
  V reach{};               ///< largest coordinate that the point was computed from
  Vec<V> geometric;        ///< unit normal of the surface, turned towards the eye
  Vec<V> normal;           ///< unit normal for shading, turned towards the eye by itself
  Mask<V> inside = false;  ///< of a sphere or a box, seen from within
};

template <Value V>
Kind kind_at(const Hit<V>& hit, int i) {
  if constexpr (kLanes<V> == 1) {
    return hit.kind;
  } else {
    return Kind(int(lane(hit.kind, i)));
  }
}

/// Nearest first; of equals the object that comes first in the scene, then the lower index.
template <Value V>
Mask<V> comes_before(const V& t, int object, int index, const Hit<V>& best) {
  const Mask<V> nearer = t < best.t, tied = t == best.t;
  if (none_of(tied)) return nearer;
  const Index<V> o(object), i(index);
  return nearer | (tied & ((o < best.object) | ((o == best.object) & (i < best.index))));
}

/// One lane of a ray.
template <Value V>
Ray<Scalar<V>> lane(const Ray<V>& ray, int i) {
  return {{lane(ray.origin.x, i), lane(ray.origin.y, i), lane(ray.origin.z, i)},
          {lane(ray.direction.x, i), lane(ray.direction.y, i), lane(ray.direction.z, i)},
          lane(ray.limit, i)};
}

/// Calls visit(lane that is on it, mask of all lanes that are) for each surface that is hit.
template <Value V, class Visit>
void for_each_surface(const Hit<V>& hit, Visit visit) {
  if constexpr (kLanes<V> == 1) {
    if (hit.object >= 0) visit(0, true);
  } else {
    for (Mask<V> left = hit.object >= Index<V>(0); any_of(left);) {
      const int i = first_of(left);
      const Mask<V> on =
          (hit.kind == KindOf<V>(lane(hit.kind, i))) & (hit.index == Index<V>(lane(hit.index, i)));
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

/// From the first corner along the edges: the weights need not add up to 1 to the last digit.
template <Real R, Value V>
Settled<V> settle(const std::array<Vec<R>, 3>& corners, const TriangleInfo<R>& info,
                  const Hit<V>& hit) {
  const Vec<V> a(corners[0]), ab(corners[1] - corners[0]), ac(corners[2] - corners[0]);
  const auto between = [&](const std::array<Vec<R>, 3>& at) {
    return hit.u * Vec<V>(at[0]) + hit.v * Vec<V>(at[1]) + hit.w * Vec<V>(at[2]);
  };
  const Vec<V> normal(info.normal);
  const R reach = std::max({max_abs(corners[0]), max_abs(corners[1]), max_abs(corners[2])});
  return {a + (hit.v * ab + hit.w * ac),
          normal,
          info.smooth ? normalize<Divide::Once>(between(info.normals)) : normal,
          V(reach),
          {}};
}

/// The geometric and shading normal of a hit, and its point moved onto the surface.
template <Real R, Value V>
void settle(const Plan<R>& plan, const Ray<V>& ray, Hit<V>& hit) {
  const Mask<V> seen = hit.object >= Index<V>(0);
  hit.point = ray.origin + select(seen, hit.t, V(R(0))) * ray.direction;
  Settled<V> all;
  for_each_surface(hit, [&](int i, const Mask<V>& on) {
    const auto index = std::size_t(lane(hit.index, i));
    Settled<V> one;
    switch (kind_at(hit, i)) {
      case Kind::None:
        break;
      case Kind::Sphere:
        one = settle(plan.spheres[index].shape, hit);
        break;
      case Kind::Plane:
        one = settle(plan.planes[index].shape, hit);
        break;
      case Kind::Box:
        one = settle(plan.boxes[index].shape, hit);
        break;
      case Kind::Triangle:
        one = settle(plan.triangles[index], plan.triangle_info[index], hit);
        break;
    }
    if (all_of(on)) {
      all = one;
      return;
    }
    all = {select(on, one.point, all.point), select(on, one.geometric, all.geometric),
           select(on, one.normal, all.normal), select(on, one.reach, all.reach),
           select(on, one.outwards, all.outwards)};
  });
  hit.point = all.point, hit.reach = all.reach;
  const Mask<V> turned = dot(all.geometric, ray.direction) > R(0);
  hit.geometric = select(turned, -all.geometric, all.geometric);
  hit.inside = select(turned, -all.outwards, all.outwards) < R(0);
  hit.normal = hit.geometric;
  if (!plan.smooth) return;
  hit.normal = select(dot(all.normal, ray.direction) > R(0), -all.normal, all.normal);
}

/// Moves a hit to the triangle that a ray meets first, if that comes before.
template <Real R, Value V>
void closest_triangle(const Plan<R>& plan, const Ray<V>& rays, Hit<V>& best) {
  for (int i = 0; i < kLanes<V>; ++i) {
    Ray<R> ray = lane(rays, i);
    ray.limit = lane(best.t, i);
    Hit<R> found;
    found.t = ray.limit;
    found.object = int(lane(best.object, i)), found.index = int(lane(best.index, i));
    const ShearedRay<R> sheared(ray.direction);
    traverse(plan.bvh, ray, [&](std::uint32_t number) {
      const int object = plan.triangle_info[number].object, index = int(number);
      if (!plan.camera_visible[std::size_t(object)]) return false;
      const TriangleHit<R> hit = intersect(plan.triangles[number], ray, sheared);
      if (!(hit.t > 0) || !comes_before(hit.t, object, index, found)) return false;
      found.kind = Kind::Triangle, found.object = object, found.index = index;
      found.u = hit.u, found.v = hit.v, found.w = hit.w;
      found.t = ray.limit = hit.t;
      return false;
    });
    if (found.kind == Kind::None) continue;
    Mask<V> here = false;
    set_lane(here, i, true);
    best.kind = select(here, kind_value<V>(Kind::Triangle), best.kind);
    set_lane(best.object, i, Scalar<Index<V>>(found.object));
    set_lane(best.index, i, Scalar<Index<V>>(found.index));
    set_lane(best.t, i, found.t);
    set_lane(best.u, i, found.u), set_lane(best.v, i, found.v), set_lane(best.w, i, found.w);
  }
}

/// Finds what a ray from the eye sees first among the objects that a camera sees. `may_meet(spans,
/// i, ball)` says whether it may meet the solid i of a list at all.
template <Real R, Value V, class MayMeet>
void find_closest(const Plan<R>& plan, const Ray<V>& ray, const MayMeet& may_meet, Hit<V>& best) {
  best.kind = kind_value<V>(Kind::None), best.index = Index<V>(-1), best.object = Index<V>(-1);
  best.t = V(std::numeric_limits<R>::infinity());
  const auto offer = [&](Kind kind, const V& t, int object, int index) {
    const Mask<V> nearer = (t > R(0)) & comes_before(t, object, index, best);
    best.kind = select(nearer, kind_value<V>(kind), best.kind);
    best.t = select(nearer, t, best.t);
    best.object = select(nearer, Index<V>(object), best.object);
    best.index = select(nearer, Index<V>(index), best.index);
    return nearer;
  };
  const auto offer_chord = [&](Kind kind, const Chord<V>& chord, int object, int index) {
    const Mask<V> hits = chord.enter <= chord.leave, outside = chord.enter > R(0);
    const V t = select(hits, select(outside, chord.enter, chord.leave), V(R(-1)));
    const Mask<V> nearer = offer(kind, t, object, index);
    if (kind != Kind::Box) return;
    best.face = select(nearer, select(outside, chord.enter_face, chord.leave_face), best.face);
  };
  const auto seen = [&](int object) { return plan.camera_visible[std::size_t(object)] != 0; };
  for (int i = 0; const auto& part : plan.planes) {
    if (seen(part.object)) offer(Kind::Plane, intersect(part.shape, ray), part.object, i);
    ++i;
  }
  for (int i = 0; const auto& part : plan.spheres) {
    if (seen(part.object) && may_meet(&RowSpans<R>::spheres, i, ball_around(part.shape))) {
      offer_chord(Kind::Sphere, intersect(part.shape, ray), part.object, i);
    }
    ++i;
  }
  for (int i = 0; const auto& part : plan.boxes) {
    if (seen(part.object) && may_meet(&RowSpans<R>::boxes, i, ball_around(part.shape))) {
      offer_chord(Kind::Box, intersect(part.shape, ray), part.object, i);
    }
    ++i;
  }
  if (!plan.triangles.empty()) closest_triangle(plan, ray, best);
  settle(plan, ray, best);
}

/// The same, where any ray may go anywhere: the solids are found by the balls around them.
template <Real R, Value V>
void find_closest(const Plan<R>& plan, const Ray<V>& ray, Hit<V>& best) {
  find_closest(
      plan, ray, [&](auto, int, const Ball<R>& ball) { return any_of(may_meet(ball, ray)); }, best);
}

/// The same for rays through the points `across` of a row of the picture.
template <Real R, Value V>
void find_closest(const Plan<R>& plan, const Ray<V>& ray, const RowSpans<R>& spans, const V& across,
                  Hit<V>& best) {
  const auto may_meet = [&](auto list, int i, const Ball<R>&) {
    const Span<R>& span = (spans.*list)[std::size_t(i)];
    return any_of((across >= span.low) & (across <= span.high));
  };
  find_closest(plan, ray, may_meet, best);
}

/// What a ray from the eye sees first among the objects that a camera sees.
template <Real R, Value V = R>
Hit<V> closest_hit(const Plan<R>& plan, const std::type_identity_t<Ray<V>>& ray) {
  Hit<V> best;
  find_closest(plan, ray, best);
  return best;
}

}  // namespace litmus

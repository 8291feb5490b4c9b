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

/// The surface that every lane sees, where there is one; else `kind` is None. Most packets see one
/// alone, of which nothing needs to be asked lane by lane.
struct OneSurface {
  Kind kind = Kind::None;
  int index = -1, object = -1;
};

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
  Vec<V> normal;           ///< unit normal for shading, turned by itself; see shading_normal()
  Mask<V> inside = false;  ///< of a sphere or a box, seen from within
  OneSurface one;
};

/// Hit::normal, which a packet has only where something in the scene is smooth: elsewhere it is the
/// surface's own.
template <Real R, Value V>
const Vec<V>& shading_normal(const Plan<R>& plan, const Hit<V>& hit) {
  return plan.smooth || kLanes<V> == 1 ? hit.normal : hit.geometric;
}

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

/// Calls visit(lane that is on it, mask of all lanes that are) for each surface that is hit, all
/// triangles at once.
template <Value V, class Visit>
void for_each_surface(const Hit<V>& hit, Visit visit) {
  if constexpr (kLanes<V> == 1) {
    if (hit.object >= 0) visit(0, true);
  } else {
    for (Mask<V> left = hit.object >= Index<V>(0); any_of(left);) {
      const int i = first_of(left);
      Mask<V> on = left & (hit.kind == KindOf<V>(lane(hit.kind, i)));
      if (kind_at(hit, i) != Kind::Triangle) on = on & (hit.index == Index<V>(lane(hit.index, i)));
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

/// Calls use(a hit moved onto a surface); `on` are the lanes that are on it.
template <Real R, Value V, class Use>
void settle_on(const Plan<R>& plan, const Hit<V>& hit, Kind kind, std::size_t index,
               const Mask<V>& on, const Use& use) {
  switch (kind) {
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
    settle_on(plan, hit, kind_at(hit, i), std::size_t(lane(hit.index, i)), on, keep);
  });
  return all;
}

/// Turns the normals of a hit towards the eye.
template <Real R, Value V>
void turn(const Plan<R>& plan, const Ray<V>& ray, const Settled<V>& all, Hit<V>& hit) {
  hit.point = all.point, hit.reach = all.reach;
  const Mask<V> turned = dot(all.geometric, ray.direction) > R(0);
  hit.geometric = select(turned, -all.geometric, all.geometric);
  hit.inside = select(turned, -all.outwards, all.outwards) < R(0);
  if (!plan.smooth) {
    if (kLanes<V> == 1) hit.normal = hit.geometric;
    return;
  }
  hit.normal = select(dot(all.normal, ray.direction) > R(0), -all.normal, all.normal);
}

/// The geometric and shading normal of a hit, and its point moved onto the surface.
template <Real R, Value V>
void settle(const Plan<R>& plan, const Ray<V>& ray, Hit<V>& hit) {
  if (hit.one.kind != Kind::None) {
    hit.point = ray.origin + hit.t * ray.direction;
    settle_on(plan, hit, hit.one.kind, std::size_t(hit.one.index), Mask<V>(true),
              [&](const Settled<V>& all) { turn(plan, ray, all, hit); });
  } else {
    const Mask<V> seen = hit.object >= Index<V>(0);
    hit.point = ray.origin + select(seen, hit.t, V(R(0))) * ray.direction;
    turn(plan, ray, settle_each(plan, hit), hit);
  }
}

/// Asks for what will be read soon.
template <class T>
void prefetch(const T& soon) {
  constexpr std::size_t kLine = 64;
  const char* const first = reinterpret_cast<const char*>(&soon);
  for (std::size_t at = 0; at < sizeof(T); at += kLine) __builtin_prefetch(first + at);
  __builtin_prefetch(first + sizeof(T) - 1);
}

/// Moves the hit of one ray to the triangle that it meets first, if that comes before. W is as many
/// triangles as are tested at once.
template <Value W, Real R>
void closest_triangle(const Plan<R>& plan, Ray<R> ray, Hit<R>& best) {
  const BlockRay<W> block_ray(ray);
  ray.limit = best.t;
  R total = 1;
  traverse<W, Order::NearestFirst>(plan.bvh, ray, [&](const TriangleBlock<R>& block, int count) {
    for (int first = 0; first < count; first += kLanes<W>) {
      const Crossing<W> met = block_ray.crossing(block, first);
      unsigned hits = lanes_of((met.t > R(0)) & (met.t <= W(ray.limit)));
      for (; hits != 0; hits &= hits - 1) {
        const int i = std::countr_zero(hits), index = int(block.numbers[first + i]);
        const int object = int(block.objects[first + i]);
        if (!plan.camera_visible[std::size_t(object)]) continue;
        if (!comes_before(lane(met.t, i), object, index, best)) continue;
        best.kind = Kind::Triangle, best.object = object, best.index = index;
        best.u = lane(met.u, i), best.v = lane(met.v, i), best.w = lane(met.w, i);
        best.t = ray.limit = lane(met.t, i), total = lane(met.total, i);
        prefetch(plan.triangles[std::size_t(index)]);
        prefetch(plan.triangle_info[std::size_t(index)]);
      }
    }
    return false;
  });
  if (best.kind != Kind::Triangle) return;
  best.u = best.u / total, best.v = best.v / total, best.w = best.w / total;
}

/// The same for the rays of a packet, of which only those that meet the box around all triangles
/// are looked at.
template <Real R, Value V>
[[gnu::noinline, gnu::flatten]] void closest_triangles(const Plan<R>& plan, Ray<V> rays,
                                                       Hit<V>& best) {
  rays.limit = best.t;
  const Mask<V> may_meet = meets_box(plan.bvh.min, plan.bvh.max, rays);
  for (unsigned left = lanes_of(may_meet); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    Hit<R> found;
    found.t = lane(best.t, i);
    found.object = int(lane(best.object, i)), found.index = int(lane(best.index, i));
    closest_triangle<Abreast<V>>(plan, lane(rays, i), found);
    if (found.kind == Kind::None) continue;
    best.one = {};
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
  best.t = V(std::numeric_limits<R>::infinity()), best.one = {};
  const auto offer = [&](Kind kind, const V& t, int object, int index) {
    const Mask<V> nearer = (t > R(0)) & comes_before(t, object, index, best);
    best.kind = select(nearer, kind_value<V>(kind), best.kind);
    best.t = select(nearer, t, best.t);
    best.object = select(nearer, Index<V>(object), best.object);
    best.index = select(nearer, Index<V>(index), best.index);
    if (all_of(nearer)) {
      best.one = {kind, index, object};
    } else if (any_of(nearer)) {
      best.one = {};
    }
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
  if (!plan.triangles.empty()) closest_triangles(plan, ray, best);
  settle(plan, ray, best);
}

/// The same, where any ray may go anywhere: the solids are found by the balls around them.
template <Real R, Value V>
void find_closest(const Plan<R>& plan, const Ray<V>& ray, Hit<V>& best) {
  find_closest(
      plan, ray, [&](auto, int, const Ball<R>& ball) { return any_of(may_meet(ball, ray)); }, best);
}

/// The same for rays through the points `across` of a row of the picture, from left to right.
template <Real R, Value V>
void find_closest(const Plan<R>& plan, const Ray<V>& ray, const RowSpans<R>& spans, const V& across,
                  Hit<V>& best) {
  const R first = lane(across, 0), last = lane(across, kLanes<V> - 1);
  const auto may_meet = [&](auto list, int i, const Ball<R>&) {
    const Span<R>& span = (spans.*list)[std::size_t(i)];
    return first <= span.high && last >= span.low;
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

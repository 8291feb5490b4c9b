// closest.h: finds what a ray from the eye hits first.
#pragma once

#include "tracer/settle.h"
#include "tracer/spans.h"

namespace litmus {

/// Nearest first; of equals the object that comes first in the scene, then the lower index. Where
/// there are equals, `best` is mixed.
template <Value V>
Mask<V> comes_before(const V& t, int object, int index, Hit<V>& best) {
  const Mask<V> nearer = t < best.t, tied = t == best.t;
  if (none_of(tied)) return nearer;
  mix_lanes(best);
  const Index<V> o(object), i(index);
  return nearer | (tied & ((o < best.object) | ((o == best.object) & (i < best.index))));
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
    const OneSurface before = surface_at(best, i);
    found.object = before.object, found.index = before.index;
    closest_triangle<Abreast<V>>(plan, lane(rays, i), found);
    if (found.kind == Kind::None) continue;
    mix_lanes(best);
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
  best.t = V(std::numeric_limits<R>::infinity());
  best.one = {}, best.mixed = false;
  if (kLanes<V> == 1) mix_lanes(best);
  const auto offer = [&](Kind kind, const V& t, int object, int index) {
    const Mask<V> nearer = (t > R(0)) & comes_before(t, object, index, best);
    if (none_of(nearer)) return nearer;
    best.t = select(nearer, t, best.t);
    if (kLanes<V> != 1 && all_of(nearer)) {
      best.one = {kind, index, object}, best.mixed = false;
      return nearer;
    }
    mix_lanes(best);
    best.kind = select(nearer, kind_value<V>(kind), best.kind);
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

// suspects.h: which surfaces can stand between a point and any lamp of an area light.
//
// All lamps of a light lie in a ball. The sight lines from a point to a ball lie in a cone, and a
// surface whose own ball misses the cone is asked for no lamp: one test for many shadow rays. The
// margins are wider than any rounding, so no bit of a picture changes.
#pragma once

#include <array>

#include "tracer/visibility.h"

namespace litmus {

/// The sight lines from the points of a hit to the lamps of a light.
template <Value V>
struct Sightlines {
  Vec<V> from, along;  ///< unit
  V length;            ///< to the centre of the lamps' ball
  V radius;            ///< of that ball
  V sine, cosine;      ///< of the cone's half angle
  V coordinate;        ///< bounds those that `from` was computed from: a shadow ray's offset too

  /// Where a ball may touch a line.
  Mask<V> may_meet(const Ball<Scalar<V>>& ball) const {
    using std::fabs, std::sqrt;
    using R = Scalar<V>;
    const Vec<V> to = Vec<V>(ball.center) - from;
    const V squared = dot(to, to), ahead = dot(to, along);
    const V beside = squared - ahead * ahead;
    const V aside = sqrt(select(beside > R(0), beside, V(R(0))));
    const V reach = ball.radius + R(1024) * kUnit<R> *
                                      (sqrt(squared) + ball.radius + length + radius + coordinate);
    const Mask<V> in_cone = !(aside * cosine - sine * ahead > reach);
    return in_cone & !(ahead + reach < R(0)) & !(ahead - reach > length + radius);
  }

  /// Where a plane may cross a line.
  Mask<V> may_meet(const PlaneSurface<Scalar<V>>& plane) const {
    using std::fabs;
    using R = Scalar<V>;
    const Vec<V> normal(plane.normal), point(plane.point);
    const V here = dot(from - point, normal);
    const V there = here + length * dot(along, normal);
    const V margin = R(1024) * kUnit<R> * (max_abs(from - point) + length + radius + coordinate);
    const Mask<V> same = (here > margin) & (there > radius + margin);
    const Mask<V> other = (here < -margin) & (there < -(radius + margin));
    return !(same | other);
  }
};

template <Real R, Value V>
Sightlines<V> sightlines(const Ball<R>& lamps, const Hit<V>& hit) {
  using std::sqrt;
  const Direction<V> to = direction_of(Vec<V>(lamps.center) - hit.point);
  // Inside of the ball every direction is a sight line.
  const V ratio = V(lamps.radius) / to.length;
  const V sine = select(ratio < R(1), ratio, V(R(1)));
  return {hit.point,
          to.unit,
          to.length,
          V(lamps.radius),
          sine,
          sqrt(V(R(1) - sine * sine)),
          max_abs(hit.point) + hit.reach};
}

/// Finds the surfaces that may hide a lamp of the light from a point that is asked for. Written in
/// place: of a list, only what it counts; clearing the rest would take longer than finding it.
template <Real R, Value V>
void find_suspects(const Plan<R>& plan, const Source<R>& source, const Hit<V>& hit,
                   const Mask<V>& asked, Suspects& suspects) {
  const Sightlines<V> lines = sightlines(source.ball, hit);
  // A point amid the lamps is in no cone.
  const Mask<V> certain = asked & (lines.length > R(2) * lines.radius);
  const Mask<V> uncertain = asked & !certain;
  const auto meets = [&](const auto& shape) {
    return any_of(uncertain | (certain & lines.may_meet(shape)));
  };
  const auto list = [&](const auto& parts, const auto& shape_of, ShortList& found) {
    found.all = parts.size() > ShortList::kMost, found.count = 0;
    if (found.all) return;
    for (int i = 0; const auto& part : parts) {
      if (meets(shape_of(part.shape))) found.numbers[std::size_t(found.count++)] = i;
      ++i;
    }
  };
  const auto ball = [](const auto& solid) { return ball_around(solid); };
  list(plan.spheres, ball, suspects.spheres);
  list(plan.boxes, ball, suspects.boxes);
  list(
      plan.planes, [](const PlaneSurface<R>& plane) { return plane; }, suspects.planes);
  suspects.triangles = !plan.triangles.empty() && meets(plan.mesh_ball);
}

}  // namespace litmus

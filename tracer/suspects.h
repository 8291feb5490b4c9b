// suspects.h: which surfaces can stand between some points and the lamps of a light.
//
// First for many hits at once: their points lie in a ball, the lamps in another, and the sight
// lines in the hull of both. Then, for an area light, for one hit: the sight lines from a point to
// a ball lie in a cone. A surface that misses them is asked for no lamp: one test for many shadow
// rays. The margins are wider than any rounding, so no bit of a picture changes.
#pragma once

#include <array>

#include "tracer/visibility.h"

namespace litmus {

// ---- Many hits -------------------------------------------------------------------------------

/// Where some hits lie.
struct HitRegion {
  Vec<double> min, max;
  double coordinate = 0;  ///< bounds those that the points were computed from
  int object = -1;        ///< that all of them are on; -1 if there are several
  bool inside = false;    ///< some solid is seen from within
  bool empty = true;
};

/// Adds up hits to a region.
template <Value V>
struct RegionOf {
  static constexpr Scalar<V> kInfinity = std::numeric_limits<Scalar<V>>::infinity();
  Vec<V> min{V(kInfinity), V(kInfinity), V(kInfinity)};
  Vec<V> max{V(-kInfinity), V(-kInfinity), V(-kInfinity)};
  V first = kInfinity, last = -kInfinity, reach{};
  Mask<V> inside = false;

  void add(const Hit<V>& hit) {
    if (!hit.mixed) {
      if (hit.one.kind != Kind::None) add_all(hit);
      return;
    }
    const Mask<V> seen = seen_by(hit);
    const auto widen_by = [&](const V& value, V& low, V& high) {
      low = select(seen & (value < low), value, low);
      high = select(seen & (value > high), value, high);
    };
    widen_by(hit.point.x, min.x, max.x);
    widen_by(hit.point.y, min.y, max.y);
    widen_by(hit.point.z, min.z, max.z);
    widen_by(V(hit.object), first, last);
    reach = select(seen & (hit.reach > reach), hit.reach, reach);
    inside = inside | (seen & hit.inside);
  }

  HitRegion region() const {
    HitRegion all;
    all.min = {double(smallest_of(min.x)), double(smallest_of(min.y)), double(smallest_of(min.z))};
    all.max = {double(largest_of(max.x)), double(largest_of(max.y)), double(largest_of(max.z))};
    all.coordinate = double(largest_of(reach)) + std::max(max_abs(all.min), max_abs(all.max));
    const double low = double(smallest_of(first)), high = double(largest_of(last));
    all.empty = low > high;
    all.object = low == high ? int(low) : -1;
    all.inside = any_of(inside);
    return all;
  }

 private:
  /// Where all lanes see one surface.
  void add_all(const Hit<V>& hit) {
    const auto widen_by = [&](const V& value, V& low, V& high) {
      low = smaller(value, low), high = larger(value, high);
    };
    widen_by(hit.point.x, min.x, max.x);
    widen_by(hit.point.y, min.y, max.y);
    widen_by(hit.point.z, min.z, max.z);
    widen_by(V(Scalar<V>(hit.one.object)), first, last);
    reach = larger(hit.reach, reach);
    inside = inside | hit.inside;
  }
};

/// The hull of a region and the lamps of a light, in double whatever the scene's precision is.
struct Hull {
  Vec<double> from, along;          ///< the middle of the region; unit, towards the lamps
  double length = 0;                ///< to the middle of the lamps; infinite for a directional one
  double radius = 0, lamps = 0;     ///< of the balls around the region and around the lamps
  Vec<double> min, max;             ///< of the hull
  double unit = 0, coordinate = 0;  ///< rounding error, and the largest coordinate
  const HitRegion* region;

  double margin(double farthest) const { return 1024 * unit * (coordinate + farthest); }

  bool may_meet(const Ball<double>& ball) const {
    const double reach = ball.radius + margin(max_abs(ball.center) + ball.radius);
    const Vec<double> to = ball.center - from;
    const double ahead = dot(to, along), beside = dot(to, to) - ahead * ahead;
    const double aside = std::sqrt(std::max(beside, 0.0));
    if (std::isinf(length)) return aside <= reach + radius && ahead >= -(reach + radius);
    if (misses_box(ball.center - Vec<double>{reach, reach, reach},
                   ball.center + Vec<double>{reach, reach, reach})) {
      return false;
    }
    // The nearest ball of the hull, at `at` along its axis, whose radius changes by `slope`.
    const double slope = (lamps - radius) / length;
    if (!(std::fabs(slope) < 1)) return true;
    const double root = std::sqrt(1 - slope * slope);
    const double at = std::clamp(ahead + slope * aside / root, 0.0, length);
    const double apart = std::sqrt((ahead - at) * (ahead - at) + aside * aside);
    return apart <= reach + radius + slope * at;
  }

  bool may_meet(const BoundedBox<double>& box) const {
    if (!may_meet(box.ball)) return false;
    const double wide = margin(std::max(max_abs(box.min), max_abs(box.max)));
    const Vec<double> more{wide, wide, wide};
    return std::isinf(length) || !misses_box(box.min - more, box.max + more);
  }

  bool may_meet(const PlaneSurface<double>& plane) const {
    const Vec<double>& n = plane.normal;
    const Vec<double> half = 0.5 * (region->max - region->min);
    const double wide = std::fabs(n.x) * half.x + std::fabs(n.y) * half.y +
                        std::fabs(n.z) * half.z + margin(max_abs(plane.point));
    const double here = dot(from - plane.point, n), slope = dot(along, n);
    if (std::isinf(length)) {
      constexpr double kLevel = 1e-6;  // far above the rounding of a cosine
      return !(here > wide && slope > kLevel) && !(here < -wide && slope < -kLevel);
    }
    const double there = here + length * slope, around = lamps + wide;
    return !(here > wide && there > around) && !(here < -wide && there < -around);
  }

 private:
  bool misses_box(const Vec<double>& low, const Vec<double>& high) const {
    return low.x > max.x || low.y > max.y || low.z > max.z || high.x < min.x || high.y < min.y ||
           high.z < min.z;
  }
};

template <Real R>
Ball<double> in_double(const Ball<R>& ball) {
  return {in_double(ball.center), double(ball.radius)};
}
template <Real R>
Ball<double> in_double(const SphereSurface<R>& sphere) {
  return in_double(ball_around(sphere));
}
template <Real R>
BoundedBox<double> in_double(const BoundedBox<R>& box) {
  return {{in_double(box.min), in_double(box.max)}, in_double(box.ball)};
}
template <Real R>
PlaneSurface<double> in_double(const PlaneSurface<R>& plane) {
  return {in_double(plane.point), in_double(plane.normal)};
}

template <Real R>
Hull hull_of(const HitRegion& region, const Source<R>& source) {
  Hull hull;
  hull.region = &region;
  hull.unit = std::max(double(kUnit<R>), kUnit<double>);
  const Vec<double> half = 0.5 * (region.max - region.min);
  hull.from = region.min + half;
  hull.radius = std::sqrt(dot(half, half));
  hull.coordinate = region.coordinate;
  if (source.lamps.front().directional) {
    hull.length = std::numeric_limits<double>::infinity();
    hull.along = in_double(source.lamps.front().toward);
    return hull;
  }
  const Ball<double> lamps = in_double(source.ball);
  hull.lamps = lamps.radius;
  hull.coordinate += max_abs(lamps.center) + lamps.radius;
  const Direction<double> to = direction_of(lamps.center - hull.from);
  hull.along = to.unit, hull.length = to.length;
  const double margin = hull.margin(0);
  const auto bounds = [&](double a, double b, double center, double& low, double& high) {
    low = std::min(a, center - lamps.radius) - margin;
    high = std::max(b, center + lamps.radius) + margin;
  };
  bounds(region.min.x, region.max.x, lamps.center.x, hull.min.x, hull.max.x);
  bounds(region.min.y, region.max.y, lamps.center.y, hull.min.y, hull.max.y);
  bounds(region.min.z, region.max.z, lamps.center.z, hull.min.z, hull.max.z);
  return hull;
}

/// Lists the parts for which may(i, part) holds, of all or of those that `among` lists. Written in
/// place: of a list, only what it counts; clearing the rest would take longer than finding it.
template <class Parts, class May>
void list_parts(const Parts& parts, const ShortList& among, const May& may, ShortList& found) {
  found.all = among.all && parts.size() > ShortList::kMost, found.count = 0;
  if (found.all) return;
  visit_parts(parts, among, [&](int i, const auto& part) {
    if (may(part)) found.numbers[std::size_t(found.count++)] = i;
    return false;
  });
}

/// Finds the surfaces that may hide a lamp of the light from a point of the region.
template <Real R>
void find_suspects(const Plan<R>& plan, const Source<R>& source, const HitRegion& region,
                   Suspects& suspects) {
  if (region.empty || source.lamps.empty()) {
    suspects = {};
    return;
  }
  const Hull hull = hull_of(region, source);
  // A solid seen from outside does not hide lamps that its surface faces. The sample code does not
  // ask which side a lamp is on.
  suspects.own = plan.sample_code || region.inside;
  const auto may = [&](const auto& part) {
    return (suspects.own || part.object != region.object) && hull.may_meet(in_double(part.shape));
  };
  list_parts(plan.spheres, {}, may, suspects.spheres);
  list_parts(plan.boxes, {}, may, suspects.boxes);
  list_parts(plan.planes, {}, may, suspects.planes);
  suspects.triangles = !plan.triangles.empty() && hull.may_meet(in_double(plan.mesh_ball));
}

// ---- One hit ---------------------------------------------------------------------------------

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

/// Finds those among some surfaces that may hide a lamp of the light from a point that is asked
/// for.
template <Real R, Value V>
void find_suspects(const Plan<R>& plan, const Source<R>& source, const Hit<V>& hit,
                   const Mask<V>& asked, const Suspects& among, Suspects& suspects) {
  suspects.own = among.own;
  if (among.empty()) {
    suspects.triangles = false;
    suspects.spheres.all = suspects.boxes.all = suspects.planes.all = false;
    suspects.spheres.count = suspects.boxes.count = suspects.planes.count = 0;
    return;
  }
  const Sightlines<V> lines = sightlines(source.ball, hit);
  // A point amid the lamps is in no cone.
  const Mask<V> certain = asked & (lines.length > R(2) * lines.radius);
  const Mask<V> uncertain = asked & !certain;
  const auto meets = [&](const auto& shape) {
    return uncertain | (certain & lines.may_meet(shape));
  };
  const auto solid = [&](const auto& part) {
    const Mask<V> others = asked & !sees(hit, part.object);
    if (!suspects.own && none_of(others)) return false;
    return any_of((suspects.own ? asked : others) & meets(ball_around(part.shape)));
  };
  list_parts(plan.spheres, among.spheres, solid, suspects.spheres);
  list_parts(plan.boxes, among.boxes, solid, suspects.boxes);
  list_parts(
      plan.planes, among.planes,
      [&](const auto& part) {
        const Mask<V> others = asked & !sees(hit, part.object);
        return any_of(others) && any_of(others & meets(part.shape));
      },
      suspects.planes);
  suspects.triangles = among.triangles && !plan.triangles.empty() && any_of(meets(plan.mesh_ball));
}

}  // namespace litmus

// shaft.cpp: separating planes, blocked corners, and outlines.
#include "tracer/shaft.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace litmus {
namespace {

using V3 = Vec<double>;

constexpr double kMargin = 1e-12;  // of the distances: far above the rounding of a few operations
constexpr int kFewestSides = 4;     // of the polygon for an arc across the base

V3 least(const V3& a, const V3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
V3 largest(const V3& a, const V3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// Without the care for cancellation that value.h's cross takes: the margins cover it.
V3 plain_cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Shaft::Axis axis_of(const V3& normal, const std::array<V3, 4>& corners) {
  Shaft::Axis axis{normal, std::sqrt(dot(normal, normal)), 0, 0};
  for (const V3& corner : corners) {
    const double at = dot(normal, corner);
    axis.low = std::min(axis.low, at), axis.high = std::max(axis.high, at);
  }
  return axis;
}

/// Whether an object that spans center -+ radius along some axis of the shaft lies beside it.
template <class Center, class Radius>
bool beside(const Shaft& shaft, double margin, Center center, Radius radius) {
  for (const Shaft::Axis& axis : shaft.axes) {
    const double at = center(axis), half = radius(axis) + margin * axis.length;
    if (at - half > axis.high || at + half < axis.low) return true;
  }
  return false;
}

V3 middle(const BoxSurface<double>& box) { return 0.5 * box.min + 0.5 * box.max; }
V3 half_size(const BoxSurface<double>& box) { return 0.5 * box.max - 0.5 * box.min; }
double half_width(const V3& half, const V3& normal) {
  return std::fabs(half.x * normal.x) + std::fabs(half.y * normal.y) + std::fabs(half.z * normal.z);
}

bool beside(const Shaft& shaft, const BoxSurface<double>& box, double margin) {
  const V3 center = middle(box), half = half_size(box);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] - margin > shaft.max[axis] || box.max[axis] + margin < shaft.min[axis])
      return true;
  }
  return beside(
      shaft, margin, [&](const Shaft::Axis& axis) { return dot(axis.normal, center); },
      [&](const Shaft::Axis& axis) { return half_width(half, axis.normal); });
}

double margin_of(const BoxSurface<double>& box) {
  return kMargin * (max_abs(box.min) + max_abs(box.max));
}

bool contains_apex(const BoxSurface<double>& box, double margin) {
  for (int axis = 0; axis < 3; ++axis)
    if (box.min[axis] > margin || box.max[axis] < -margin) return false;
  return true;
}

/// Calls use(normal) for each plane through the apex and an edge of the box that has all of the box
/// on its inner side; normal points inwards, of any length. Stops when `use` returns true.
template <class Use>
bool for_each_silhouette_plane(const BoxSurface<double>& box, Use use) {
  const V3 center = middle(box), half = half_size(box);
  const double margin = margin_of(box);
  for (int along = 0; along < 3; ++along) {
    const int s = (along + 1) % 3, t = (along + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      // The edge at (a, b) in the two other axes, as seen from the apex along the third.
      const double a = corner & 1 ? box.max[s] : box.min[s];
      const double b = corner & 2 ? box.max[t] : box.min[t];
      double n[3] = {};
      n[s] = -b, n[t] = a;
      V3 normal{n[0], n[1], n[2]};
      double at = dot(normal, center);
      if (at < 0) normal = -normal, at = -at;
      const double length = std::fabs(a) + std::fabs(b);
      if (length == 0 || at < half_width(half, normal) - margin * length) continue;
      if (use(normal, margin * length)) return true;
    }
  }
  return false;
}

/// Whether the plane through the apex that touches the sphere on the side of the nearest corner
/// parts it from the pyramid.
bool beyond_tangent_plane(const Shaft& shaft, const SphereSurface<double>& sphere) {
  const Direction<double> to = direction_of(sphere.center);
  V3 nearest;
  double best = -1;
  for (const V3& corner : shaft.corners) {
    const V3 unit = normalize(corner);
    if (dot(unit, to.unit) > best) best = dot(unit, to.unit), nearest = unit;
  }
  const V3 aside = normalize(nearest - best * to.unit);
  const double sine = sphere.radius / to.length;
  const V3 normal = sine * to.unit - std::sqrt((1 - sine) * (1 + sine)) * aside;
  return std::all_of(shaft.corners.begin(), shaft.corners.end(), [&](const V3& corner) {
    return dot(normal, corner) < -kMargin * (max_abs(corner) + to.length);
  });
}

bool all_corners_meet(const Shaft& shaft, const auto& object) {
  return std::all_of(shaft.corners.begin(), shaft.corners.end(), [&](const V3& corner) {
    const Chord<double> chord = intersect(object, Ray<double>{{}, corner});
    return chord.enter <= chord.leave && chord.enter > kMargin && chord.enter < 1 - kMargin;
  });
}

bool inside(const SphereSurface<double>& sphere, const V3& point) {
  const V3 apart = point - sphere.center;
  return dot(apart, apart) < sphere.radius * sphere.radius * (1 - kMargin);
}

/// From inside a sphere: blocked if the base is outside, clear if it is inside.
Sight sight_out_of(const Shaft& shaft, const SphereSurface<double>& sphere) {
  const auto in = [&](const V3& corner) { return inside(sphere, corner); };
  if (std::all_of(shaft.corners.begin(), shaft.corners.end(), in)) return Sight::Clear;
  const double apart = direction_of(shaft.center - sphere.center).length;
  const double reach = direction_of(shaft.across).length + direction_of(shaft.up).length;
  return apart - reach > sphere.radius * (1 + kMargin) ? Sight::Blocked : Sight::Undecided;
}

Sight sight_out_of(const Shaft& shaft, const BoxSurface<double>& box) {
  V3 low = shaft.corners[0], high = low;
  for (const V3& corner : shaft.corners) low = least(low, corner), high = largest(high, corner);
  bool in = true;
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = margin_of(box);
    if (low[axis] > box.max[axis] + margin || high[axis] < box.min[axis] - margin)
      return Sight::Blocked;
    in = in && low[axis] > box.min[axis] + margin && high[axis] < box.max[axis] - margin;
  }
  return in ? Sight::Clear : Sight::Undecided;
}

/// Whether an object of that extent along the base's normal lies wholly on the apex's side of it.
bool before_base(const Shaft& shaft, double at, double half) {
  const Shaft::Axis& base = shaft.axes[4];
  const double plane = dot(base.normal, shaft.center);
  return plane > 0 ? at + half < plane : at - half > plane;
}

/// The angles around an axis through the apex, from `middle` to `side`, at which the pyramid lies.
struct Arc {
  V3 middle, side;  ///< unit, orthogonal to the axis
  double first, last;
};

Arc arc_across(const Shaft& shaft, const V3& axis) {
  const V3 aside = shaft.center - dot(shaft.center, axis) * axis;
  const V3 any = std::fabs(axis.x) < 0.6 ? V3{1, 0, 0} : V3{0, 1, 0};
  const bool clear = max_abs(aside) > kMargin * max_abs(shaft.center);
  Arc arc{normalize(clear ? aside : any - dot(any, axis) * axis), {}, 0, 0};
  arc.side = plain_cross(axis, arc.middle);
  for (const V3& corner : shaft.corners) {
    const double x = dot(corner, arc.middle), y = dot(corner, arc.side);
    if (!(x > 0)) return {arc.middle, arc.side, -std::numbers::pi, std::numbers::pi};
    const double angle = std::atan2(y, x);
    arc.first = std::min(arc.first, angle), arc.last = std::max(arc.last, angle);
  }
  return arc;
}

}  // namespace

Shaft shaft_to(const V3& center, const V3& across, const V3& up) {
  Shaft shaft;
  shaft.center = center, shaft.across = across, shaft.up = up;
  const V3 low = center - up, high = center + up;
  shaft.corners = {low - across, low + across, high + across, high - across};
  for (std::size_t i = 0; i < 4; ++i)
    shaft.axes[i] =
        axis_of(plain_cross(shaft.corners[i], shaft.corners[(i + 1) % 4]), shaft.corners);
  shaft.axes[4] = axis_of(plain_cross(across, up), shaft.corners);
  for (const V3& corner : shaft.corners) {
    shaft.min = least(shaft.min, corner), shaft.max = largest(shaft.max, corner);
  }
  return shaft;
}

Sight sight_past(const Shaft& shaft, const SphereSurface<double>& sphere) {
  const double apart = direction_of(sphere.center).length;
  if (apart < sphere.radius * (1 + kMargin)) return sight_out_of(shaft, sphere);
  if (beside(
          shaft, kMargin * (apart + sphere.radius),
          [&](const Shaft::Axis& axis) { return dot(axis.normal, sphere.center); },
          [&](const Shaft::Axis& axis) { return sphere.radius * axis.length; })) {
    return Sight::Clear;
  }
  if (beyond_tangent_plane(shaft, sphere)) return Sight::Clear;
  return all_corners_meet(shaft, sphere) ? Sight::Blocked : Sight::Undecided;
}

Sight sight_past(const Shaft& shaft, const BoxSurface<double>& box) {
  const double margin = margin_of(box);
  if (contains_apex(box, margin)) return sight_out_of(shaft, box);
  if (beside(shaft, box, margin)) return Sight::Clear;
  const bool apart = for_each_silhouette_plane(box, [&](const V3& normal, double limit) {
    return std::all_of(shaft.corners.begin(), shaft.corners.end(),
                       [&](const V3& corner) { return dot(normal, corner) < -limit; });
  });
  if (apart) return Sight::Clear;
  return all_corners_meet(shaft, box) ? Sight::Blocked : Sight::Undecided;
}

Sight sight_past(const Shaft& shaft, const PlaneSurface<double>& plane) {
  const double apex = dot(plane.normal, plane.point);  // the plane's height over the apex
  const double margin = kMargin * (std::fabs(apex) + max_abs(plane.point));
  bool above = true, below = true;
  for (const V3& corner : shaft.corners) {
    const double height = dot(plane.normal, corner) - apex;
    above = above && height > margin, below = below && height < -margin;
  }
  if ((!above && !below) || std::fabs(apex) <= margin) return Sight::Undecided;
  return above == (apex < 0) ? Sight::Clear : Sight::Blocked;
}

bool may_meet(const Shaft& shaft, const V3& a, const V3& b) {
  const double margin = kMargin * (max_abs(a) + max_abs(b));
  const V3 center = 0.5 * a + 0.5 * b, half = 0.5 * b - 0.5 * a;
  if (beside(
          shaft, margin, [&](const Shaft::Axis& axis) { return dot(axis.normal, center); },
          [&](const Shaft::Axis& axis) { return std::fabs(dot(axis.normal, half)); })) {
    return false;
  }
  // The plane through the apex and the edge.
  const V3 plane = plain_cross(a, b);
  const double limit = kMargin * (max_abs(a) * max_abs(b));
  bool left = true, right = true;
  for (const V3& corner : shaft.corners) {
    const double at = dot(plane, corner), none = limit * max_abs(corner);
    left = left && at > none, right = right && at < -none;
  }
  return !left && !right;
}

bool may_meet(const Shaft& shaft, const BoxSurface<double>& box) {
  return !beside(shaft, box, margin_of(box));
}

HiddenPart hidden_part(const Shaft& shaft, const SphereSurface<double>& sphere, double widest) {
  const Direction<double> to = direction_of(sphere.center);
  if (to.length <= sphere.radius || !before_base(shaft, dot(shaft.axes[4].normal, sphere.center),
                                                 sphere.radius * shaft.axes[4].length)) {
    return {};
  }
  const double sine = sphere.radius / to.length, cosine = std::sqrt((1 - sine) * (1 + sine));
  const Arc arc = arc_across(shaft, to.unit);
  const double wanted = std::ceil((arc.last - arc.first) / widest);
  const int count = int(std::clamp(wanted, double(kFewestSides), double(kMostSides)));
  const double half = (arc.last - arc.first) / (2 * count);
  // The cone of tangents is where sine (axis.d) > cosine (outwards.d) for every way outwards.
  const HalfPlane along_axis = above(shaft, sine * to.unit);
  std::array<HalfPlane, kMostSides> outwards;
  for (int i = 0; i < count; ++i) {
    const double angle = arc.first + (2 * i + 1) * half;
    outwards[std::size_t(i)] = above(
        shaft, (cosine * std::cos(angle)) * arc.middle + (cosine * std::sin(angle)) * arc.side);
  }
  const auto polygon = [&](double size) {
    ConvexSet set;
    for (int i = 0; i < count; ++i) {
      const HalfPlane& out = outwards[std::size_t(i)];
      set.add({size * along_axis.constant - out.constant, size * along_axis.along_u - out.along_u,
               size * along_axis.along_v - out.along_v});
    }
    return set;
  };
  Polygon around = Polygon::square(), within = around;
  around.clip(polygon(1)), within.clip(polygon(std::cos(half)));
  return {polygon(std::sqrt(half / std::tan(half))), (around.area() - within.area()) / 4};
}

HiddenPart hidden_part(const Shaft& shaft, const BoxSurface<double>& box) {
  const V3& base = shaft.axes[4].normal;
  HiddenPart part;
  if (contains_apex(box, margin_of(box)) ||
      !before_base(shaft, dot(base, middle(box)), half_width(half_size(box), base))) {
    return part;
  }
  for_each_silhouette_plane(box, [&](const V3& normal, double) {
    part.set.add(above(shaft, normal));
    return false;
  });
  return part;
}

HiddenPart hidden_part(const Shaft& shaft, const PlaneSurface<double>& plane) {
  const double apex = dot(plane.normal, plane.point);
  HalfPlane behind = above(shaft, apex > 0 ? plane.normal : -plane.normal);
  behind.constant -= std::fabs(apex);
  HiddenPart part;
  part.set.add(behind);
  return part;
}

HalfPlane above(const Shaft& shaft, const V3& normal) {
  return {dot(normal, shaft.center), dot(normal, shaft.across), dot(normal, shaft.up)};
}

SeenEdge seen_edge(const Shaft& shaft, const V3& a, const V3& b) {
  const V3 normal = plain_cross(a, b);
  return {above(shaft, normal), above(shaft, plain_cross(normal, a)),
          above(shaft, plain_cross(b, normal))};
}

bool may_cross(const Polygon& polygon, const SeenEdge& edge) {
  bool left = false, right = false, after = false, before = false;
  for (const Corner& corner : polygon.corners()) {
    const double side = edge.line.at(corner);
    left = left || side > 0, right = right || side < 0;
    after = after || edge.after_start.at(corner) > 0;
    before = before || edge.before_end.at(corner) > 0;
  }
  return left && right && after && before;
}

}  // namespace litmus

// lights.h: how much light arrives at a point, and from where (slides 8-20).
#pragma once

#include <vector>

#include "scene/scene.h"
#include "tracer/value.h"

namespace litmus {

// ---- Point light, slide 11 -------------------------------------------------------------------

/// Linear attenuation l = R / (R + L d), slide 11, as 1 / (1 + L x) with x = d / R.
/// x and L are dimensionless and >= 0. Exactly 1 where L = 0, even for infinite x.
template <Real R>
R linear_attenuation(R x, R linear) {
  return linear == 0 ? R(1) : 1 / (1 + linear * x);
}

/// Quadratic attenuation q = R^2 / (R^2 + Q d^2), slide 11, as 1 / (1 + (Q x) x) with x = d / R:
/// the slide's own form overflows in a third of the float range. Exactly 1 where Q = 0.
template <Real R>
R quadratic_attenuation(R x, R quadratic) {
  return quadratic == 0 ? R(1) : 1 / (1 + (quadratic * x) * x);
}

// ---- Spot light, slide 16 --------------------------------------------------------------------

/// The angle between two vectors of any length, in radians, 0 to pi. atan2 of cross and dot
/// product, because the arccosine of the dot product is not a number on the axis of a fifth of all
/// spots.
template <Real R>
R angle_between(const Vec<R>& a, const Vec<R>& b) {
  using std::atan2;
  return atan2(direction_of(cross(a, b)).length, dot(a, b));
}

/// Spot decay 1 - (alpha / cutoff)^exponent, slide 16; 0 past the cutoff and for exponent 0.
/// alpha in [0, pi], cutoff in (0, pi], radians; exponent >= 0. By expm1, and near the cutoff by
/// log1p, where the slide's form loses all digits.
template <Real R>
R spot_decay(R alpha, R cutoff, R exponent) {
  using std::expm1, std::log, std::log1p;
  if (alpha > cutoff || exponent == 0) return 0;
  if (alpha == 0) return 1;
  const R log_ratio =
      alpha > cutoff / 2 ? R(log1p((alpha - cutoff) / cutoff)) : R(log(alpha / cutoff));
  return -expm1(exponent * log_ratio);
}

// ---- Area light, slide 20 --------------------------------------------------------------------

template <Real R>
struct AreaFrame {
  Vec<R> normal, right, up;  ///< orthonormal
};

/// The rectangle's axes, slide 20: right = up x n with up = (0,0,1), which is (-n.y, n.x, 0)
/// without rounding; for a vertical n that is zero, and right = (1,0,0). A given `right` is made
/// perpendicular to n. Without a normal, n points from the light to the origin.
template <Real R>
AreaFrame<R> area_frame(const AreaLight& light) {
  const Vec<R> n = normalize(light.normal ? Vec<R>(*light.normal) : -Vec<R>(light.point.origin));
  Vec<R> right{1, 0, 0};
  if (light.right) {
    const Vec<R> wanted = normalize(Vec<R>(*light.right));
    right = normalize(wanted - dot(wanted, n) * n);
  } else if (n.x != 0 || n.y != 0) {
    right = normalize(Vec<R>{-n.y, n.x, 0});
  }
  return {n, right, cross(n, right)};
}

/// Where sample i of n lies along a side of length 1, from -1/2 to 1/2; antisymmetric in i without
/// rounding.
template <Real R>
R grid_position(int i, int n, Placement placement) {
  if (n == 1) return 0;
  const R twice = R(2 * i + 1 - n);
  return placement == Placement::Centres ? twice / R(2 * n) : twice / R(2 * (n - 1));
}

/// The grid of point lights that stands for the rectangle, row by row.
template <Real R>
std::vector<Vec<R>> area_samples(const AreaLight& light) {
  const AreaFrame<R> frame = area_frame<R>(light);
  std::vector<Vec<R>> samples;
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.columns; ++column) {
      const R x = grid_position<R>(column, light.columns, light.placement) * R(light.width);
      const R y = grid_position<R>(row, light.rows, light.placement) * R(light.height);
      samples.push_back(Vec<R>(light.point.origin) + x * frame.right + y * frame.up);
    }
  }
  return samples;
}

// ---- Any light, seen from a point ------------------------------------------------------------

/// One source of light, ready for the kernel: the sun, a point or spot light, or one sample of an
/// area light.
template <Real R>
struct Lamp {
  bool directional = false, attenuated = false, cone = false;
  Vec<R> origin;  ///< scene units; unused by a directional lamp
  Vec<R> toward;  ///< directional: unit vector towards the light
  R range{1}, linear{}, quadratic{};
  Vec<R> axis;  ///< cone: the way the spot looks, unit
  R cutoff{}, exponent{};
};

/// Light that reaches a point, before anything stands in its way.
template <Real R>
struct Incident {
  Vec<R>
      direction;  ///< unit, from the point towards the light; zero where the light is at the point
  R distance{};   ///< scene units, infinite for a directional lamp
  R intensity{};  ///< attenuation times decay, 0 to 1
  bool in_cone = true;
};

/// Light that reaches `point` from `lamp`, as a fraction of its intensity.
template <Real R>
Incident<R> incident(const Lamp<R>& lamp, const Vec<R>& point) {
  // Aim at the lamp; a directional one is the same everywhere.
  if (lamp.directional) return {lamp.toward, std::numeric_limits<R>::infinity(), R(1), true};
  const Direction<R> to_lamp = direction_of(lamp.origin - point);
  Incident<R> light{to_lamp.unit, to_lamp.length, R(1), true};

  // Weaken with distance, as far as this lamp does.
  if (lamp.attenuated) {
    const R x = light.distance / lamp.range;
    light.intensity = linear_attenuation(x, lamp.linear) * quadratic_attenuation(x, lamp.quadratic);
  }

  // Narrow to the cone: nothing past the cutoff, a smooth edge before it.
  if (lamp.cone) {
    const R alpha = angle_between(lamp.axis, -light.direction);
    light.in_cone = alpha <= lamp.cutoff;
    light.intensity = light.intensity * spot_decay(alpha, lamp.cutoff, lamp.exponent);
  }
  return light;
}

}  // namespace litmus

// lights.h: how much light arrives at a point, and from where (slides 8-20).
#pragma once

#include <vector>

#include "scene/scene.h"
#include "tracer/vector_math.h"

namespace litmus {

// ---- Point light, slide 11 -------------------------------------------------------------------

/// Linear attenuation l = R / (R + L d), slide 11, as 1 / (1 + L x) with x = d / R.
/// x and L are dimensionless and >= 0. Exactly 1 where L = 0 or x = 0, even if the other is
/// infinite. At most 4 ulp from quad precision for R, d in 1e-300..1e300 (float: 1e-36..1e36).
template <Value V>
V linear_attenuation(const V& x, const V& linear) {
  const Mask<V> none = (linear == Scalar<V>(0)) | (x == Scalar<V>(0));
  return select(none, V(Scalar<V>(1)), V(Scalar<V>(1) / (Scalar<V>(1) + linear * x)));
}

/// Quadratic attenuation q = R^2 / (R^2 + Q d^2), slide 11, as 1 / (1 + (Q x) x) with x = d / R:
/// the slide's own form overflows in a third of the float range. Exactly 1 where Q = 0 or x = 0.
/// At most 5 ulp from quad precision, in the same domain.
template <Value V>
V quadratic_attenuation(const V& x, const V& quadratic) {
  const Mask<V> none = (quadratic == Scalar<V>(0)) | (x == Scalar<V>(0));
  return select(none, V(Scalar<V>(1)), V(Scalar<V>(1) / (Scalar<V>(1) + (quadratic * x) * x)));
}

// ---- Spot light, slide 16 --------------------------------------------------------------------

/// The angle between two vectors of any length, in radians, 0 to pi. atan2 of cross and dot
/// product, because the arccosine of the dot product is not a number on the axis of a fifth of all
/// spots. At most 5 ulp from quad precision for lengths of 1e-6..1e6.
template <Value V>
V angle_between(const Vec<V>& a, const Vec<V>& b) {
  return atan2_of(direction_of(cross(a, b)).length, dot(a, b));
}

/// Spot decay 1 - (alpha / cutoff)^exponent, slide 16; 0 from the cutoff on and for exponent 0.
/// alpha in [0, pi], cutoff in (0, pi], radians; exponent >= 0, infinity included. By expm1, and
/// near the cutoff by log1p, where the slide's form loses all digits: at most 4 ulp from quad
/// precision for exponents of 1e-6..1e6.
template <Value V>
V spot_decay(const V& alpha, const V& cutoff, const V& exponent) {
  using R = Scalar<V>;
  // Both logarithms stay in their domain where the other one is taken.
  const Mask<V> outer = alpha > cutoff * R(0.5);
  const V log_outer = log1p_of(select(outer, V((alpha - cutoff) / cutoff), V(R(0))));
  const V log_inner = log_of(select(outer, V(R(1)), V(alpha / cutoff)));
  const V decay = -expm1_of(V(exponent * select(outer, log_outer, log_inner)));
  const Mask<V> dark = (alpha >= cutoff) | (exponent == R(0));
  return select(dark, V(R(0)), select(alpha == R(0), V(R(1)), decay));
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
  bool everything = false;  ///< evaluate both attenuations and the cone, whether or not they matter
  Vec<R> origin;            ///< scene units; of a directional lamp without a meaning
  Vec<R> toward;            ///< directional: unit vector towards the light
  R range{1}, linear{}, quadratic{};
  Vec<R> axis;  ///< cone: the way the spot looks, unit
  R cutoff{}, exponent{};
  R outside{-2};  ///< cone: surely_outside(cutoff)
};

/// Light that reaches a point, before anything stands in its way.
template <Value V>
struct Incident {
  Vec<V>
      direction;  ///< unit, from the point towards the light; zero where the light is at the point
  V distance{};   ///< scene units, infinite for a directional lamp
  V intensity{};  ///< attenuation times decay, 0 to 1
  Mask<V> in_cone = true;
};

/// The cosine of the angle off the axis below which a point is outside of the cone whatever the
/// rounding: cheaper to ask for than the angle.
template <Real R>
R surely_outside(R cutoff) {
  using std::cos;
  return R(cos(cutoff)) - 32 * kUnit<R>;
}

/// Where the lamp is, seen from `point`; nothing weakens it yet. `doubt` as for direction_of().
template <Value V>
Incident<V> aim(const Lamp<Scalar<V>>& lamp, const Vec<V>& point, Doubt<V>* doubt = nullptr) {
  using R = Scalar<V>;
  Incident<V> light{Vec<V>(lamp.toward), V(std::numeric_limits<R>::infinity()), V(R(1)), true};
  if (!lamp.directional) {
    const Direction<V> to_lamp = direction_of<Divide::Once>(Vec<V>(lamp.origin) - point, doubt);
    light.direction = to_lamp.unit, light.distance = to_lamp.length;
  }
  return light;
}

/// Weakens the light with distance, as far as this lamp does.
template <Value V>
void attenuate(const Lamp<Scalar<V>>& lamp, Incident<V>& light) {
  using R = Scalar<V>;
  const V x = light.distance / lamp.range;
  V linear = R(1), quadratic = R(1);
  if (lamp.linear != R(0) || lamp.everything) linear = linear_attenuation(x, V(lamp.linear));
  if (lamp.quadratic != R(0) || lamp.everything) {
    quadratic = quadratic_attenuation(x, V(lamp.quadratic));
  }
  light.intensity = light.intensity * (linear * quadratic);
}

/// The angle of `point` off the axis of a spot. Near the cutoff, where the decay is small, it needs
/// the last half unit of the direction.
template <Value V>
V cone_angle(const Lamp<Scalar<V>>& lamp, const Vec<V>& point) {
  return angle_between(Vec<V>(lamp.axis), -normalize(Vec<V>(lamp.origin) - point));
}

/// Narrows the light at `point` to the cone: nothing past the cutoff, a smooth edge before it.
template <Value V>
void narrow(const Lamp<Scalar<V>>& lamp, const Vec<V>& point, Incident<V>& light) {
  const V alpha = cone_angle(lamp, point);
  light.in_cone = alpha <= lamp.cutoff;
  light.intensity = light.intensity * spot_decay(alpha, V(lamp.cutoff), V(lamp.exponent));
}

/// Where the light may be inside of the cone.
template <Value V>
Mask<V> may_be_in_cone(const Lamp<Scalar<V>>& lamp, const Incident<V>& light) {
  return !(dot(Vec<V>(lamp.axis), -light.direction) < lamp.outside);
}

/// Light that reaches `point` from `lamp`, as a fraction of its intensity.
template <Value V>
Incident<V> incident(const Lamp<Scalar<V>>& lamp, const Vec<V>& point) {
  Incident<V> light = aim(lamp, point);
  if (lamp.attenuated) attenuate(lamp, light);
  if (lamp.cone) narrow(lamp, point, light);
  return light;
}

}  // namespace litmus

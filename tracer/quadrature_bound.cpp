// quadrature_bound.cpp: the largest value in a complex neighbourhood, and what follows from it.
#include "tracer/quadrature_bound.h"

#include <algorithm>
#include <cmath>

namespace litmus {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Of the nodes of 1 to 4 points: the factor for Gauss's rule; the largest sum of |l_i(x)|, which
/// is at x = 1; and how far the interpolant of the first Chebyshev polynomial that is not its own
/// is off.
struct Nodes {
  double whole, lebesgue, first;
};
constexpr std::array<Nodes, kMostPoints> kNodes{{{16 / 3., 1, 1},
                                                 {64 / 15., 1.7321, 4 / 3.},
                                                 {64 / 15., 2.3334, 8 / 5.},
                                                 {64 / 15., 2.8552, 64 / 35.}}};

/// What the vectors to the points of a piece have in common.
struct Reach {
  double nearest;      ///< distance over that of the centre
  double slant;        ///< largest |cosine| with a side
  double turn, angle;  ///< how far l differs from the centre's: length, radians
  double sum2;         ///< at least |l + e|^2
  double low, high;    ///< of |n - h|
};

Reach reach_of(const LightPatch& patch) {
  const double spread = std::sqrt(patch.across * patch.across + patch.up * patch.up);
  const double flat = 1 - 2 * patch.slant * (patch.across + patch.up);
  Reach reach{};
  reach.nearest = std::max({0.0, 1 - spread, std::sqrt(std::max(0.0, flat))});
  reach.slant = std::min(1.0, (patch.slant + std::max(patch.across, patch.up)) / reach.nearest);
  const double cosine = std::sqrt(std::max(0.0, 1 - spread * spread));
  reach.turn = spread < 1 ? std::sqrt(2 - 2 * cosine) : 2;
  reach.angle = spread < 1 ? std::asin(spread) : 4;
  if (!patch.shiny) return reach;
  reach.sum2 = std::max(0.0, 2 + 2 * dot(patch.l, patch.e) - 2 * reach.turn);
  const double apart = direction_of(patch.n - normalize(patch.l + patch.e)).length;
  const double moves = reach.angle / std::sqrt(reach.sum2);
  reach.low = std::max(0.0, apart - moves), reach.high = std::min(2.0, apart + moves);
  return reach;
}

double weakened(const LightPatch& patch, double distance) {
  const double x = patch.distance * distance / patch.lamp.range;
  return patch.lamp.attenuated ? linear_attenuation(x, patch.lamp.linear) *
                                     quadratic_attenuation(x, patch.lamp.quadratic)
                               : 1.0;
}

/// Upper bound of x^n.
double power_bound(double x, double n) { return std::exp(n * (x - 1)); }

/// Bounds of |D| and |S| where the vector to the light differs from one to the piece by `delta` of
/// its length, in complex coordinates.
Terms<double> bounds_within(const LightPatch& patch, const Reach& reach, double delta) {
  const double q = 2 * delta * reach.slant + delta * delta;
  if (!(q < 1)) return {kUnbounded, kUnbounded};
  const double eta = 1 - std::sqrt(1 - q), lambda = (delta + eta) / (1 - eta);
  const double most = weakened(patch, reach.nearest * (1 - eta));
  const double cosine = std::min(1.0, std::fabs(dot(patch.l, patch.n)) + reach.turn);
  Terms<double> bound{most * (cosine + lambda), 0};
  if (!patch.shiny) return bound;
  bound.specular = kUnbounded;
  if (!(2 * lambda < reach.sum2)) return bound;
  const double theta = 1 - std::sqrt(1 - 2 * lambda / reach.sum2);
  const double epsilon = (lambda / std::sqrt(reach.sum2) + theta) / (1 - theta);
  if (!((reach.high + epsilon) * (reach.high + epsilon) < 2)) return bound;
  const double t = std::clamp(epsilon, reach.low, reach.high);
  const double real = 1 - (t * t - 2 * t * epsilon - epsilon * epsilon) / 2;
  const double imaginary = reach.high * epsilon + epsilon * epsilon / 2;
  bound.specular = most * power_bound(real * real + imaginary * imaginary, patch.shininess / 2);
  return bound;
}

Terms<double> largest_within(const LightPatch& patch, const Reach& reach) {
  const double most = weakened(patch, reach.nearest);
  const double cosine = std::clamp(dot(patch.l, patch.n) + reach.turn, 0.0, 1.0);
  return {most * cosine,
          patch.shiny ? most * power_bound(1 - reach.low * reach.low / 2, patch.shininess) : 0};
}

}  // namespace

QuadratureBounds quadrature_bounds(const LightPatch& patch, Region region) {
  const Reach reach = reach_of(patch);
  QuadratureBounds best{largest_within(patch, reach), {}};
  // Both the value and its estimate lie between 0 and the largest term.
  best.error.fill(best.largest);
  if (!(reach.nearest > 0)) return best;
  const double side = std::max(patch.across, patch.up) / reach.nearest;
  for (const double delta : {0.5, 0.3, 0.15, 0.06, 0.02}) {
    const double half_width = delta / side;  // of the ellipse: (rho - 1/rho) / 2
    const double rho = half_width + std::sqrt(half_width * half_width + 1);
    const double shrink = 1 / rho, outside = 1 / (rho - 1);
    const Terms<double> most = bounds_within(patch, reach, delta);
    double power = shrink;  // rho^-points
    for (int points = 1; points <= kMostPoints; ++points, power *= shrink) {
      const Nodes& nodes = kNodes[std::size_t(points - 1)];
      const double spread = 1 + nodes.lebesgue;
      // Half of the factor for the whole is the error of a mean over [-1, 1], in two directions.
      const double factor = region == Region::Whole
                                ? nodes.whole * power * power / (1 - shrink * shrink)
                                : 2 * power * spread * (nodes.first + spread * outside);
      Terms<double>& bound = best.error[std::size_t(points - 1)];
      bound.diffuse = std::min(bound.diffuse, factor * most.diffuse);
      if (patch.shiny) bound.specular = std::min(bound.specular, factor * most.specular);
    }
  }
  return best;
}

}  // namespace litmus

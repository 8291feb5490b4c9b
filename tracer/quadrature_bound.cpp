// quadrature_bound.cpp: the largest value in a complex neighbourhood, and what follows from it.
#include "tracer/quadrature_bound.h"

#include <algorithm>
#include <cmath>

namespace litmus {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Bounds of |D| and |S| where the vector to the light differs from that to the centre by `delta`
/// of its length, in complex coordinates.
Terms<double> bounds_within(const LightPatch& patch, double delta) {
  const double q = 2 * delta + delta * delta;
  if (!(q < 1)) return {kUnbounded, kUnbounded};
  const double eta = 1 - std::sqrt(1 - q), lambda = (delta + eta) / (1 - eta);
  const double x = patch.distance * (1 - eta) / patch.lamp.range;
  const double weakened = patch.lamp.attenuated ? linear_attenuation(x, patch.lamp.linear) *
                                                      quadratic_attenuation(x, patch.lamp.quadratic)
                                                : 1.0;
  Terms<double> bound{weakened * (dot(patch.l, patch.n) + lambda), 0};
  if (!patch.shiny) return bound;
  const double above = dot(patch.l + patch.e, patch.n), below = 2 + 2 * dot(patch.l, patch.e);
  bound.specular =
      lambda < above && 2 * lambda < below
          ? weakened * std::pow((above + lambda) / std::sqrt(below - 2 * lambda), patch.shininess)
          : kUnbounded;
  return bound;
}

}  // namespace

Terms<double> largest_terms(const LightPatch& patch) {
  const double delta = patch.across + patch.up;
  Terms<double> bound = bounds_within(patch, delta);
  // Slide 5's terms are at most 1 of what arrives.
  const double x = std::max(0.0, patch.distance * (1 - delta)) / patch.lamp.range;
  const double most = patch.lamp.attenuated ? linear_attenuation(x, patch.lamp.linear) *
                                                  quadratic_attenuation(x, patch.lamp.quadratic)
                                            : 1.0;
  return {std::clamp(bound.diffuse, 0.0, most), patch.shiny ? std::min(bound.specular, most) : 0.0};
}

std::array<Terms<double>, kMostPoints> quadrature_bounds(const LightPatch& patch) {
  // Both the value and its estimate lie between 0 and the largest term.
  std::array<Terms<double>, kMostPoints> best;
  best.fill(largest_terms(patch));
  const double side = std::max(patch.across, patch.up);
  for (const double reach : {0.35, 0.2, 0.1, 0.04, 0.01}) {
    const double axis = (reach - side) / side;  // of the ellipse: (rho + 1/rho) / 2
    if (!(axis > 1)) break;
    const double rho = axis + std::sqrt(axis * axis - 1), shrink = 1 / (rho * rho);
    const Terms<double> most = bounds_within(patch, reach);
    double power = shrink / (1 - shrink);  // rho^(-2 points) / (1 - rho^-2)
    for (int points = 1; points <= kMostPoints; ++points, power *= shrink) {
      // Half of the factor is the error of a mean over [-1, 1]; there are two directions.
      const double factor = (points == 1 ? 16.0 / 3 : 64.0 / 15) * power;
      Terms<double>& bound = best[std::size_t(points - 1)];
      bound.diffuse = std::min(bound.diffuse, factor * most.diffuse);
      if (patch.shiny) bound.specular = std::min(bound.specular, factor * most.specular);
    }
  }
  return best;
}

}  // namespace litmus

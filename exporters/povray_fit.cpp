// povray_fit.cpp: least largest error, by the simplex method.
#include "exporters/povray_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace litmus::povray {
namespace {

constexpr int kSamples = 200;
constexpr double kDegree = std::numbers::pi / 180;

// The lowest point that the simplex of Nelder and Mead (1965) finds from `at`.
template <class F>
std::array<double, 3> descend(const std::array<double, 3>& at, const std::array<double, 3>& step,
                              const F& f) {
  using P = std::array<double, 3>;
  std::array<std::pair<double, P>, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    P p = at;
    if (i < 3) p[i] += step[i];
    corners[i] = {f(p), p};
  }
  const auto mix = [](const P& a, const P& b, double t) {
    return P{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  };
  constexpr int kSteps = 300;
  for (int i = 0; i < kSteps; ++i) {
    std::sort(corners.begin(), corners.end());
    const P middle =
        mix(mix(corners[0].second, corners[1].second, 0.5), corners[2].second, 1 / 3.0);
    auto& worst = corners[3];
    const auto attempt = [&](double t) {
      const P p = mix(middle, worst.second, t);
      return std::pair{f(p), p};
    };
    auto next = attempt(-1);
    if (next.first < corners[0].first) next = std::min(next, attempt(-2));
    if (!(next.first < corners[2].first)) next = attempt(0.5);
    if (next.first < worst.first) {
      worst = next;
      continue;
    }
    for (std::size_t k = 1; k < 4; ++k) {
      const P p = mix(corners[0].second, corners[k].second, 0.5);
      corners[k] = {f(p), p};
    }
  }
  return std::min_element(corners.begin(), corners.end())->second;
}

// Near the largest of many differences, but smooth.
struct Norm {
  double sum = 0, largest = 0;
  void add(double difference) {
    const double square = difference * difference;
    sum += square * square * square;
    largest = std::max(largest, std::abs(difference));
  }
};

double spotlight(const SpotFit& fit, double angle) {
  const double c = std::cos(angle);
  const double inner = std::cos(fit.radius * kDegree), outer = std::cos(fit.falloff * kDegree);
  if (c <= outer || c <= 0) return 0;
  const double t = c >= inner ? 1 : (c - outer) / (inner - outer);
  return std::pow(c, fit.tightness) * t * t * (3 - 2 * t);
}

Norm spot_norm(const SpotFit& fit, double cutoff, double exponent) {
  Norm norm;
  const double end = std::min(1.25 * cutoff, std::numbers::pi);
  for (int i = 0; i <= kSamples; ++i) {
    const double angle = end * i / kSamples;
    const double decay =
        angle > cutoff || exponent == 0 ? 0 : 1 - std::pow(angle / cutoff, exponent);
    norm.add(spotlight(fit, angle) - decay);
  }
  return norm;
}

Norm fade_norm(const FadeFit& fit, const Attenuation& a, double reach) {
  Norm norm;
  for (int i = 0; i <= kSamples; ++i) {
    const double d = reach * i / kSamples, x = d / a.range;
    const double exact = 1 / ((1 + a.linear * x) * (1 + a.quadratic * x * x));
    norm.add(2 * fit.factor / (1 + std::pow(d / fit.distance, fit.power)) - exact);
  }
  return norm;
}

}  // namespace

SpotFit fit_spot(double cutoff, double exponent) {
  const double degrees = std::min(cutoff / kDegree, 90.0);
  // Tightness in units that make the light fall to 1/e at the cutoff, or at 80 degrees.
  const double unit = -1 / std::log(std::cos(std::min(degrees, 80.0) * kDegree));
  const auto fit_of = [&](const std::array<double, 3>& p) {
    const double falloff = std::clamp(p[1] * degrees, 1e-3 * degrees, 90.0);
    return SpotFit{std::clamp(p[0], 0.0, 0.999) * falloff, falloff, std::abs(p[2]) * unit, 0};
  };
  const auto norm = [&](const std::array<double, 3>& p) {
    return spot_norm(fit_of(p), cutoff, exponent).sum;
  };
  std::pair<double, std::array<double, 3>> best{std::numeric_limits<double>::infinity(), {}};
  for (const double inner : {0.0, 0.3, 0.6, 0.9})
    for (const double tightness : {0.0, 1.0}) {
      const auto p = descend({inner, 1.0, tightness}, {0.1, 0.1, 0.5}, norm);
      best = std::min(best, {norm(p), p});
    }
  SpotFit fit = fit_of(best.second);
  fit.error = spot_norm(fit, cutoff, exponent).largest;
  return fit;
}

FadeFit fit_fade(const Attenuation& a, double reach) {
  if (a.linear == 0 && a.quadratic == 0) return {};
  if (a.quadratic == 0) return {0.5, a.range / a.linear, 1, 0};
  if (a.linear == 0) return {0.5, a.range / std::sqrt(a.quadratic), 2, 0};
  // Where l*q is a half, roughly, as a start.
  const double half = a.range / (a.linear + std::sqrt(a.quadratic));
  const auto fit_of = [&](const std::array<double, 3>& p) {
    return FadeFit{std::exp(p[0]), half * std::exp(p[1]), std::exp(p[2]), 0};
  };
  const auto norm = [&](const std::array<double, 3>& p) {
    return fade_norm(fit_of(p), a, reach).sum;
  };
  FadeFit fit = fit_of(descend({std::log(0.5), 0, std::log(2.0)}, {0.1, 0.3, -0.2}, norm));
  fit.error = fade_norm(fit, a, reach).largest;
  return fit;
}

}  // namespace litmus::povray

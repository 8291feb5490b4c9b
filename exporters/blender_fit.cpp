// blender_fit.cpp: least squares between the model's lights and Blender's lamps.
#include "exporters/blender_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "exporters/area_grid.h"

namespace litmus {
namespace {

double falloff(const Attenuation& a, double d) {
  const double x = d / a.range;
  return 1 / (1 + a.linear * x) / (1 + a.quadratic * x * x);
}

double angle(const Vector& a, const Vector& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double decay(double alpha, double cutoff, double exponent) {
  return alpha > cutoff ? 0 : 1 - std::pow(alpha / cutoff, exponent);
}

/// Least squares of model ~ gain * lamp.
LampFit least_squares(const std::vector<double>& model, const std::vector<double>& lamp) {
  double both = 0, square = 0;
  for (std::size_t i = 0; i < model.size(); ++i) {
    both += model[i] * lamp[i];
    square += lamp[i] * lamp[i];
  }
  if (!(square > 0)) return {};
  LampFit fit{both / square, 0};
  for (std::size_t i = 0; i < model.size(); ++i) {
    fit.rms += std::pow(model[i] - fit.gain * lamp[i], 2) / double(model.size());
  }
  fit.rms = std::sqrt(fit.rms);
  return fit;
}

}  // namespace

LampFit fit_distance(const Light& light, const std::vector<Point>& points) {
  std::vector<double> model, lamp;
  const auto add = [&](double wanted, double given) {
    if (!std::isfinite(given)) return;
    model.push_back(wanted), lamp.push_back(given);
  };
  const auto* spot = std::get_if<SpotLight>(&light.shape);
  const auto* area = std::get_if<AreaLight>(&light.shape);
  const double blend = spot ? fit_spot(spot->cutoff, spot->exponent).blend : 0;
  const std::vector<Point> samples = area ? area_samples(*area) : std::vector<Point>{};
  for (const Point& p : points) {
    if (area) {
      const GridAxes axes = grid_axes(*area);
      double wanted = 0, given = 0;
      for (const Point& sample : samples) {
        const Vector away = p - sample;
        const double d = glm::length(away);
        wanted += falloff(area->point.attenuation, d) / double(samples.size());
        given += std::max(glm::dot(away, axes.normal), 0.0) / (d * d * d) / double(samples.size());
      }
      add(wanted, given);
    } else {
      const PointLight& source = spot ? spot->point : std::get<PointLight>(light.shape);
      const double d = glm::distance(p, source.origin);
      const double alpha = spot ? angle(spot->direction, p - source.origin) : 0;
      if (spot && alpha > spot->cutoff) continue;
      add(falloff(source.attenuation, d) * (spot ? decay(alpha, spot->cutoff, spot->exponent) : 1),
          (spot ? blender_spot(alpha, spot->cutoff, blend) : 1) / (d * d));
    }
  }
  return least_squares(model, lamp);
}

double blender_spot(double alpha, double cutoff, double blend) {
  const double edge = std::cos(cutoff), smooth = (1 - edge) * blend;
  const double inside = std::cos(alpha) - edge;
  if (inside <= 0) return 0;
  const double t = smooth > 0 ? std::min(inside / smooth, 1.0) : 1;
  return std::cos(alpha) * t * t * (3 - 2 * t);
}

SpotFit fit_spot(double cutoff, double exponent) {
  constexpr int kBlends = 100, kAngles = 200;  // steps; the rms changes by under 1e-3 with more
  cutoff = std::min(cutoff, std::numbers::pi / 2);  // Blender's widest
  SpotFit best{0, 2};
  for (int b = 0; b <= kBlends; ++b) {
    const double blend = double(b) / kBlends;
    std::vector<double> model, lamp;
    for (int i = 0; i < kAngles; ++i) {
      // Rings of equal solid angle.
      const double alpha = std::acos(1 - (i + 0.5) / kAngles * (1 - std::cos(cutoff)));
      model.push_back(decay(alpha, cutoff, exponent));
      lamp.push_back(blender_spot(alpha, cutoff, blend));
    }
    const double rms = least_squares(model, lamp).rms;
    if (rms < best.rms) best = {blend, rms};
  }
  return best;
}

}  // namespace litmus

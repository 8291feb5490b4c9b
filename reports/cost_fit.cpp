// cost_fit.cpp: least squares in logarithms, and a bootstrap.
#include "reports/cost_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace litmus {
namespace {

constexpr double kLeastKnob = 4;
constexpr int kResamples = 2000;

/// Slope of log error over log knob; nothing if all knobs are the same.
std::optional<double> slope(std::span<const KnobError> curve) {
  double mean_x = 0, mean_y = 0;
  for (const KnobError& p : curve) {
    mean_x += std::log(p.knob) / double(curve.size());
    mean_y += std::log(p.error) / double(curve.size());
  }
  double xx = 0, xy = 0;
  for (const KnobError& p : curve) {
    xx += std::pow(std::log(p.knob) - mean_x, 2);
    xy += (std::log(p.knob) - mean_x) * (std::log(p.error) - mean_y);
  }
  if (xx < 1e-12) return std::nullopt;
  return xy / xx;
}

}  // namespace

CostFit fit_order(std::span<const KnobError> given) {
  std::vector<KnobError> curve;
  std::copy_if(given.begin(), given.end(), std::back_inserter(curve),
               [](const KnobError& p) { return p.error > 0 && p.knob > 0; });
  CostFit fit;
  if (curve.size() < 3) return fit;
  const std::optional<double> order = slope(curve);
  if (!order) return fit;
  fit.order = *order;
  fit.points = int(curve.size());
  std::mt19937 engine(1);
  std::vector<double> slopes;
  std::vector<KnobError> sample(curve.size());
  for (int i = 0; i < kResamples; ++i) {
    for (KnobError& p : sample) p = curve[engine() % curve.size()];
    if (const std::optional<double> one = slope(sample)) slopes.push_back(*one);
  }
  std::sort(slopes.begin(), slopes.end());
  fit.low = slopes[slopes.size() / 40], fit.high = slopes[slopes.size() - 1 - slopes.size() / 40];
  return fit;
}

std::vector<CostFit> fit_orders(const CostSeries& series, const CostFigures& truth_error) {
  std::vector<CostFit> fits;
  for (const CostRegion region : kCostRegions) {
    for (const ErrorMetric metric : kErrorMetrics) {
      const auto truth = truth_error.find(region);
      const double floor = truth == truth_error.end() ? 0 : 3 * truth->second[std::size_t(metric)];
      std::vector<KnobError> curve;
      for (const CostPoint& point : series.points) {
        const auto errors = point.errors.find(region);
        if (errors == point.errors.end() || point.knob < kLeastKnob) continue;
        const double error = errors->second[std::size_t(metric)];
        if (error >= floor) curve.push_back({point.knob, error});
      }
      CostFit fit = fit_order(curve);
      fit.region = region, fit.metric = metric;
      if (fit.points > 0) fits.push_back(fit);
    }
  }
  return fits;
}

}  // namespace litmus

// error_metric.cpp: the three metrics.
#include "tracer/error_metric.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace litmus {

std::string_view metric_name(ErrorMetric metric) {
  static constexpr std::string_view kNames[] = {"max", "p99", "rms"};
  return kNames[std::size_t(metric)];
}

std::vector<double> pixel_errors(const Picture& ours, const Picture& truth) {
  std::vector<double> errors(ours.pixels.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const glm::dvec3 apart = glm::abs(ours.pixels[i] - truth.pixels[i]);
    errors[i] = std::max({apart.x, apart.y, apart.z});
  }
  return errors;
}

double error_of(std::vector<double> errors, ErrorMetric metric) {
  if (errors.empty()) return 0;
  if (metric == ErrorMetric::Max) return *std::max_element(errors.begin(), errors.end());
  if (metric == ErrorMetric::Rms) {
    double squares = 0;
    for (const double error : errors) squares += error * error;
    return std::sqrt(squares / double(errors.size()));
  }
  const std::size_t rank = (errors.size() * 99 + 99) / 100 - 1;
  std::nth_element(errors.begin(), errors.begin() + std::ptrdiff_t(rank), errors.end());
  return errors[rank];
}

}  // namespace litmus

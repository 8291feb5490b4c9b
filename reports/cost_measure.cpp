// cost_measure.cpp: comparing pictures by region, and timing in turns.
#include "reports/cost_measure.h"

#include <algorithm>
#include <cmath>

#include "tracer/cpu_clock.h"

namespace litmus {
namespace {

constexpr int kWidth = 96, kQuickWidth = 48;
constexpr double kLong = 1;         // seconds: such settings are repeated less often
constexpr double kUnsteady = 0.05;  // of the least time

double seconds_of(const CostJob& job) {
  const double start = cpu_seconds();
  const Picture picture = job.render();
  return cpu_seconds() - start;
}

}  // namespace

std::vector<CostRegion> regions_of(const Rendering& rendering) {
  std::vector<CostRegion> regions(rendering.whole.pixels.size(), CostRegion::All);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::uint8_t seen = 0;
    for (const auto& flags : rendering.flags) seen |= flags[i];
    const bool lit = seen & kLit, umbra = seen & kUmbra;
    if (seen & kPenumbra) {
      regions[i] = CostRegion::Penumbra;
    } else if (lit || umbra) {
      regions[i] = umbra ? CostRegion::Umbra : CostRegion::Lit;
    }
  }
  return regions;
}

CostFigures figures(const Picture& picture, const CostTruth& truth) {
  const std::vector<double> errors = pixel_errors(picture, truth.picture);
  CostFigures result;
  for (const CostRegion region : kCostRegions) {
    std::vector<double> inside;
    for (std::size_t i = 0; i < errors.size(); ++i)
      if (region == CostRegion::All || truth.regions[i] == region) inside.push_back(errors[i]);
    if (inside.empty()) continue;
    CostErrors& row = result[region];
    for (const ErrorMetric metric : kErrorMetrics)
      row[std::size_t(metric)] = error_of(inside, metric);
  }
  return result;
}

CostTruth converged(const Rendering& coarse, const Rendering& fine, double share) {
  CostTruth truth{fine.whole, regions_of(fine), {}};
  truth.own_error = figures(coarse.whole, truth);
  for (auto& [region, errors] : truth.own_error)
    for (double& error : errors) error *= share;
  return truth;
}

Scene cost_sized(Scene scene, const CostOptions& options) {
  int width = options.width;
  if (width == 0) width = std::min(scene.width, options.quick ? kQuickWidth : kWidth);
  scene.height = std::max(1, int(std::lround(double(scene.height) * width / scene.width)));
  scene.width = width;
  return scene;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

CostTime time_of(std::vector<double> seconds) {
  CostTime time;
  if (seconds.empty()) return time;
  time.repeats = int(seconds.size());
  time.least = *std::min_element(seconds.begin(), seconds.end());
  time.median = median(seconds);
  for (double& one : seconds) one = std::fabs(one - time.median);
  time.spread = median(seconds);
  return time;
}

void measure(CostTopic& topic, const std::vector<CostJob>& jobs, const CostTruth& truth,
             const CostOptions& options) {
  const auto point_of = [&](const CostJob& job) -> CostPoint& {
    return topic.series[job.series].points[job.point];
  };
  for (const CostJob& job : jobs) point_of(job).errors = figures(job.render(), truth);

  std::vector<std::vector<double>> seconds(jobs.size());
  const auto take_turns = [&](int repeats, const auto& wanted) {
    for (int repeat = 0; repeat < repeats; ++repeat)
      for (std::size_t i = 0; i < jobs.size(); ++i)
        if (wanted(i)) seconds[i].push_back(seconds_of(jobs[i]));
  };
  const auto is_long = [&](std::size_t i) { return !seconds[i].empty() && seconds[i][0] > kLong; };
  take_turns(kFewCostRepeats, [](std::size_t) { return true; });
  if (!options.quick) {
    take_turns(kCostRepeats - kFewCostRepeats, [&](std::size_t i) { return !is_long(i); });
    std::vector<bool> unsteady(jobs.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const CostTime time = time_of(seconds[i]);
      unsteady[i] = !is_long(i) && time.spread > kUnsteady * time.least;
    }
    take_turns(kCostRepeats, [&](std::size_t i) { return unsteady[i]; });
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) point_of(jobs[i]).time = time_of(seconds[i]);
}

}  // namespace litmus

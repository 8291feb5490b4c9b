// cost_measure.h: errors and times of settings, one apart from the other.
#pragma once

#include <functional>
#include <vector>

#include "reports/cost_study.h"
#include "tracer/render.h"

namespace litmus {

/// What settings are measured against.
struct CostTruth {
  Picture picture;
  std::vector<CostRegion>
      regions;  ///< of each pixel: Lit, Penumbra, Umbra, or All for none of them
  CostFigures own_error;
};

/// One setting: which point of a topic it is, and how to render it.
struct CostJob {
  std::size_t series, point;
  std::function<Picture()> render;
};

/// By the lights' flags. A pixel that nothing reaches is in no region but All.
std::vector<CostRegion> regions_of(const Rendering& rendering);

CostFigures figures(const Picture& picture, const CostTruth& truth);

/// The finer of two pictures as the truth; its own error is `share` of their difference.
CostTruth converged(const Rendering& coarse, const Rendering& fine, double share);

/// How often settings are measured in turn; --quick, and those that take over a second: less.
inline constexpr int kCostRepeats = 7, kFewCostRepeats = 3;

/// The scene at the width that costs are measured at: the options', else its own or 96 (--quick:
/// 48), whichever is less.
Scene cost_sized(Scene scene, const CostOptions& options);

/// Of some values; of an even number the mean of the two in the middle. There is one.
double median(std::vector<double> values);

/// Least, median and median absolute deviation.
CostTime time_of(std::vector<double> seconds);

/// Fills in the errors and times of the jobs' points (see measure_cost).
void measure(CostTopic& topic, const std::vector<CostJob>& jobs, const CostTruth& truth,
             const CostOptions& options);

}  // namespace litmus

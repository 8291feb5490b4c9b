// cost_study.h: measures what accuracy costs.
#pragma once

#include <filesystem>
#include <functional>

#include "reports/cost.h"

namespace litmus {

struct CostOptions {
  bool quick = false;       ///< fewer settings, 3 repeats, a smaller picture
  bool references = false;  ///< POV-Ray and Blender on the same axes
  int width = 0;  ///< of the picture, its shape kept; 0: the scene's, at most 96 (quick: 48)
  std::filesystem::path work;                        ///< scratch folder, for the references
  std::function<void(const std::string&)> progress;  ///< may be empty
};

/// The topics that the scene has: area lights ("area"), the filter over a pixel ("pixel"), and
/// arithmetic ("precision").
///
/// Errors are measured once, times apart from them: every setting once for warming up, then all in
/// turn, 7 times (3 where one takes over a second), in one thread, by processor time; where the
/// median deviates by more than 5 % of the least time, once more as often. POV-Ray's seconds are
/// the processor time of tracing that it prints, Cycles' the time of rendering that it prints, in
/// one thread each.
CostStudy measure_cost(const Scene& scene, const CostOptions& options);

/// What a reader may take from the figures, in words.
std::vector<std::string> cost_sentences(const CostStudy& study);

}  // namespace litmus

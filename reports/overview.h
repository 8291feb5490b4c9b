// overview.h: what the writers say about many rows at once.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "reports/study.h"

namespace litmus {

/// Counts and worst figures over some rows. Pointers point into the study.
struct Tally {
  int rows = 0, passed = 0, failed = 0, skipped = 0;
  int live = 0, stored = 0, computed = 0;
  std::int64_t nonfinite = 0;
  std::int64_t over = 0,
               explained = 0;  ///< edge pixels over their tolerance; those with a known cause
  const Comparison* interior = nullptr;  ///< the interior row with the largest max_abs
  const Comparison* largest = nullptr;   ///< the row of any region with the largest max_abs
  const Comparison* mean = nullptr;      ///< the interior row with the largest mean_abs
  const Comparison* edge = nullptr;      ///< the edge row with the largest max_abs
  const Comparison* failure = nullptr;   ///< the failed row that is furthest over its tolerance
};

/// Adds up the rows for which `wanted` is true. Skipped rows have no figures.
Tally tally(const Study& study, const std::function<bool(const Comparison&)>& wanted);

/// "fail" before "skipped" before "pass"; "" where there is no row.
std::string verdict_of(const Tally& tally);

/// "live", "stored", "live and stored", "computed" where there are closed forms only, or "" where
/// nothing was compared.
std::string source_of(const Tally& tally);

/// How far a row is over what it may be: the larger of max_abs / tolerance and mean_abs /
/// mean_tolerance. Infinite where a pixel is not finite or a picture is missing.
double excess(const Comparison& row);

/// In order of first appearance.
std::vector<std::string> references_of(const Study& study);

/// Those that occur, in the order directional, point, spot, area, ambient, all, then any other.
std::vector<std::string> light_types_of(const Study& study);

/// The row of one light, reference and region, or nullptr.
const Comparison* find_row(const Study& study, const std::string& scene, const std::string& light,
                           const std::string& reference, const std::string& region);

/// The failed rows, the furthest over its tolerance first. Rows of the layer "all" come last,
/// because they repeat what a light's own row says.
std::vector<const Comparison*> failures_of(const Study& study);

/// The case of a scene; nullptr if there is none.
const Case* find_case(const Study& study, const std::string& scene);

/// The scenes with a failed row, the furthest over its tolerance first; then those with a skipped
/// row, then the rest, in study order.
std::vector<const Case*> cases_by_verdict(const Study& study);

/// Seconds of rendering alone over some scenes: ours, then each reference's, where it drew them.
std::vector<double> seconds_of(std::span<const Case> cases,
                               const std::vector<std::string>& references);

/// "whole" for "all"; a light type's name, or "ambient", itself.
std::string light_type_title(const std::string& light_type);

/// "POV-Ray" for "povray"; the name itself if no driver has it.
std::string reference_title(const std::string& reference);

/// The verdict in plain words: "Everything agrees", "2 of 412 comparisons disagree", ...
std::string headline(const Study& study);

}  // namespace litmus

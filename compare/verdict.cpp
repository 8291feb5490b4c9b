// verdict.cpp: the gates.
#include "compare/verdict.h"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace litmus {

Verdict judge(const Difference& d, const Tolerance& tolerance, std::int64_t explained) {
  std::vector<std::string> failures;
  if (d.nonfinite > 0)
    failures.push_back(fmt::format("{} of {} pixels are NaN or infinite", d.nonfinite, d.pixels));
  if (d.pixels == 0 && !tolerance.may_be_empty)
    failures.push_back("the region has no pixels, so nothing was compared");
  const bool all_explained = d.over_tolerance > 0 && explained >= d.over_tolerance;
  if (!all_explained && !(d.max_abs <= tolerance.max_abs))
    failures.push_back(fmt::format(
        "the largest difference {:.3g} at ({}, {}) is over {}; {} of {} "
        "pixels are",
        d.max_abs, d.max_at[0], d.max_at[1], tolerance.max_abs, d.over_tolerance, d.pixels));
  if (!all_explained && !(d.mean_abs <= tolerance.mean_abs))
    failures.push_back(
        fmt::format("the mean difference {:.3g} is over {}", d.mean_abs, tolerance.mean_abs));
  if (!failures.empty()) return {false, fmt::format("{}", fmt::join(failures, "; "))};
  if (!all_explained) return {true, ""};
  return {true, fmt::format("{} pixels are over {}, each listed with its cause", d.over_tolerance,
                            tolerance.max_abs)};
}

Verdict combine(const Verdict& interior, const Verdict& edge) {
  return combine(
      std::array{RegionVerdict{Region::Interior, interior}, RegionVerdict{Region::Edge, edge}});
}

Verdict combine(std::span<const RegionVerdict> regions) {
  std::vector<std::string> failures;
  for (const auto& [region, verdict] : regions)
    if (!verdict.pass) failures.push_back(fmt::format("{}: {}", name_of(region), verdict.reason));
  return {failures.empty(), fmt::format("{}", fmt::join(failures, "; "))};
}

}  // namespace litmus

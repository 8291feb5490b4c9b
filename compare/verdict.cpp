// verdict.cpp: the table of tolerances and the gates.
#include "compare/verdict.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "scene/refusal.h"

namespace litmus {
namespace {

constexpr std::array<NamedTolerance, 4> kTolerances{{
    {"povray",
     Region::Interior,
     {2e-6, 1e-7, "16-bit PNG with a residual pass resolves 2^-32; POV-Ray's own epsilons remain"}},
    {"povray",
     Region::Edge,
     {1e-3, 1e-3, "the two tracers offset their shadow rays differently", true}},
    {"blender",
     Region::Interior,
     {2e-5, 5e-7,
      "Cycles computes in single precision: a rounding of 6e-8 grows along the shading"}},
    {"blender",
     Region::Edge,
     {1e-3, 1e-3, "single-precision intersections move an edge by a part of a pixel", true}},
}};

}  // namespace

std::span<const NamedTolerance> tolerances() { return kTolerances; }

Tolerance find_tolerance(std::string_view reference, Region region) {
  const Region judged = region == Region::Interior ? Region::Interior : Region::Edge;
  for (const NamedTolerance& row : kTolerances)
    if (row.reference == reference && row.region == judged) return row.tolerance;
  throw Refusal(
      fmt::format("there is no tolerance for the reference '{}'; there is one for povray "
                  "and one for blender",
                  reference));
}

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
  if (interior.pass && edge.pass) return {true, ""};
  if (interior.pass) return {false, "edge: " + edge.reason};
  if (edge.pass) return {false, "interior: " + interior.reason};
  return {false, "interior: " + interior.reason + "; edge: " + edge.reason};
}

}  // namespace litmus

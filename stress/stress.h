// stress.h: what an experiment on hard cases is asked and what it answers.
//
// Every experiment runs litmus's own formulas and rays over a stated domain, with quad precision or
// geometry as the oracle, and beside them, on the same samples, code as it is usually written: the
// control. A row holds if litmus keeps the bound and the control does not, so that a zero means
// something.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace litmus {

/// Errors over equal parts of the domain, robust against naive.
struct StressCurve {
  std::string y_label;                ///< what is plotted, such as "ulp"
  bool logarithmic = true;            ///< of the errors
  std::string x_label;                ///< the domain's coordinate, such as "log10 of x = d / R"
  double low = 0, high = 1;           ///< of the coordinate; the bins divide it evenly
  std::vector<double> robust, naive;  ///< per bin; infinite where the result is not finite
};

/// One figure with its bound and its control.
struct StressRow {
  std::string id;      ///< "alpha-double": unique
  std::string group;   ///< "formulas", "rays", "meshes" or "pictures"
  std::string what;    ///< "angle to the axis of a spot"
  std::string scalar;  ///< "float" or "double"
  std::string domain;  ///< in words
  std::string metric;  ///< what is counted: "ulp", "false shadows", ...
  std::uint64_t samples = 0;
  double seen = 0;          ///< infinite if a result was not finite
  double bound = 0;         ///< seen must be <= bound
  std::string control;      ///< what the control does
  double control_seen = 0;  ///< must be > bound
  bool judged = true;       ///< false: for information
  std::optional<StressCurve> curve{};
};

/// seen <= bound < control_seen; always true of a row that is not judged.
bool holds(const StressRow& row);

struct StressOptions {
  std::uint64_t samples = 2'000'000;  ///< of each formula and scalar
  std::uint64_t rays = 10'000'000;    ///< of each experiment with rays and scalar
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// alpha, decay, l, q, specular, the frame and the light sum: errors in ulp.
std::vector<StressRow> stress_formulas(const StressOptions& options);
/// Surfaces that shadow themselves, occluders that are missed, lamps shadowed by their own wall.
std::vector<StressRow> stress_shadows(const StressOptions& options);
/// Rays through the shared edges and vertices of closed meshes, in two builds.
std::vector<StressRow> stress_leaks(const StressOptions& options);
/// Pixels that are not finite over hostile scenes, and pictures under four rounding modes.
std::vector<StressRow> stress_pictures(const StressOptions& options);

/// All of them, in this order. Deterministic: the same rows for the same options, on any number of
/// threads.
std::vector<StressRow> run_stress(const StressOptions& options);

}  // namespace litmus

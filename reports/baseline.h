// baseline.h: a run against an earlier one: what is new, worse, fixed, gone or slower.
#pragma once

#include <string>
#include <vector>

namespace litmus {

struct Comparison;
struct Study;

/// A row grew worse where a figure (max_abs or mean_abs) is over kNoiseFactor times the baseline's
/// plus kNoiseShare of what is allowed. Our side is bit-identical on every machine, so what varies
/// is the reference's arithmetic, to which its tolerances are tied. Measured over the canonical
/// scenes with Blender's kernels for AVX2 against those for AVX, SSE4.1 and SSE2, the widest change
/// a machine makes: 671 of 1229 rows differ, the largest ratio of a figure is 1.955, and no figure
/// is over 0.9 of the limit.
inline constexpr double kNoiseFactor = 2;
inline constexpr double kNoiseShare = 1.0 / 32;

/// The largest figure that is no worse than `was`, where `allowed` passes.
double noise_limit(double was, double allowed);

/// We are slower where our seconds over those of every reference that was rendered in both runs
/// grew by this factor. Machines differ, and shared ones are busy: a run never fails by it. A
/// single scene, which takes milliseconds, also has to lose kSlowerSeconds.
inline constexpr double kSlowerAll = 2, kSlowerScene = 4, kSlowerSeconds = 0.05;

/// One row that changed.
struct BaselineChange {
  /// "new failure" | "worse" | "missing" (was compared, now is not) | "fixed"
  std::string kind;
  std::string scene, reference, light, light_type, region;
  std::string figure;       ///< "max_abs", "mean_abs" or "nonfinite": what says so
  double was = 0, now = 0;  ///< that figure; `was` is 0 for a row that the baseline lacks
  double limit = 0;         ///< what `now` may be at most
  std::string why;          ///< the row's reason, or what differs, in words
};

struct SpeedChange {
  std::string scene;        ///< or "all"
  std::string reference;    ///< whose seconds ours are measured in
  double was = 0, now = 0;  ///< our seconds over the reference's
};

/// A renderer that is not the baseline's.
struct VersionChange {
  std::string reference, was, now;
};

struct BaselineReport {
  std::string file;
  int compared = 0;       ///< rows in both runs
  int still_failing = 0;  ///< of those, failing in both and not worse
  int added = 0;          ///< rows that the baseline lacks
  /// In the order of kinds above, each furthest over its limit first. A row of all lights or all
  /// regions is left out where it repeats what a light's or a region's own row says.
  std::vector<BaselineChange> changes;
  std::vector<SpeedChange> slower;
  std::vector<VersionChange> versions;
};

/// Compares a study with the results of an earlier one (read_results), over the scenes and
/// references of both. Rows for information are left out.
BaselineReport against_baseline(const Study& study, const Study& baseline, const std::string& file);

/// Whether a run with this baseline has to fail: a new failure or a row that is worse.
bool is_regression(const BaselineReport& report);

/// "2 new failures, 1 worse, 3 fixed; 765 rows as before".
std::string baseline_headline(const BaselineReport& report);

/// One sentence each, plain text.
std::string sentence_of(const BaselineChange& change);
std::string sentence_of(const SpeedChange& change);
std::string sentence_of(const VersionChange& change);

}  // namespace litmus

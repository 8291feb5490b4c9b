// study.h: a study, that is scenes x references x lights, as complete values for the writers.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/registration.h"
#include "compare/triage.h"
#include "reference/candidate.h"
#include "reference/closed_form.h"
#include "reference/obtain.h"
#include "reports/baseline.h"
#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

inline constexpr int kResultsSchemaVersion = 1;

/// Whose error a failing row is: its worst pixels, judged by renders in quad precision (blame.h).
struct Blame {
  std::string verdict;  ///< "ours" | "the reference's" | "ill-conditioned"
  int pixels = 0;       ///< looked at; each counts in one of the three
  int ours = 0;         ///< our value is farther from the truth
  int theirs = 0;       ///< theirs is
  /// A boundary at the pixel's centre has our value on one side, theirs on the other.
  int ill_conditioned = 0;
  /// The largest distances from the truth, where well conditioned.
  double our_error = 0, their_error = 0;
};

/// One row of results.json: one light of one scene against one reference in one region.
struct Comparison {
  std::string scene;       ///< canonical name or file stem
  std::string reference;   ///< "povray" | "blender" | "closed-form"
  std::string source;      ///< "live" | "stored" | "computed" (closed forms) | "" (skipped)
  std::string light;       ///< the light's name, "ambient" or "all"
  std::string light_type;  ///< "directional" | "point" | "spot" | "area" | "ambient" | "all"
  /// "interior" | "edge" | "all", or of a light "lit" | "penumbra" | "umbra" | "highlight"; of a
  /// closed form that is no picture, its name (scene/expect.h)
  std::string region;
  std::int64_t pixels = 0;
  std::int64_t nonfinite = 0;  ///< pixels that are NaN or infinite in either picture
  double bias = 0;             ///< mean of ours - theirs over pixels and channels
  double mean_abs = 0;
  double max_abs = 0;
  std::array<int, 2> max_at{0, 0};  ///< x, y of the largest difference
  double rmse = 0;
  double p50 = 0, p95 = 0, p99 = 0, p999 = 0;  ///< percentiles of |ours - theirs|
  double max_relative = 0;                     ///< largest |ours - theirs| / max(|theirs|, 1e-3)
  std::int64_t over_tolerance = 0;             ///< pixels beyond the tolerance
  std::int64_t explained = 0;  ///< of those, boundary pixels whose cause is known (see `causes`)
  double tolerance = 0;        ///< on max_abs
  double mean_tolerance = 0;   ///< on mean_abs
  std::string verdict;         ///< "pass" | "fail" | "skipped"
  std::string reason;  ///< why it failed or was skipped, or what a pass rests on; may be empty
  std::string hint;  ///< of a failure: a factor or an encoding that would explain it; may be empty
  std::vector<std::string> causes;  ///< one sentence per listed pixel
  /// Of a failure: the one source that all others disagree with; may be empty.
  std::string suspect;
  std::optional<Triage> triage;  ///< of failing whole pictures (light and region "all") only
  /// Of a renderer's failing rows with pixels over the tolerance; RGB only.
  std::optional<Blame> blame;
  /// Of a spectral scene the bands where the row is worst, such as "580-610 nm"; its figures are
  /// of the values per band. Empty for RGB.
  std::string bands{};
  std::string against = "litmus";  ///< whose picture stands for `ours`: litmus, or a reference
};

/// What one light adds, by litmus and by each reference.
struct CaseLayer {
  struct Theirs {
    std::string reference, source;
    Picture picture;  ///< empty (0 x 0) if there is none
  };
  std::string light, light_type;
  Picture ours;
  std::vector<std::uint8_t> edge;  ///< 1 where the pixel is an edge, width * height
  std::vector<Theirs> theirs;
  std::vector<Theirs> aside;          ///< pictures of Study::informative, which nobody judges
  std::vector<std::uint8_t> flags{};  ///< what the light does there (scene/picture.h); may be empty
  ExpectedLayer exact{};  ///< what closed forms say of it; 0 x 0 where they say nothing
};

struct CaseReference {
  std::string reference, source;  ///< source as in Comparison
  std::string version, command;   ///< of the renderer
  double seconds = 0;             ///< rendering alone, as the renderer reports it
  std::string failure, log;       ///< log: the end of its text; empty when all is well
  Registration registration{};    ///< of our whole picture and theirs; see `unregistered`
  Layers bands{};  ///< of a spectral scene what was obtained (reference/band_images.h)
};

struct Case {
  std::string scene, file, about;
  std::vector<std::string> tags, warnings;
  int width = 0, height = 0;
  double seconds = 0;  ///< ours, rendering alone
  std::vector<CaseReference> references;
  std::vector<CaseLayer> layers;  ///< ambient, each light, then "all"
  std::string control{};  ///< the mistake that was put into our side (controls.h); empty: none
};

/// Everything about a run that may differ between two runs of identical inputs.
struct Provenance {
  std::string litmus_version, commit, compiler, flags, cpu, system, command, started;
  int threads = 0;
  double seconds = 0;
  std::vector<std::array<std::string, 2>> versions;  ///< renderer or library, version
};

/// A candidate of the study.
struct CandidateNote {
  std::string name, encoding;
  double exposure = 1;
  std::string note;  ///< what its encoding cannot show, in words; may be empty
};

struct Study {
  Provenance provenance;
  std::vector<std::string> warnings;  ///< tolerances that allow too much, scenes left out
  std::vector<Case> cases;
  std::vector<Comparison> comparisons;
  /// Rows for information, which decide nothing: candidates that are expected to differ, the
  /// renderers' own lights, and every candidate against each reference (`against`). Their `verdict`
  /// says what it would be.
  std::vector<Comparison> informative;
  /// Each reference and closed form against each other one (`against`), layer by layer, interior
  /// only: what decides who the suspect is where a row fails.
  std::vector<Comparison> pairs;
  std::vector<CandidateNote> candidates;
  std::optional<BaselineReport> baseline;  ///< of a run that was given one
};

/// What a study compares, and where it takes the other side from.
struct StudyOptions {
  std::vector<std::string> references;  ///< driver names and "closed-form"; empty: all
  ObtainOptions obtain;
  std::vector<Candidate> candidates;
  bool native = false;  ///< measure the renderers' own lights, too
  std::string control;  ///< a negative control's name, or empty
  int threads = 0;      ///< of the tracer; 0: all
};

/// Renders the scenes, obtains the references (all renderers at once) and compares them, light by
/// light. Throws Refusal for an unknown reference or control.
Study run_study(std::span<const Scene> scenes, const StudyOptions& options);

/// "pass", "fail" (a row failed), "incomplete" (a row was skipped, none failed) or "broken" (a
/// renderer failed or is missing where it was asked for).
std::string overall_verdict(const Study& study);

}  // namespace litmus

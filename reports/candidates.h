// candidates.h: the sources of a study that are not its references: candidates, and the references'
// own lights.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/encoding.h"
#include "reports/study.h"

namespace litmus {

/// One candidate or native export, with a result for each scene.
struct ExtraSource {
  std::string name;
  Encoding encoding;
  bool judged = true;   ///< false: its rows are for information
  bool native = false;  ///< a renderer's own lights, which only litmus is compared with
  std::vector<ObtainedReference> results;
};

/// A candidate that computes in single precision is held to the tolerances of Blender, which does,
/// too; the rounding of its encoding comes on top.
inline constexpr const char* kToleranceOfCandidates = "blender";

/// Runs the candidates and, if asked for, the native exports, all at the same time.
std::vector<ExtraSource> obtain_extras(std::span<const Scene> scenes, const StudyOptions& options);

/// What to compare `ours` with: layer `index` of the images (behind the last one: their sum), moved
/// towards `ours` within the rounding of the encoding (nearest_that_rounds_to).
Picture theirs_beyond_rounding(const Picture& ours, const ObtainedReference& images,
                               std::size_t index, const Encoding& encoding);

/// A phrase for the row's reason: what has been left out of the difference. Empty for floats.
std::string rounding_note(const ObtainedReference& images, std::size_t index,
                          const Encoding& encoding);

/// One line of the table "for information": all scenes, one source and light type.
struct InformativeLine {
  std::string reference, light_type;
  /// The largest interior |difference| against litmus, POV-Ray and Blender, in the order of
  /// kAgainst; absent where nothing was compared.
  std::array<std::optional<double>, 3> largest;
  std::string scene;  ///< of the largest of them
};
inline constexpr std::array<const char*, 3> kAgainst{"litmus", "povray", "blender"};

/// What is measured and not judged, in order of source, then of light type as in
/// light_types_of(); a candidate's own rows against litmus are among them, to stand beside those
/// against the references.
std::vector<InformativeLine> informative_lines(const Study& study);

}  // namespace litmus

// blame.h: whose error a difference is, by renders in quad precision.
#pragma once

#include <span>
#include <string>

#include "reports/study.h"

namespace litmus {

/// Sets `blame` of a renderer's failing rows that have pixels: the worst of the differing pixels
/// are rendered again in quad precision, from `scenes` (as the references got them, in the study's
/// order). Spectral scenes, closed forms and candidates have none.
void add_blame(Study& study, std::span<const Scene> scenes);

/// One pixel's values of one layer, and the truth.
struct Witness {
  glm::dvec3 ours{0}, theirs{0}, truth{0};
  bool ill_conditioned = false;  ///< the truth jumps within kBoundaryPixels, to ours or theirs
};

/// The verdict of all witnesses: whoever is farther from the truth in more of them.
Blame judge_witnesses(std::span<const Witness> witnesses);

/// For people: "ours: in 6 of 6 pixels quad precision is nearer to POV-Ray's value (...)".
std::string blame_sentence(const Blame& blame, const std::string& reference_title);

}  // namespace litmus

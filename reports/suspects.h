// suspects.h: litmus, POV-Ray, Blender and closed forms, each against each: where one of them
// disagrees with all others, it is the suspect.
#pragma once

#include <span>

#include "reports/study.h"

namespace litmus {

/// Adds one row to `pairs` for `theirs` against each of the layer's references, over the pixels
/// where `skip` is 0. Two references may be as far apart as both of them may be from litmus. No row
/// where there is no pixel.
void compare_pairs(const Case& entry, const CaseLayer& layer, const CaseLayer::Theirs& theirs,
                   std::span<const std::uint8_t> skip, std::vector<Comparison>& pairs);

/// The case's references against each other, over the interior.
void compare_references(const Case& entry, Study& study);

/// Sets `suspect` on the failed rows of a light of a scene where one source fails with all others,
/// and these, two or more, agree with each other; their reason says so in a sentence.
void name_suspects(Study& study);

/// The largest difference of one pair over all scenes.
struct PairLine {
  std::string reference, against;
  double largest = 0;
  std::string scene, light;  ///< where it is
  int rows = 0, failed = 0;
};

/// Each pair of sources in order of first appearance, those with litmus first.
std::vector<PairLine> pair_lines(const Study& study);

}  // namespace litmus

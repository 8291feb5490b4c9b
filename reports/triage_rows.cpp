// triage_rows.cpp: finds the two pictures that a row is about.
#include "reports/triage_rows.h"

#include <algorithm>

namespace litmus {
namespace {

/// The whole pictures of a case, or nothing.
const CaseLayer* whole_of(const Study& study, const std::string& scene) {
  for (const Case& one : study.cases) {
    if (one.scene != scene) continue;
    for (const CaseLayer& layer : one.layers)
      if (layer.light == "all") return &layer;
  }
  return nullptr;
}

}  // namespace

void add_triage(Study& study) {
  for (Comparison& row : study.comparisons) {
    if (row.verdict != "fail" || row.light != "all" || row.region != "all") continue;
    const CaseLayer* whole = whole_of(study, row.scene);
    if (!whole) continue;
    const auto theirs = std::find_if(whole->theirs.begin(), whole->theirs.end(),
                                     [&](auto& each) { return each.reference == row.reference; });
    if (theirs == whole->theirs.end() || theirs->picture.width != whole->ours.width ||
        theirs->picture.height != whole->ours.height)
      continue;  // nothing to compare with: the row says why
    row.triage = triage(whole->ours, theirs->picture);
  }
}

}  // namespace litmus

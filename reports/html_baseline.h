// html_baseline.h: what report.html says to who decides: the baseline, and what can be approved, as
// data for the page's template.
#pragma once

#include <kainjow/mustache.hpp>

#include "reports/study.h"

namespace litmus {

/// Headline, changes in groups of one kind, and other versions; false where there is no baseline.
kainjow::mustache::data baseline_data(const Study& study);

/// What became slower, as sentences: part of the provenance, because times vary.
kainjow::mustache::data slower_data(const Study& study);

/// For each reference that a scene fails against: the command that approves it, or why none may.
kainjow::mustache::data approvals_data(const Study& study, const Case& one);

}  // namespace litmus

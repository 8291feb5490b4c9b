// html_baseline.h: the section of report.html on the baseline, as data for the page's template.
#pragma once

#include <kainjow/mustache.hpp>

#include "reports/study.h"

namespace litmus {

/// Headline, changes in groups of one kind, and other versions; false where there is no baseline.
kainjow::mustache::data baseline_data(const Study& study);

/// What became slower, as sentences: part of the provenance, because times vary.
kainjow::mustache::data slower_data(const Study& study);

}  // namespace litmus

// html_overview.h: the head of report.html, as data for the page's template.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>

#include "reports/study.h"

namespace litmus {

/// What was compared with what, as one sentence.
std::string lead_sentence(const Study& study);

/// The headline figures of one reference: its worst interior difference, and what is allowed.
kainjow::mustache::data reference_tile(const Study& study, const std::string& reference);

/// How much was compared.
kainjow::mustache::data counts_data(const Study& study);

/// How long each renderer took, scene by scene: "heads" and "rows".
kainjow::mustache::data took_data(const Study& study);

/// A small picture of each scene with its anchor.
kainjow::mustache::data thumbnails_data(const Study& study);

/// What fails, worst first: "rows", one for each light with the number of its other failed rows as
/// "more"; and "left", how many lights are not listed.
kainjow::mustache::data failures_data(const Study& study);

/// Which light types disagree and which do not, as a sentence; "" if all or none do. Whole pictures
/// are left out: they say once more what their lights say.
std::string guilty_types(const Study& study);

/// The renderers that failed, scene by scene.
kainjow::mustache::data broken_data(const Study& study);

/// The reasons for skipped rows, with their number.
kainjow::mustache::data skipped_data(const Study& study);

/// Litmus, references and closed forms, two by two: one row for each pair. Empty without a pair of
/// references.
kainjow::mustache::data pairs_data(const Study& study);

/// What is measured and not judged: one row for each source and light type.
kainjow::mustache::data informative_data(const Study& study);

/// The candidates, their encodings and what those cannot show.
kainjow::mustache::data candidates_data(const Study& study);

}  // namespace litmus

// write_markdown.h: summary.md, for a pull request or a job's page.
#pragma once

#include <filesystem>
#include <string>

#include "reports/study.h"

namespace litmus {

/// GitHub drops a job summary near 1 MiB without a word; the text stays below this.
inline constexpr std::size_t kMarkdownLimit = 900'000;

/// Verdict, failures first, a table of light type x reference, what was skipped, provenance, which alone
/// may differ where the inputs do not. No
/// pictures; at most kMarkdownLimit bytes: rows that do not fit are counted, and are in
/// results.json.
std::string markdown(const Study& study);

/// Writes markdown() to the file, whole or not at all. Throws Refusal naming the file.
void write_markdown(const Study& study, const std::filesystem::path& file);

}  // namespace litmus

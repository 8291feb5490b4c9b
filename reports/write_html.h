// write_html.h: report.html, the page that people open.
#pragma once

#include <filesystem>
#include <string>

#include "reports/html_shell.h"
#include "reports/study.h"

namespace litmus {

/// One self-contained page that opens from file:// and asks no network: verdict and headline
/// figures, what disagrees, a matrix scene x light type x reference, then per scene the pictures
/// (ours, theirs, their signed difference) and the figures per layer and region, and the
/// provenance, which is all that may differ where the inputs do not; links to the pages `beside`
/// it. Every string of the study is escaped; a page policy forbids inline handlers and network
/// requests besides.
std::string html(const Study& study, const std::vector<PageLink>& beside = {});

/// Writes html() to the file, whole or not at all, with links to what lies beside it (pages_in).
/// Throws Refusal naming the file.
void write_html(const Study& study, const std::filesystem::path& file);

}  // namespace litmus

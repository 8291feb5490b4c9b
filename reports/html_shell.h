// html_shell.h: small pages in the report's style, and which of them lie beside a report.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace litmus {

/// Any text for use between tags or in a quoted attribute: clean_text with & < > " ' escaped.
std::string html_text(std::string_view text);

/// A self-contained page in the report's style, dark and light, that links back to report.html and
/// asks no network. `title` and `lead` are plain text and get escaped; `body_html` goes between
/// <main> and </main> as it is (text in it through html_text; sections, .tiles, .scroll with
/// table.numbers, .note and .prose look as in the report, see web/page.css); `script`, if not
/// empty, is the page's only script: the page's policy forbids inline handlers, and pictures other
/// than data: addresses. Throws std::invalid_argument for a script that would end its element.
std::string small_page(std::string_view title, std::string_view lead, std::string_view body_html,
                       std::string_view script = {});

/// A page that another command writes beside the report.
struct PageLink {
  std::string file, title, about;
};

/// Those of stress.html, cost.html, peers.html and migration.html that exist in the folder.
std::vector<PageLink> pages_in(const std::filesystem::path& folder);

}  // namespace litmus

// html_shell.cpp: small pages in the report's style, and which of them lie beside a report.
#include "reports/html_shell.h"

#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "reports/html_case.h"
#include "reports/plain_text.h"
#include "reports/web_assets.h"

namespace litmus {

std::string html_text(std::string_view text) {
  std::string safe;
  for (const char c : clean_text(text)) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  return safe;
}

std::string small_page(std::string_view title, std::string_view lead, std::string_view body_html,
                       std::string_view script) {
  if (script.find("</script") != script.npos)
    throw std::invalid_argument("small_page: the script would end its element");
  kainjow::mustache::mustache shell{std::string(kShellTemplate)};
  if (!shell.is_valid()) throw std::logic_error("shell.html: " + shell.error_message());
  kainjow::mustache::data page;
  page.set("title", text_data(title));
  page.set("lead", text_data(lead));
  page.set("style", std::string(kPageStyle));
  page.set("body", std::string(body_html));
  page.set("script", script.empty() ? flag(false) : kainjow::mustache::data(std::string(script)));
  return shell.render(page);
}

std::vector<PageLink> pages_in(const std::filesystem::path& folder) {
  const PageLink known[] = {
      {"stress.html", "Stress", "What happens at the ends of the numbers"},
      {"cost.html", "Cost", "What accuracy and effects cost"},
      {"peers.html", "Peers", "How long litmus takes beside other renderers"},
      {"migration.html", "Migration", "The old version of a renderer beside the new one"}};
  std::vector<PageLink> found;
  for (const PageLink& page : known) {
    std::error_code unreadable;
    if (std::filesystem::is_regular_file(folder / page.file, unreadable)) found.push_back(page);
  }
  return found;
}

}  // namespace litmus

// write_html.cpp: report.html, the page that people open.
#include "reports/write_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "compare/statistics.h"
#include "compare/verdict.h"
#include "compare/whole_file.h"
#include "reports/gallery.h"
#include "reports/html_baseline.h"
#include "reports/html_case.h"
#include "reports/html_matrix.h"
#include "reports/html_overview.h"
#include "reports/overview.h"
#include "reports/page_data.h"
#include "reports/page_terms.h"
#include "reports/plain_text.h"
#include "reports/sample_code.h"
#include "reports/web_assets.h"
#include "reports/write_json.h"

namespace litmus {
namespace {
using kainjow::mustache::data;

// A report stays small enough to be sent by mail; some room is left for what wraps the terms.
constexpr std::size_t kMostBytes = 4'980'000;

data provenance_data(const Provenance& p) {
  data list{data::type::list};
  const auto add = [&](const std::string& name, const std::string& value) {
    if (value.empty()) return;
    data one;
    one.set("name", text_data(name));
    one.set("value", text_data(value));
    list.push_back(one);
  };
  add("litmus", p.litmus_version + (p.commit.empty() ? "" : ", commit " + p.commit));
  add("command", p.command);
  add("started", p.started);
  add("took", short_seconds(p.seconds));
  for (const auto& [name, version] : p.versions) add(name, version);
  add("processor", p.cpu.empty() ? "" : p.cpu + ", " + counted(p.threads, "thread", "threads"));
  add("system", p.system);
  add("compiler", p.compiler);
  add("flags", p.flags);
  return list;
}

data tolerances_data() {
  data list{data::type::list};
  for (const NamedTolerance& row : tolerances()) {
    data one;
    one.set("reference", text_data(reference_title(std::string(row.reference))));
    one.set("region", std::string(name_of(row.region)));
    one.set("max", short_number(row.tolerance.max_abs));
    one.set("mean", row.tolerance.mean_abs < row.tolerance.max_abs
                        ? short_number(row.tolerance.mean_abs)
                        : "");
    one.set("reason", std::string(row.tolerance.reason));
    list.push_back(one);
  }
  return list;
}

data rates_data() {
  data list{data::type::list};
  for (const MeasuredRate& rate : measured_rates()) {
    data one;
    one.set("what", text_data(rate.what));
    one.set("rate", fmt::format("{:.1f} %", 100 * rate.rate));
    one.set("runs", with_commas(rate.runs));
    one.set("seeds", std::to_string(rate.seeds));
    one.set("size", fmt::format("{0} \u00d7 {0}", rate.size));
    list.push_back(one);
  }
  return list;
}

data figures_data(const std::vector<GalleryFigure>& list) {
  data figures{data::type::list};
  for (const GalleryFigure& figure : list) {
    data panels{data::type::list};
    for (const GalleryPanel& panel : figure.panels) {
      data one;
      one.set("label", text_data(panel.label));
      one.set("uri", panel.uri.empty() ? flag(false) : data(panel.uri));
      one.set("svg", panel.svg);
      panels.push_back(one);
    }
    data shown;
    shown.set("slides", figure.slides);
    shown.set("title", figure.title);
    shown.set("caption", figure.caption);
    shown.set("panels", panels);
    figures.push_back(shown);
  }
  return figures;
}

// Elements that hold JSON, one for each case that has any.
std::string json_elements(const Study& study, std::string_view kind,
                          const std::vector<std::string>& texts) {
  std::string elements;
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (!texts[i].empty())
      elements += fmt::format("<script type=\"application/json\" id=\"{}-{}\">{}</script>\n", kind,
                              case_anchor(study, study.cases[i]), script_safe(texts[i]));
  return elements;
}

data links_data(const std::vector<PageLink>& beside) {
  data links{data::type::list};
  for (const PageLink& page : beside) {
    data one;
    one.set("file", text_data(page.file));
    one.set("title", text_data(page.title));
    one.set("about", text_data(page.about));
    links.push_back(one);
  }
  return links;
}

data page_data(const Study& study, const std::vector<PageLink>& beside) {
  const Tally all = tally(study, [](const Comparison&) { return true; });
  const std::string verdict = overall_verdict(study);
  data page;
  page.set("verdict", verdict);
  page.set("headline", text_data(headline(study)));
  page.set("lead", text_data(lead_sentence(study)));
  page.set("mark", verdict == "pass" ? "\u2713" : verdict == "incomplete" ? "!" : "\u2717");
  page.set("passed_count", with_commas(all.passed));
  page.set("total_count", with_commas(all.rows));
  page.set("failed", std::to_string(all.failed));
  page.set("skipped", std::to_string(all.skipped));
  page.set("any_failed", flag(all.failed > 0));
  page.set("any_skipped", flag(all.skipped > 0));
  page.set("beside", links_data(beside));
  data tiles{data::type::list}, cases{data::type::list};
  for (const std::string& reference : references_of(study))
    tiles.push_back(reference_tile(study, reference));
  constexpr int kOpened = 3;  // failing scenes that are folded open from the start
  int opened = 0;
  for (const Case* one : cases_by_verdict(study)) {
    const Tally rows = tally(study, [&](const Comparison& row) { return row.scene == one->scene; });
    const bool open = rows.failed > 0 && opened++ < kOpened;
    data shown = case_data(study, *one, open);
    shown.set("lines", matrix_lines(study, *one));
    const std::string inside = case_html(study, *one);
    shown.set("inside", open ? inside : "");
    shown.set("folded", open ? flag(false) : data(deflated(inside)));
    cases.push_back(std::move(shown));
  }
  page.set("tiles", tiles);
  page.set("thumbnails", thumbnails_data(study));
  page.set("counts", counts_data(study));
  const data failures = failures_data(study);
  page.set("has_failures", flag(failures.get("rows")->is_non_empty_list()));
  page.set("failures", failures);
  page.set("baseline", baseline_data(study));
  set_list(page, "slower", slower_data(study));
  page.set("guilty", guilty_types(study));
  set_list(page, "broken", broken_data(study));
  set_list(page, "skipped_reasons", skipped_data(study));
  data warnings{data::type::list};
  for (const std::string& warning : study.warnings) warnings.push_back(text_data(warning));
  set_list(page, "study_warnings", warnings);
  set_list(page, "pairs", pairs_data(study));
  set_list(page, "informative", informative_data(study));
  set_list(page, "candidates", candidates_data(study));
  page.set("light_types", light_types_data(study));
  page.set("matrix_heads", matrix_heads(study));
  page.set("reference_count",
           std::to_string(std::max<std::size_t>(1, references_of(study).size())));
  page.set("cases", std::move(cases));
  const bool full = is_full_run(study);
  set_list(page, "gallery", full ? figures_data(gallery()) : data(data::type::list));
  set_list(page, "readings", full ? figures_data(sample_code_figures()) : data(data::type::list));
  page.set("provenance", provenance_data(study.provenance));
  page.set("provenance_json", script_safe(provenance_json(study)));
  page.set("took", study.cases.empty() ? flag(false) : took_data(study));
  page.set("tolerances", tolerances_data());
  page.set("rates", rates_data());
  page.set("alpha", fmt::format("{:.0f} %", 100 * kAlpha));
  page.set("results", deflated(reproducible_json(study)));
  page.set("style", std::string(kPageStyle));
  page.set("script", std::string(kPageScript));
  return page;
}

}  // namespace

std::string html(const Study& study, const std::vector<PageLink>& beside) {
  kainjow::mustache::mustache page{std::string(kPageTemplate)};
  if (!page.is_valid()) throw std::logic_error("page.html: " + page.error_message());
  std::string text = page.render(page_data(study, beside));
  // The pictures, then the equation of every pixel for as many scenes as there is room for. The
  // page answers before it has read them.
  const auto add = [&](std::string_view kind, const auto& texts_within) {
    const std::size_t room = kMostBytes - std::min(kMostBytes, text.size());
    text.insert(text.rfind("</body>"), json_elements(study, kind, texts_within(study, room)));
  };
  add("data", pictures_within);
  add("terms", explained_cases);
  return text;
}

void write_html(const Study& study, const std::filesystem::path& file) {
  write_whole(file, html(study, pages_in(file.parent_path())));
}

}  // namespace litmus

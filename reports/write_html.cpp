// write_html.cpp: report.html, the page that people open.
#include "reports/write_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <map>
#include <stdexcept>

#include "compare/verdict.h"
#include "compare/whole_file.h"
#include "reports/html_case.h"
#include "reports/overview.h"
#include "reports/pictures.h"
#include "reports/plain_text.h"
#include "reports/web_assets.h"
#include "reports/write_json.h"
#include "scene/words.h"

namespace litmus {
namespace {
using kainjow::mustache::data;

const Case* find_case(const Study& study, const std::string& scene) {
  for (const Case& one : study.cases)
    if (one.scene == scene) return &one;
  return nullptr;
}

std::string row_anchor(const Study& study, const Comparison& row) {
  const Case* one = find_case(study, row.scene);
  return one == nullptr ? "" : layer_anchor(study, *one, row.light);
}

std::string short_title(const std::string& reference) {
  const std::string title = reference_title(reference);
  return title.substr(0, title.find(' '));
}

// ---- The head --------------------------------------------------------------------------------

std::string lead_sentence(const Study& study) {
  std::vector<std::string> references;
  for (const std::string& reference : references_of(study)) {
    const Tally rows =
        tally(study, [&](const Comparison& row) { return row.reference == reference; });
    const std::string source = source_of(rows);
    references.push_back(fmt::format("{} ({})", reference_title(reference),
                                     source.empty() ? "not available" : source));
  }
  return fmt::format("{}, each light by itself, compared pixel by pixel with {}.",
                     counted((long long)(study.cases.size()), "scene", "scenes"),
                     references.empty() ? "nothing" : listed(references));
}

data reference_tile(const Study& study, const std::string& reference) {
  const Tally rows =
      tally(study, [&](const Comparison& row) { return row.reference == reference; });
  data tile = chip(rows, reference);
  tile.set("has_figures", flag(rows.interior != nullptr));
  if (rows.interior == nullptr) return tile;
  const Comparison& worst = *rows.interior;
  tile.set("value", short_number(worst.max_abs));
  tile.set("allowed", short_number(worst.tolerance));
  tile.set("scene", text_data(worst.scene));
  tile.set("anchor", row_anchor(study, worst));
  tile.set("largest_fails", flag(worst.max_abs > worst.tolerance));
  tile.set("mean", short_number(rows.mean->mean_abs));
  tile.set("mean_allowed", short_number(rows.mean->mean_tolerance));
  tile.set("mean_fails", flag(rows.mean->mean_abs > rows.mean->mean_tolerance));
  tile.set("edge_allowed", rows.edge == nullptr ? "0" : short_number(rows.edge->tolerance));
  tile.set("edge", rows.edge == nullptr ? "0" : short_number(rows.edge->max_abs));
  tile.set("edge_fails", flag(rows.edge != nullptr && rows.edge->verdict == "fail"));
  return tile;
}

data seconds_list(const Study& study) {
  data list{data::type::list};
  const auto add = [&](const std::string& title, double seconds) {
    data one;
    one.set("title", text_data(title));
    one.set("seconds", short_seconds(seconds));
    list.push_back(one);
  };
  double ours = 0;
  for (const Case& one : study.cases) ours += one.seconds;
  add("litmus", ours);
  for (const std::string& reference : references_of(study)) {
    double seconds = 0;
    for (const Case& one : study.cases)
      for (const CaseReference& r : one.references)
        if (r.reference == reference) seconds += r.seconds;
    if (seconds > 0) add(reference_title(reference), seconds);
  }
  return list;
}

// The small pictures stand in the style, once each, because the page shows them in three places.
data thumbnails_data(const Study& study) {
  constexpr int kSide = 96;  // shown at 56 and less: sharp on dense screens
  data list{data::type::list};
  for (const Case& one : study.cases) {
    if (one.layers.empty()) continue;
    data thumbnail;
    thumbnail.set("anchor", case_anchor(study, one));
    thumbnail.set("uri", thumbnail_uri(one.layers.back().ours, kSide));
    list.push_back(std::move(thumbnail));
  }
  return list;
}

data failure_data(const Study& study, const Comparison& row) {
  data result;
  result.set("scene", text_data(row.scene));
  result.set("light", text_data(row.light == "all" ? "whole picture" : row.light));
  result.set("reference", text_data(reference_title(row.reference)));
  result.set("region", text_data(row.region));
  result.set("reason", text_data(row.reason));
  result.set("anchor", row_anchor(study, row));
  return result;
}

// What repeats a light's own row (the whole picture, all regions) is left to the scene's tables,
// and what has no picture to the renderers that failed.
data failures_data(const Study& study) {
  constexpr std::size_t kListed = 40;
  const std::vector<const Comparison*> rows = failures_of(study);
  const auto repeats = [](const Comparison& row) {
    return row.region == "all" || row.light == "all";
  };
  const bool all_repeat =
      std::all_of(rows.begin(), rows.end(), [&](const Comparison* row) { return repeats(*row); });
  data list{data::type::list};
  std::size_t count = 0;
  for (const Comparison* row : rows)
    if ((all_repeat || !repeats(*row)) && !row->source.empty() && ++count <= kListed)
      list.push_back(failure_data(study, *row));
  return list;
}

data broken_data(const Study& study) {
  data list{data::type::list};
  for (const Case& one : study.cases)
    for (const CaseReference& reference : one.references) {
      if (reference.failure.empty()) continue;
      data result;
      result.set("scene", text_data(one.scene));
      result.set("reference", text_data(reference_title(reference.reference)));
      result.set("failure", text_data(reference.failure));
      result.set("anchor", case_anchor(study, one));
      list.push_back(result);
    }
  return list;
}

data skipped_data(const Study& study) {
  std::map<std::string, int> reasons;
  for (const Comparison& row : study.comparisons)
    if (row.verdict == "skipped") ++reasons[reference_title(row.reference) + ": " + row.reason];
  data list{data::type::list};
  for (const auto& [reason, count] : reasons) {
    data one;
    one.set("reason", text_data(reason));
    one.set("count", counted(count, "comparison", "comparisons"));
    list.push_back(one);
  }
  return list;
}

// ---- The matrix ------------------------------------------------------------------------------

data matrix_heads(const Study& study) {
  data heads{data::type::list};
  for (const std::string& type : light_types_of(study)) {
    data references{data::type::list};
    for (const std::string& reference : references_of(study)) {
      data one;
      one.set("short", text_data(short_title(reference)));
      references.push_back(one);
    }
    data head;
    head.set("type", text_data(type == "all" ? "whole" : type));
    head.set("references", references);
    heads.push_back(head);
  }
  return heads;
}

data matrix_row(const Study& study, const Case& one) {
  data cells{data::type::list};
  for (const std::string& type : light_types_of(study))
    for (const std::string& reference : references_of(study)) {
      const Tally rows = tally(study, [&](const Comparison& row) {
        return row.scene == one.scene && row.light_type == type && row.reference == reference;
      });
      data cell = chip(rows, reference);
      const Comparison* shown = rows.failure != nullptr ? rows.failure : rows.interior;
      cell.set("empty", flag(rows.rows == 0));
      cell.set("filled", flag(rows.rows > 0));
      cell.set("label",
               text_data((type == "all" ? "whole" : type) + ", " + short_title(reference)));
      cell.set("anchor", shown != nullptr ? row_anchor(study, *shown) : case_anchor(study, one));
      cells.push_back(cell);
    }
  const Tally all = tally(study, [&](const Comparison& row) { return row.scene == one.scene; });
  data result;
  result.set("cells", cells);
  result.set("row_verdict", verdict_of(all));
  return result;
}

// ---- The foot --------------------------------------------------------------------------------

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

// JSON inside a script element: no "<" may end the element.
std::string script_safe(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

data page_data(const Study& study) {
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
  page.set("not_all_well", flag(all.failed > 0 || all.skipped > 0));
  page.set("started", text_data(study.provenance.started));
  page.set("gradient", difference_gradient());
  page.set("under", over_color(false));
  page.set("over", over_color(true));
  data tiles{data::type::list}, cases{data::type::list};
  for (const std::string& reference : references_of(study))
    tiles.push_back(reference_tile(study, reference));
  constexpr int kOpened = 3;  // failing scenes that are folded open from the start
  int opened = 0;
  for (const Case* one : cases_by_verdict(study)) {
    const Tally rows = tally(study, [&](const Comparison& row) { return row.scene == one->scene; });
    data shown = case_data(study, *one, rows.failed > 0 && opened++ < kOpened);
    shown.set("row", matrix_row(study, *one));
    cases.push_back(std::move(shown));
  }
  page.set("tiles", tiles);
  page.set("thumbnails", thumbnails_data(study));
  page.set("seconds_list", seconds_list(study));
  set_list(page, "failures", failures_data(study));
  set_list(page, "broken", broken_data(study));
  set_list(page, "skipped_reasons", skipped_data(study));
  page.set("matrix_heads", matrix_heads(study));
  page.set("reference_count",
           std::to_string(std::max<std::size_t>(1, references_of(study).size())));
  page.set("cases", std::move(cases));
  page.set("provenance", provenance_data(study.provenance));
  page.set("tolerances", tolerances_data());
  page.set("results", script_safe(results_json(study, -1)));
  page.set("style", std::string(kPageStyle));
  page.set("script", std::string(kPageScript));
  return page;
}

}  // namespace

std::string html(const Study& study) {
  kainjow::mustache::mustache page{std::string(kPageTemplate)};
  if (!page.is_valid()) throw std::logic_error("page.html: " + page.error_message());
  return page.render(page_data(study));
}

void write_html(const Study& study, const std::filesystem::path& file) {
  write_whole(file, html(study));
}

}  // namespace litmus

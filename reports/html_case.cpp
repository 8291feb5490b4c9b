// html_case.cpp: one scene of report.html, as data for the page's template.
#include "reports/html_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "compare/difference.h"
#include "compare/verdict.h"
#include "reports/blame.h"
#include "reports/html_baseline.h"
#include "reports/overview.h"
#include "reports/page_data.h"
#include "reports/plain_text.h"
#include "reports/web_assets.h"

namespace litmus {
namespace {
using kainjow::mustache::data;

constexpr std::size_t kLogBytes = 20'000;  // of a failed renderer's log

std::string mark_of(const std::string& verdict) {
  if (verdict == "pass") return "\u2713";
  return verdict == "fail" ? "\u2717" : "\u2013";
}

std::string share_percent(double value, double allowed) {
  return fmt::format("{:.0f}%", 100 * (allowed > 0 ? std::min(value / allowed, 1.0) : 0.0));
}

std::string layer_title(const CaseLayer& layer) {
  if (layer.light == "all") return "whole picture";
  return layer.light == "ambient" ? "ambient light" : layer.light;
}

// The figure that a chip shows: of a failure the figure that failed, else the worst interior one.
std::string chip_value(const Tally& rows) {
  if (rows.nonfinite > 0) return "NaN";
  if (rows.failure != nullptr && rows.failure->pixels == 0) return "no picture";
  if (rows.failure != nullptr && rows.failure->max_abs <= rows.failure->tolerance)
    return "mean " + short_number(rows.failure->mean_abs);
  if (rows.failure != nullptr) return short_number(rows.failure->max_abs);
  if (rows.largest == nullptr) return rows.skipped > 0 ? "skipped" : "";
  return short_number((rows.interior != nullptr ? rows.interior : rows.largest)->max_abs);
}

std::string chip_sentence(const Tally& rows, const std::string& reference) {
  std::string text = reference_title(reference);
  if (!source_of(rows).empty()) text += " (" + source_of(rows) + ")";
  if (rows.interior != nullptr)
    text += fmt::format(": largest {} of {} allowed", short_number(rows.interior->max_abs),
                        short_number(rows.interior->tolerance));
  if (rows.edge != nullptr && rows.edge->pixels > 0)
    text += fmt::format("; on edges {} of {}", short_number(rows.edge->max_abs),
                        short_number(rows.edge->tolerance));
  if (rows.failed > 0) text += "; fails: " + rows.failure->reason;
  if (rows.failed == 0 && rows.skipped > 0)
    text += fmt::format("; {} skipped", counted(rows.skipped, "row", "rows"));
  return text;
}

data metric_heads() {
  data heads{data::type::list};
  for (const auto& metric : kMetrics<Comparison>) {
    data head;
    head.set("title", std::string(metric.title));
    head.set("meaning", std::string(metric.meaning));
    heads.push_back(head);
  }
  return heads;
}

data row_data(const Comparison& row) {
  data values{data::type::list};
  for (const auto& metric : kMetrics<Comparison>) {
    data value;
    const bool over = (metric.name == "max_abs" && row.max_abs > row.tolerance) ||
                      (metric.name == "mean_abs" && row.mean_abs > row.mean_tolerance);
    value.set("value", short_number(row.*metric.member));
    value.set("exact", fmt::format("{}", row.*metric.member));
    value.set("over", flag(over && row.verdict == "fail"));
    values.push_back(value);
  }
  data result;
  result.set("values", values);
  result.set("reference", text_data(reference_title(row.reference)));
  result.set("source", text_data(row.source));
  result.set("region", text_data(row.region));
  result.set("bands", row.bands.empty() ? flag(false) : text_data(row.bands));
  result.set("pixels", std::to_string(row.pixels));
  result.set("at", fmt::format("{}, {}", row.max_at[0], row.max_at[1]));
  result.set("over_tolerance", std::to_string(row.over_tolerance));
  result.set("allowed", short_number(row.tolerance));
  result.set("verdict", text_data(row.verdict));
  result.set("mark", mark_of(row.verdict));
  result.set("reason", text_data(row.reason));
  result.set("hint", row.hint.empty() || row.region == "all" ? flag(false) : text_data(row.hint));
  result.set("blame", row.blame && row.region != "all"
                          ? text_data(blame_sentence(*row.blame, reference_title(row.reference)))
                          : flag(false));
  result.set("has_reason", flag(!row.reason.empty()));
  result.set("show_reason", flag(!row.reason.empty() && row.pixels > 0 && row.region != "all"));
  result.set("has_figures", flag(row.verdict != "skipped" && row.pixels > 0));
  data causes{data::type::list};
  for (const std::string& cause : row.causes) causes.push_back(text_data(cause));
  set_list(result, "causes", causes);
  result.set("cause_count", counted((long long)(row.causes.size()), "pixel", "pixels"));
  return result;
}

// `show` is what the page paints: "ours", "theirs" or "difference".
data figure(const std::string& show, std::string_view title, const std::string& reference) {
  data result;
  result.set("show", show);
  result.set("title", text_data(title));
  result.set("reference", text_data(reference));
  result.set("difference", flag(show == "difference"));
  return result;
}

// What is allowed in a region: of the row, or of the table where there is no row.
double allowed(const Study& study, const Case& one, const CaseLayer& layer,
               const std::string& reference, Region region) {
  const Comparison* row =
      find_row(study, one.scene, layer.light, reference, std::string(name_of(region)));
  if (row != nullptr) return row->tolerance;
  for (const NamedTolerance& known : tolerances())
    if (known.reference == reference && known.region == region) return known.tolerance.max_abs;
  return 0;
}

void add_theirs(data& figures, const Study& study, const Case& one, const CaseLayer& layer,
                const std::string& reference, const Picture& theirs) {
  if (!same_size(layer.ours, theirs)) return;
  const std::string title = reference_title(reference);
  const Tally rows = tally(study, [&](const Comparison& row) {
    return row.scene == one.scene && row.light == layer.light && row.reference == reference;
  });
  // Where they agree, theirs looks like ours: the whole picture shows it once per scene.
  if (layer.light == "all" || rows.failed > 0)
    figures.push_back(figure("theirs", title, reference));
  const double inside = allowed(study, one, layer, reference, Region::Interior);
  const double border = allowed(study, one, layer, reference, Region::Edge);
  data difference = figure("difference", "litmus \u2212 " + title, reference);
  difference.set("scale", short_number(inside));
  difference.set("quarter", short_number(inside / 4));
  difference.set("edge_scale", short_number(border));
  figures.push_back(difference);
}

data layer_data(const Study& study, const Case& one, const CaseLayer& layer) {
  const auto is_here = [&](const Comparison& row) {
    return row.scene == one.scene && row.light == layer.light;
  };
  data figures{data::type::list}, rows{data::type::list}, chips{data::type::list};
  figures.push_back(figure("ours", "litmus", ""));
  for (const CaseLayer::Theirs& theirs : layer.theirs)
    add_theirs(figures, study, one, layer, theirs.reference, theirs.picture);
  add_theirs(figures, study, one, layer, kClosedForm, layer.exact.picture);
  for (const std::string& reference : references_of(study)) {
    const Tally some = tally(
        study, [&](const Comparison& row) { return is_here(row) && row.reference == reference; });
    if (some.rows > 0) chips.push_back(chip(some, reference));
  }
  for (const Comparison& row : study.comparisons)
    if (is_here(row)) rows.push_back(row_data(row));
  const std::string verdict = verdict_of(tally(study, is_here));
  data result;
  result.set("anchor", layer_anchor(study, one, layer.light));
  result.set("layer", std::to_string(&layer - one.layers.data()));
  result.set("title", text_data(layer_title(layer)));
  result.set("kind", text_data(layer.light_type == layer.light ? "" : layer.light_type));
  result.set("verdict", verdict);
  result.set("open", flag(layer.light == "all" || verdict == "fail"));
  result.set("figures", figures);
  result.set("metric_heads", metric_heads());
  set_list(result, "rows", rows);
  result.set("chips", chips);
  return result;
}

data renderers_data(const Case& one) {
  data result{data::type::list};
  for (const CaseReference& r : one.references) {
    data renderer;
    renderer.set("title", text_data(reference_title(r.reference)));
    renderer.set("version", text_data(r.version));
    renderer.set("source", text_data(r.source.empty() ? "none" : r.source));
    renderer.set("command", r.command.empty() ? flag(false) : text_data(r.command));
    renderer.set("failure", text_data(r.failure));
    renderer.set("failed", flag(!r.failure.empty()));
    renderer.set("log", text_data(clipped(r.log, kLogBytes)));
    renderer.set("has_log", flag(!r.log.empty()));
    result.push_back(renderer);
  }
  return result;
}

}  // namespace

data text_data(std::string_view text) { return data(clean_text(text)); }

data flag(bool value) { return data(value ? data::type::bool_true : data::type::bool_false); }

void set_list(data& target, const std::string& name, data list) {
  target.set("has_" + name, flag(list.is_non_empty_list()));
  target.set(name, std::move(list));
}

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

std::string case_anchor(const Study& study, const Case& one) {
  return fmt::format("s{}", &one - study.cases.data());
}

std::string layer_anchor(const Study& study, const Case& one, const std::string& light) {
  for (std::size_t i = 0; i < one.layers.size(); ++i)
    if (one.layers[i].light == light) return fmt::format("{}-l{}", case_anchor(study, one), i);
  return case_anchor(study, one);
}

data chip(const Tally& rows, const std::string& reference) {
  const std::string verdict = verdict_of(rows);
  data result;
  result.set("reference", text_data(reference_title(reference)));
  result.set("verdict", verdict);
  result.set("mark", mark_of(verdict));
  result.set("value", chip_value(rows));
  result.set("share", rows.interior == nullptr
                          ? "0%"
                          : share_percent(rows.interior->max_abs, rows.interior->tolerance));
  result.set("source", source_of(rows));
  result.set("stored", flag(rows.stored > 0));
  result.set("live", flag(rows.live > 0 && rows.stored == 0));
  result.set("sentence", text_data(chip_sentence(rows, reference)));
  return result;
}

data case_data(const Study& study, const Case& one, bool open) {
  const auto is_here = [&](const Comparison& row) { return row.scene == one.scene; };
  data chips{data::type::list};
  for (const std::string& reference : references_of(study)) {
    const Tally rows = tally(
        study, [&](const Comparison& row) { return is_here(row) && row.reference == reference; });
    if (rows.rows > 0) chips.push_back(chip(rows, reference));
  }
  data result;
  result.set("anchor", case_anchor(study, one));
  result.set("scene", text_data(one.scene));
  result.set("about", text_data(one.about));
  result.set("verdict", verdict_of(tally(study, is_here)));
  result.set("open", flag(open));
  result.set("chips", chips);
  return result;
}

std::string case_html(const Study& study, const Case& one) {
  data layers{data::type::list}, warnings{data::type::list};
  // The whole picture first, then its parts.
  for (const CaseLayer& layer : one.layers)
    if (layer.light == "all") layers.push_back(layer_data(study, one, layer));
  for (const CaseLayer& layer : one.layers)
    if (layer.light != "all") layers.push_back(layer_data(study, one, layer));
  for (const std::string& warning : one.warnings) warnings.push_back(text_data(warning));
  data result;
  result.set("scene_anchor", case_anchor(study, one));
  result.set("width", std::to_string(one.width));
  result.set("height", std::to_string(one.height));
  result.set("file", text_data(one.file));
  result.set("tags", text_data(fmt::format("{}", fmt::join(one.tags, ", "))));
  result.set("has_tags", flag(!one.tags.empty()));
  result.set("size", fmt::format("{} \u00d7 {}", one.width, one.height));
  result.set("layers", layers);
  result.set("warnings", warnings);
  result.set("renderers", renderers_data(one));
  set_list(result, "approvals", approvals_data(study, one));
  kainjow::mustache::mustache inside{std::string(kCaseTemplate)};
  if (!inside.is_valid()) throw std::logic_error("case.html: " + inside.error_message());
  return inside.render(result);
}

}  // namespace litmus

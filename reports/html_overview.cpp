// html_overview.cpp: the head of report.html, as data for the page's template.
#include "reports/html_overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "reports/candidates.h"
#include "reports/html_case.h"
#include "reports/overview.h"
#include "reports/pictures.h"
#include "reports/plain_text.h"
#include "reports/suspects.h"
#include "scene/words.h"

namespace litmus {
namespace {
using kainjow::mustache::data;

std::string row_anchor(const Study& study, const Comparison& row) {
  const Case* one = find_case(study, row.scene);
  return one == nullptr ? "" : layer_anchor(study, *one, row.light);
}

constexpr std::size_t kListedFailures = 10;  // in the page's head; the matrix has them all

// The whole picture and all regions say once more what a light's own row says.
bool repeats_others(const Comparison& row) { return row.region == "all" || row.light == "all"; }

// A field of an address: all but letters and digits as %XX.
std::string address_field(std::string_view text) {
  std::string safe;
  for (const char c : clean_text(text))
    safe += std::isalnum(static_cast<unsigned char>(c))
                ? std::string(1, c)
                : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return safe;
}

// Whose picture shows the row's difference: the row's reference, or, where that has none (a closed
// form may be a number or a curve), the first that has; "" without any.
std::string shown_reference(const Study& study, const Comparison& row) {
  const Case* one = find_case(study, row.scene);
  if (one == nullptr || row.pixels == 0) return "";
  std::string first;
  for (const CaseLayer& layer : one->layers) {
    if (layer.light != row.light) continue;
    if (row.reference == kClosedForm && same_size(layer.ours, layer.exact.picture))
      return row.reference;
    for (const CaseLayer::Theirs& theirs : layer.theirs) {
      if (!same_size(layer.ours, theirs.picture)) continue;
      if (theirs.reference == row.reference) return row.reference;
      if (first.empty()) first = theirs.reference;
    }
  }
  return first;
}

// The address at which the viewer shows a row's worst pixel.
std::string view_address(const Comparison& row, const std::string& reference) {
  const std::string view =
      fmt::format("#view?scene={}&light={}&with={}&show=difference", address_field(row.scene),
                  address_field(row.light), address_field(reference));
  // The viewer finds a pixel that is not finite by itself.
  return row.nonfinite > 0 ? view : fmt::format("{}&at={},{}", view, row.max_at[0], row.max_at[1]);
}

data failure_data(const Study& study, const Comparison& row) {
  data result;
  result.set("scene", text_data(row.scene));
  result.set("light", text_data(row.light == "all" ? "whole picture" : row.light));
  result.set("type", row.light_type == row.light ? flag(false) : text_data(row.light_type));
  result.set("reference", text_data(reference_title(row.reference)));
  result.set("region", text_data(row.region));
  result.set("reason", text_data(row.reason));
  result.set("hint", row.hint.empty() ? flag(false) : text_data(row.hint));
  result.set("anchor", row_anchor(study, row));
  const std::string shown = shown_reference(study, row);
  result.set("view", shown.empty() ? flag(false) : data(view_address(row, shown)));
  return result;
}

}  // namespace

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
  tile.set("key", text_data(reference));
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
  // The whole picture's edge pixels are those of its lights once more.
  const Tally own = tally(study, [&](const Comparison& row) {
    return row.reference == reference && row.light != "all";
  });
  tile.set("edge_over", own.over > 0 ? data(counted(own.over, "pixel", "pixels")) : flag(false));
  tile.set("edge_explained", flag(own.explained >= own.over));
  tile.set("edge_fails", flag(rows.edge != nullptr && rows.edge->verdict == "fail"));
  return tile;
}

data counts_data(const Study& study) {
  const Tally all = tally(study, [](const Comparison&) { return true; });
  data list{data::type::list};
  const auto add = [&](const std::string& title, long long count) {
    data one;
    one.set("title", title);
    one.set("count", with_commas(count));
    if (count > 0) list.push_back(one);
  };
  add("scenes", (long long)(study.cases.size()));
  add("against live pictures", all.live);
  add("against stored ones", all.stored);
  return list;
}

data took_data(const Study& study) {
  const std::vector<std::string> references = references_of(study);
  data heads{data::type::list}, rows{data::type::list};
  heads.push_back(data("litmus"));
  for (const std::string& reference : references)
    heads.push_back(text_data(reference_title(reference)));
  const auto add = [&](const std::string& title, std::span<const Case> cases) {
    const std::vector<double> seconds = seconds_of(cases, references);
    data cells{data::type::list};
    for (const double each : seconds) cells.push_back(data(each > 0 ? short_seconds(each) : ""));
    data row;
    row.set("scene", text_data(title));
    row.set("seconds", cells);
    rows.push_back(row);
  };
  if (study.cases.size() > 1) add("all scenes", study.cases);
  for (const Case& one : study.cases) add(one.scene, {&one, 1});
  data result;
  result.set("heads", heads);
  result.set("rows", rows);
  return result;
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

// What repeats a light's own row (the whole picture, all regions) is left to the scene's tables,
// and what has no picture to the renderers that failed.
data failures_data(const Study& study) {
  const std::vector<const Comparison*> rows = failures_of(study);
  const bool all_repeat = std::all_of(rows.begin(), rows.end(),
                                      [](const Comparison* row) { return repeats_others(*row); });
  std::vector<const Comparison*> worst;  // one for each light
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const Comparison* row : rows) {
    if ((repeats_others(*row) && !all_repeat) || row->source.empty()) continue;
    if (++counts[{row->scene, row->light}] == 1) worst.push_back(row);
  }
  data list{data::type::list};
  for (std::size_t i = 0; i < std::min(worst.size(), kListedFailures); ++i) {
    data failure = failure_data(study, *worst[i]);
    const int more = counts[{worst[i]->scene, worst[i]->light}] - 1;
    failure.set("more", more > 0 ? data(counted(more, "row", "rows")) : flag(false));
    list.push_back(failure);
  }
  data result;
  const std::size_t left = worst.size() - std::min(worst.size(), kListedFailures);
  result.set("rows", list);
  result.set("left", left > 0 ? data(counted((long long)left, "light", "lights")) : flag(false));
  return result;
}

std::string guilty_types(const Study& study) {
  std::vector<std::string> guilty, innocent;
  for (const std::string& type : light_types_of(study)) {
    if (type == "all") continue;
    const Tally rows = tally(study, [&](const Comparison& row) { return row.light_type == type; });
    (rows.failed > 0 ? guilty : innocent).push_back(type);
  }
  if (guilty.empty() || innocent.empty()) return "";
  return fmt::format("In {} light only, not in {}.", listed(guilty), listed(innocent));
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

data pairs_data(const Study& study) {
  data list{data::type::list};
  if (study.pairs.empty()) return list;
  for (const PairLine& line : pair_lines(study)) {
    const Case* worst = find_case(study, line.scene);
    data one;
    one.set("one", text_data(reference_title(line.against)));
    one.set("other", text_data(reference_title(line.reference)));
    one.set("largest", short_number(line.largest));
    one.set("scene", text_data(line.scene + ", " + line.light));
    one.set("anchor", worst == nullptr ? "" : case_anchor(study, *worst));
    one.set("rows", std::to_string(line.rows));
    one.set("failed", std::to_string(line.failed));
    list.push_back(one);
  }
  return list;
}

data informative_data(const Study& study) {
  data list{data::type::list};
  for (const InformativeLine& line : informative_lines(study)) {
    data values{data::type::list};
    for (const std::optional<double>& largest : line.largest)
      values.push_back(data(largest ? short_number(*largest) : ""));
    const Case* worst = find_case(study, line.scene);
    data one;
    one.set("reference", text_data(reference_title(line.reference)));
    one.set("type", text_data(light_type_title(line.light_type)));
    one.set("values", values);
    one.set("scene", text_data(line.scene));
    one.set("anchor", worst == nullptr ? "" : case_anchor(study, *worst));
    list.push_back(one);
  }
  return list;
}

data candidates_data(const Study& study) {
  data list{data::type::list};
  for (const CandidateNote& candidate : study.candidates) {
    data one;
    one.set("name", text_data(candidate.name));
    one.set("encoding", text_data(candidate.encoding));
    one.set("note", text_data(candidate.note));
    list.push_back(one);
  }
  return list;
}

}  // namespace litmus

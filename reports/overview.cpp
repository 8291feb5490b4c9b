// overview.cpp: counts, worst rows and orders.
#include "reports/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "reference/closed_form.h"
#include "reference/drivers.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {

void keep_largest(const Comparison*& kept, const Comparison& row, double Comparison::*member) {
  if (kept == nullptr || row.*member > kept->*member) kept = &row;
}

void add(Tally& result, const Comparison& row) {
  ++result.rows;
  if (row.verdict == "skipped") {
    ++result.skipped;
    return;
  }
  ++(row.verdict == "pass" ? result.passed : result.failed);
  result.live += row.source == "live";
  result.stored += row.source == "stored";
  result.computed += row.source == "computed";
  result.nonfinite += row.nonfinite;
  keep_largest(result.largest, row, &Comparison::max_abs);
  if (row.region == "interior") keep_largest(result.interior, row, &Comparison::max_abs);
  if (row.region == "interior") keep_largest(result.mean, row, &Comparison::mean_abs);
  if (row.region == "edge") {
    keep_largest(result.edge, row, &Comparison::max_abs);
    result.over += row.over_tolerance;
    result.explained += row.explained;
  }
  if (row.verdict != "pass" && (!result.failure || excess(row) > excess(*result.failure)))
    result.failure = &row;
}

void add_once(std::vector<std::string>& values, const std::string& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

}  // namespace

double excess(const Comparison& row) {
  if (row.nonfinite > 0 || (row.verdict == "fail" && row.pixels == 0))
    return std::numeric_limits<double>::infinity();
  const auto ratio = [](double value, double limit) { return limit > 0 ? value / limit : value; };
  return std::max(ratio(row.max_abs, row.tolerance), ratio(row.mean_abs, row.mean_tolerance));
}

Tally tally(const Study& study, const std::function<bool(const Comparison&)>& wanted) {
  Tally result;
  for (const Comparison& row : study.comparisons)
    if (wanted(row)) add(result, row);
  return result;
}

std::string verdict_of(const Tally& tally) {
  if (tally.failed > 0) return "fail";
  if (tally.skipped > 0) return "skipped";
  return tally.passed > 0 ? "pass" : "";
}

std::string source_of(const Tally& tally) {
  if (tally.live > 0 && tally.stored > 0) return "live and stored";
  if (tally.live > 0) return "live";
  if (tally.stored > 0) return "stored";
  return tally.computed > 0 ? "computed" : "";
}

std::vector<std::string> references_of(const Study& study) {
  std::vector<std::string> references;
  for (const Comparison& row : study.comparisons) add_once(references, row.reference);
  return references;
}

std::vector<std::string> light_types_of(const Study& study) {
  constexpr std::array known{"directional", "point", "spot", "area", "ambient", "all"};
  std::vector<std::string> found, types;
  for (const Comparison& row : study.comparisons) add_once(found, row.light_type);
  for (const char* type : known)
    if (std::find(found.begin(), found.end(), type) != found.end()) types.emplace_back(type);
  for (const std::string& type : found) add_once(types, type);
  return types;
}

const Comparison* find_row(const Study& study, const std::string& scene, const std::string& light,
                           const std::string& reference, const std::string& region) {
  for (const Comparison& row : study.comparisons)
    if (row.scene == scene && row.light == light && row.reference == reference &&
        row.region == region)
      return &row;
  return nullptr;
}

std::vector<const Comparison*> failures_of(const Study& study) {
  std::vector<const Comparison*> rows;
  for (const Comparison& row : study.comparisons)
    if (row.verdict == "fail") rows.push_back(&row);
  // An "all" row only repeats what the rows of its parts say.
  const auto repeats = [](const Comparison& row) {
    return row.light == "all" || row.region == "all";
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const Comparison* a, const Comparison* b) {
    if (repeats(*a) != repeats(*b)) return repeats(*b);
    return excess(*a) > excess(*b);
  });
  return rows;
}

const Case* find_case(const Study& study, const std::string& scene) {
  for (const Case& one : study.cases)
    if (one.scene == scene) return &one;
  return nullptr;
}

std::vector<const Case*> cases_by_verdict(const Study& study) {
  std::vector<std::pair<double, const Case*>> ranked;  // larger comes first
  for (const Case& one : study.cases) {
    const Tally rows = tally(study, [&](const Comparison& row) { return row.scene == one.scene; });
    const bool broken =
        std::any_of(one.references.begin(), one.references.end(),
                    [](const auto& reference) { return !reference.failure.empty(); });
    const double rank = rows.failure != nullptr ? 2 + excess(*rows.failure)
                        : broken                ? std::numeric_limits<double>::infinity()
                        : rows.skipped > 0      ? 1
                                                : 0;
    ranked.emplace_back(rank, &one);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Case*> cases;
  for (const auto& [rank, one] : ranked) cases.push_back(one);
  return cases;
}

std::vector<double> seconds_of(std::span<const Case> cases,
                               const std::vector<std::string>& references) {
  std::vector<double> seconds(1 + references.size());
  for (const Case& one : cases) {
    seconds[0] += one.seconds;
    for (const CaseReference& r : one.references)
      for (std::size_t i = 0; i < references.size(); ++i)
        if (r.reference == references[i] && !r.source.empty()) seconds[1 + i] += r.seconds;
  }
  return seconds;
}

std::string light_type_title(const std::string& light_type) {
  return light_type == "all" ? "whole" : light_type;
}

std::string reference_title(const std::string& reference) {
  if (reference == kClosedForm) return "closed form";
  const Driver* driver = find_driver(reference);
  return driver != nullptr ? driver->title : reference;
}

std::string headline(const Study& study) {
  const Tally all = tally(study, [](const Comparison&) { return true; });
  const std::string verdict = overall_verdict(study);
  const std::string comparisons = counted(all.rows, "comparison", "comparisons");
  if (verdict == "pass") return "Everything agrees";
  if (verdict == "fail")
    return fmt::format("{} of {} {}", all.failed, comparisons,
                       all.failed == 1 ? "disagrees" : "disagree");
  if (verdict == "broken") return "A renderer failed";
  return fmt::format("Nothing disagrees, but {} of {} {} skipped", all.skipped, comparisons,
                     all.skipped == 1 ? "was" : "were");
}

}  // namespace litmus

// approval.cpp: which failures a person may accept, and with what figures.
#include "reports/approval.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reference/drivers.h"
#include "reports/overview.h"
#include "reports/page_data.h"

namespace litmus {
namespace {

bool is_candidate(const Study& study, const std::string& reference) {
  return reference.ends_with("-native") ||
         std::any_of(study.candidates.begin(), study.candidates.end(),
                     [&](const CandidateNote& one) { return one.name == reference; });
}

/// Whoever is neither a renderer nor a candidate computes the truth.
bool is_oracle(const Study& study, const std::string& reference) {
  return find_driver(reference) == nullptr && !is_candidate(study, reference);
}

const Comparison* failing_oracle(const Study& study, const std::string& scene) {
  for (const Comparison& row : study.comparisons)
    if (row.scene == scene && row.verdict == "fail" && is_oracle(study, row.reference)) return &row;
  return nullptr;
}

std::string renderer_failure(const Study& study, const std::string& scene,
                             const std::string& reference) {
  for (const Case& one : study.cases)
    for (const CaseReference& each : one.references)
      if (one.scene == scene && each.reference == reference) return each.failure;
  return "";
}

std::string row_refusal(const Comparison& row, const std::string& where) {
  if (row.nonfinite > 0)
    return fmt::format("{}: {} pixels of {} are NaN or infinite: no tolerance covers that; mend it",
                       where, row.nonfinite, row.light);
  if (row.reason.starts_with("unregistered"))
    return fmt::format("{}: {}: mend the camera first", where, row.reason);
  return "";
}

}  // namespace

std::vector<const Comparison*> failing_rows(const Study& study, const std::string& scene,
                                            const std::string& reference) {
  std::vector<const Comparison*> rows;
  for (const Comparison& row : study.comparisons)
    if (row.scene == scene && row.reference == reference && row.verdict == "fail" &&
        row.region != "all")
      rows.push_back(&row);
  return rows;
}

std::string approval_refusal(const Study& study, const std::string& scene,
                             const std::string& reference) {
  const std::string where = scene + "/" + reference;
  if (study.provenance.command.find("--control") != std::string::npos)
    return fmt::format("{}: this run has a planted mistake (--control): run again without", where);
  if (const std::string failure = renderer_failure(study, scene, reference); !failure.empty())
    return fmt::format("{}: the renderer failed, so there is nothing to approve: {}", where,
                       failure);
  if (const Comparison* row = failing_oracle(study, scene))
    return fmt::format(
        "{}: litmus differs from the {} in {}, {} ({}), so the mistake is litmus's: mend it", where,
        reference_title(row->reference), row->light, row->region, row->reason);
  bool failed = false;
  for (const Comparison& row : study.comparisons) {
    if (row.scene != scene || row.reference != reference || row.verdict != "fail") continue;
    failed = true;
    if (const std::string refusal = row_refusal(row, where); !refusal.empty()) return refusal;
  }
  if (!failed) return fmt::format("{}: nothing fails there, so there is nothing to approve", where);
  if (is_candidate(study, reference))
    return fmt::format(
        "{}: a candidate has no tolerance of its own: mend it, or say "
        "`expect = \"differs\"` in its [[candidate]]",
        where);
  return "";
}

std::vector<ToleranceChange> raised_tolerances(std::span<const Comparison* const> rows,
                                               const std::string& reason) {
  struct Largest {
    double max_abs = 0, mean_abs = 0;
  };
  std::map<std::pair<std::string, std::string>, Largest> seen;
  for (const Comparison* row : rows) {
    Largest& largest = seen[{row->reference, row->region}];
    largest.max_abs = std::max(largest.max_abs, row->max_abs);
    largest.mean_abs = std::max(largest.mean_abs, row->mean_abs);
  }
  std::vector<ToleranceChange> changes;
  for (const NamedTolerance& row : tolerances()) {
    const auto found = seen.find({std::string(row.reference), std::string(name_of(row.region))});
    if (found != seen.end())
      changes.push_back(raised(row, found->second.max_abs, found->second.mean_abs, reason));
  }
  return changes;
}

std::string approve_command(const Case& one, const std::string& reference) {
  return fmt::format("litmus approve {} --reason '...'", shell_word(one.scene + "/" + reference));
}

}  // namespace litmus

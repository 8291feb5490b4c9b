// tolerances.cpp: reads tolerances.toml.
#include "compare/tolerances.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>

#include "scene/fields.h"
#include "scene/load.h"
#include "scene/refusal.h"
#include "scene/words.h"

namespace litmus {
namespace {

constexpr std::array kJudged{Region::Interior, Region::Edge,  Region::Lit,
                             Region::Penumbra, Region::Umbra, Region::Highlight};

/// The same text, for as long as the program runs.
std::string_view kept(const std::string& text) {
  static std::mutex lock;
  static std::set<std::string> texts;
  const std::lock_guard guard(lock);
  return *texts.insert(text).first;
}

NamedTolerance read_row(const Fields& fields) {
  fields.only({"reference", "region", "max_abs", "mean_abs", "seen_max", "seen_mean", "reason"});
  NamedTolerance row;
  row.line = int(fields.place().line);
  row.reference = kept(fields.text("reference"));
  row.region = fields.choice<Region>("region", {{"interior", Region::Interior},
                                                {"edge", Region::Edge},
                                                {"lit", Region::Lit},
                                                {"penumbra", Region::Penumbra},
                                                {"umbra", Region::Umbra},
                                                {"highlight", Region::Highlight}});
  row.tolerance.max_abs = fields.number("max_abs", kNotNegative);
  row.tolerance.mean_abs = fields.number("mean_abs", kNotNegative);
  row.seen_max = fields.number("seen_max", kNotNegative);
  row.seen_mean = fields.number("seen_mean", kNotNegative);
  row.tolerance.reason = kept(fields.text("reason"));
  row.tolerance.may_be_empty = row.region != Region::Interior;
  if (row.seen_max > row.tolerance.max_abs)
    fields.refuse("seen_max", "is over max_abs: what was seen must pass");
  if (row.seen_mean > row.tolerance.mean_abs)
    fields.refuse("seen_mean", "is over mean_abs: what was seen must pass");
  return row;
}

const NamedTolerance* find_row(std::span<const NamedTolerance> rows, std::string_view reference,
                               Region region) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const NamedTolerance& row) {
    return row.reference == reference && row.region == region;
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::filesystem::path tolerances_file() {
  const std::filesystem::path data = data_directory(), installed = data / "tolerances.toml";
  std::error_code ignored;
  if (std::filesystem::is_regular_file(installed, ignored)) return installed;
  return data / "compare" / "tolerances.toml";
}

std::vector<NamedTolerance> load_tolerances(const std::filesystem::path& file) {
  const Node document = read_document(file);
  const Fields root(file, document, "a file of tolerances");
  root.only({"tolerance"});
  std::vector<NamedTolerance> rows;
  for (const Node& node : root.tables("tolerance")) {
    const Fields fields(file, node, "a tolerance");
    const NamedTolerance row = read_row(fields);
    if (const NamedTolerance* other = find_row(rows, row.reference, row.region))
      fields.refuse("region", fmt::format("{}, {} has a tolerance in line {} already",
                                          row.reference, name_of(row.region), other->line));
    rows.push_back(row);
  }
  if (rows.empty()) root.refuse_missing("tolerance", "tables headed [[tolerance]]");
  for (const NamedTolerance& row : rows)
    for (const Region region : kJudged)
      if (!find_row(rows, row.reference, region))
        refuse(file, {std::uint32_t(row.line), 1}, "tolerance",
               fmt::format("{} has none for the region \"{}\"", row.reference, name_of(region)));
  return rows;
}

std::span<const NamedTolerance> tolerances() {
  static const std::vector<NamedTolerance> rows = load_tolerances(tolerances_file());
  return rows;
}

Tolerance find_tolerance(std::string_view reference, Region region) {
  const Region judged = region == Region::All ? Region::Edge : region;
  if (const NamedTolerance* row = find_row(tolerances(), reference, judged)) return row->tolerance;
  std::vector<std::string> known;
  for (const NamedTolerance& row : tolerances())
    if (row.region == Region::Interior) known.emplace_back(row.reference);
  throw Refusal(fmt::format("there is no tolerance for the reference '{}'; there is one for {}",
                            reference, listed(known)));
}

std::vector<std::string> tolerance_warnings(std::span<const NamedTolerance> rows,
                                            const std::filesystem::path& file) {
  std::vector<std::string> warnings;
  for (const NamedTolerance& row : rows) {
    const auto check = [&](std::string_view key, double allowed, double seen) {
      if (allowed <= kLargestMargin * seen) return;
      warnings.push_back(fmt::format(
          "{}:{}: the {} of {}, {} is {:.2g}, more than {} times the largest error seen, {:.2g}: "
          "lower it, or an error of that size goes unnoticed",
          file.string(), row.line, key, row.reference, name_of(row.region), allowed, kLargestMargin,
          seen));
    };
    check("max_abs", row.tolerance.max_abs, row.seen_max);
    check("mean_abs", row.tolerance.mean_abs, row.seen_mean);
  }
  return warnings;
}

}  // namespace litmus

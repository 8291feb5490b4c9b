// suspects.cpp: pairs of sources, and the majority among them.
#include "reports/suspects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "compare/difference.h"
#include "compare/tolerances.h"
#include "compare/verdict.h"
#include "reference/closed_form.h"
#include "reference/drivers.h"
#include "reports/overview.h"
#include "reports/rows.h"
#include "scene/words.h"

namespace litmus {
namespace {

constexpr const char* kOurs = "litmus";

/// Two figures that each may be off by their own tolerance.
Tolerance between(const std::string& a, const std::string& b) {
  const Tolerance first = find_tolerance(a, Region::Interior),
                  second = find_tolerance(b, Region::Interior);
  return {first.max_abs + second.max_abs, first.mean_abs + second.mean_abs, first.reason, true};
}

/// Which sources agree on one light of one scene: pairs in either order, true where they do.
struct Ballot {
  std::set<std::string> sources;
  std::map<std::array<std::string, 2>, bool> agree;

  void add(const std::string& a, const std::string& b, bool pass) {
    sources.insert(a), sources.insert(b);
    for (const auto& pair : {std::array{a, b}, std::array{b, a}}) {
      const auto at = agree.try_emplace(pair, true).first;
      at->second &= pass;
    }
  }
  /// Whether all pairs with `source` fail, and all without it pass and are known.
  bool accuses(const std::string& source) const {
    for (const std::string& a : sources)
      for (const std::string& b : sources) {
        if (a == b) continue;
        const auto at = agree.find({a, b});
        if (at == agree.end() || at->second == (a == source || b == source)) return false;
      }
    return true;
  }
};

std::string name_in_text(const std::string& source) {
  return source == kOurs ? source : reference_title(source);
}

std::string sentence(const Ballot& ballot, const std::string& suspect) {
  std::vector<std::string> others;
  for (const std::string& source : ballot.sources)
    if (source != suspect) others.push_back(name_in_text(source));
  return fmt::format("{} agree with each other, so {} is the suspect", listed(others),
                     name_in_text(suspect));
}

using LightOfScene = std::array<std::string, 2>;

}  // namespace

void compare_pairs(const Case& entry, const CaseLayer& layer, const CaseLayer::Theirs& theirs,
                   std::span<const std::uint8_t> skip, std::vector<Comparison>& pairs) {
  std::vector<std::uint8_t> members(skip.size());
  std::transform(skip.begin(), skip.end(), members.begin(), [](std::uint8_t s) { return !s; });
  for (const CaseLayer::Theirs& other : layer.theirs) {
    if (other.source.empty()) continue;
    const Tolerance tolerance = between(theirs.reference, other.reference);
    const Difference d = difference(other.picture, theirs.picture, members, tolerance.max_abs);
    if (d.pixels == 0) continue;
    const Verdict verdict = judge(d, tolerance);
    Comparison& row = pairs.emplace_back(row_of(d, "interior", tolerance));
    row.scene = entry.scene, row.reference = theirs.reference, row.source = theirs.source;
    row.light = layer.light, row.light_type = layer.light_type, row.against = other.reference;
    row.verdict = verdict.pass ? "pass" : "fail", row.reason = verdict.reason;
  }
}

void compare_references(const Case& entry, Study& study) {
  for (const CaseLayer& layer : entry.layers) {
    CaseLayer before{layer.light, layer.light_type, {}, {}, {}, {}};
    for (const CaseLayer::Theirs& theirs : layer.theirs) {
      if (theirs.source.empty()) continue;
      compare_pairs(entry, before, theirs, layer.edge, study.pairs);
      before.theirs.push_back(theirs);
    }
  }
}

void name_suspects(Study& study) {
  std::map<LightOfScene, Ballot> ballots;
  for (const Comparison& row : study.comparisons) {
    const bool known = row.verdict != "skipped" &&
                       (row.reference == kClosedForm || find_driver(row.reference) != nullptr);
    if (known) ballots[{row.scene, row.light}].add(kOurs, row.reference, row.verdict == "pass");
  }
  for (const Comparison& row : study.pairs)
    ballots[{row.scene, row.light}].add(row.reference, row.against, row.verdict == "pass");
  for (Comparison& row : study.comparisons) {
    if (row.verdict != "fail") continue;
    const Ballot& ballot = ballots[{row.scene, row.light}];
    if (ballot.sources.size() < 3) continue;
    for (const std::string& source : ballot.sources) {
      if (!ballot.accuses(source)) continue;
      row.suspect = source;
      row.reason += (row.reason.empty() ? "" : "; ") + sentence(ballot, source);
    }
  }
}

std::vector<PairLine> pair_lines(const Study& study) {
  std::vector<PairLine> lines;
  const auto add = [&](const Comparison& row) {
    auto line = std::find_if(lines.begin(), lines.end(), [&](const PairLine& each) {
      return each.reference == row.reference && each.against == row.against;
    });
    if (line == lines.end())
      line = lines.insert(line, {row.reference, row.against, 0, "", "", 0, 0});
    ++line->rows;
    line->failed += row.verdict == "fail";
    if (row.max_abs >= line->largest) {
      line->largest = row.max_abs;
      line->scene = row.scene, line->light = row.light;
    }
  };
  for (const Comparison& row : study.comparisons)
    if (row.region == "interior" && row.verdict != "skipped") add(row);
  for (const Comparison& row : study.pairs) add(row);
  return lines;
}

}  // namespace litmus

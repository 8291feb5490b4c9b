// baseline.cpp: pairs the rows of two runs and says what changed.
#include "reports/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "reports/overview.h"
#include "reports/plain_text.h"
#include "reports/study.h"

namespace litmus {
namespace {

using Key = std::array<std::string, 4>;

constexpr std::array kKinds{"new failure", "worse", "missing", "fixed"};

Key key_of(const Comparison& row) { return {row.scene, row.reference, row.light, row.region}; }

std::map<Key, const Comparison*> by_key(const Study& study) {
  std::map<Key, const Comparison*> rows;
  for (const Comparison& row : study.comparisons) rows[key_of(row)] = &row;
  return rows;
}

BaselineChange change_of(const char* kind, const Comparison& row) {
  return {kind, row.scene, row.reference, row.light, row.light_type, row.region, "max_abs", 0, 0,
          0,    ""};
}

/// Edge pixels whose cause is known may differ by anything; then the figures are not judged.
bool all_explained(const Comparison& row) {
  return row.over_tolerance > 0 && row.explained >= row.over_tolerance;
}

double share(const BaselineChange& change) {
  return change.limit > 0 ? change.now / change.limit : std::numeric_limits<double>::infinity();
}

/// The figure that grew beyond its noise, if one did.
std::optional<BaselineChange> worsened(const Comparison& was, const Comparison& now) {
  BaselineChange change = change_of("worse", now);
  if (now.nonfinite > was.nonfinite) {
    change.figure = "nonfinite";
    change.was = double(was.nonfinite), change.now = double(now.nonfinite);
    change.limit = change.was;
    return change;
  }
  if (all_explained(now)) return std::nullopt;
  const auto check = [&](const char* figure, double before, double after, double allowed) {
    BaselineChange one = change;
    one.figure = figure, one.was = before, one.now = after;
    one.limit = noise_limit(before, allowed);
    return one;
  };
  const BaselineChange largest = check("max_abs", was.max_abs, now.max_abs, now.tolerance);
  const BaselineChange mean = check("mean_abs", was.mean_abs, now.mean_abs, now.mean_tolerance);
  const BaselineChange& worst =
      share(mean) > share(largest) && mean.now > mean.limit ? mean : largest;
  if (worst.now > worst.limit) return worst;
  return std::nullopt;
}

BaselineChange new_failure(const Comparison* was, const Comparison& now) {
  BaselineChange change = change_of("new failure", now);
  if (now.nonfinite > 0) {
    change.figure = "nonfinite";
    change.was = was ? double(was->nonfinite) : 0, change.now = double(now.nonfinite);
  } else if (now.max_abs > now.tolerance || now.mean_abs <= now.mean_tolerance) {
    change.was = was ? was->max_abs : 0, change.now = now.max_abs, change.limit = now.tolerance;
  } else {
    change.figure = "mean_abs";
    change.was = was ? was->mean_abs : 0, change.now = now.mean_abs;
    change.limit = now.mean_tolerance;
  }
  change.why = now.reason;
  return change;
}

void compare_row(const Comparison* was, const Comparison& now, BaselineReport& report) {
  const bool had = was && was->verdict != "skipped";
  if (now.verdict == "skipped") {
    if (had) {
      report.changes.push_back(change_of("missing", now));
      report.changes.back().why = now.reason;
    }
    return;
  }
  had ? ++report.compared : ++report.added;
  const bool failed = had && was->verdict == "fail";
  if (now.verdict == "fail" && !failed) {
    report.changes.push_back(new_failure(had ? was : nullptr, now));
  } else if (failed && now.verdict == "pass") {
    BaselineChange change = change_of("fixed", now);
    change.was = was->max_abs, change.now = now.max_abs, change.limit = now.tolerance;
    report.changes.push_back(std::move(change));
  } else if (had) {
    if (auto change = worsened(*was, now))
      report.changes.push_back(std::move(*change));
    else
      report.still_failing += failed;
  }
}

/// Rows of the baseline that this run should have and has not.
void find_missing(const Study& study, const Study& baseline,
                  const std::map<Key, const Comparison*>& now, BaselineReport& report) {
  std::set<std::pair<std::string, std::string>> asked;
  for (const Case& one : study.cases)
    for (const CaseReference& reference : one.references)
      asked.insert({one.scene, reference.reference});
  // A light without a picture has one row, which stands for its regions.
  std::set<std::array<std::string, 3>> skipped;
  for (const Comparison& row : study.comparisons)
    if (row.verdict == "skipped" || row.source.empty())
      skipped.insert({row.scene, row.reference, row.light});
  for (const Comparison& row : baseline.comparisons) {
    if (row.verdict == "skipped" || row.pixels == 0 || now.contains(key_of(row))) continue;
    if (!asked.contains({row.scene, row.reference})) continue;
    if (skipped.contains({row.scene, row.reference, row.light})) continue;
    report.changes.push_back(change_of("missing", row));
    report.changes.back().why = "this run has no such row";
  }
}

bool repeats(const BaselineChange& change) {
  return change.light == "all" || change.region == "all";
}

/// Drops what repeats another change, and puts the rest in order.
void tidy(std::vector<BaselineChange>& changes) {
  std::set<std::array<std::string, 3>> told;
  for (const BaselineChange& change : changes)
    if (!repeats(change)) told.insert({change.kind, change.scene, change.reference});
  std::erase_if(changes, [&](const BaselineChange& change) {
    return repeats(change) && told.contains({change.kind, change.scene, change.reference});
  });
  const auto rank = [](const BaselineChange& change) {
    return std::find(kKinds.begin(), kKinds.end(), change.kind) - kKinds.begin();
  };
  std::stable_sort(changes.begin(), changes.end(), [&](const auto& a, const auto& b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : share(a) > share(b);
  });
}

const CaseReference* find_live(const Case& one, const std::string& reference) {
  for (const CaseReference& r : one.references)
    if (r.reference == reference && r.source == "live" && r.seconds > 0) return &r;
  return nullptr;
}

/// Our seconds and a reference's, before and now, over scenes that it rendered in both runs.
struct Speeds {
  double ours_was = 0, theirs_was = 0, ours_now = 0, theirs_now = 0;

  void add(const Case& was, const Case& now, const std::string& reference) {
    const CaseReference *before = find_live(was, reference), *after = find_live(now, reference);
    if (!before || !after) return;
    ours_was += was.seconds, theirs_was += before->seconds;
    ours_now += now.seconds, theirs_now += after->seconds;
  }
  double was() const { return ours_was / theirs_was; }
  double now() const { return ours_now / theirs_now; }
};

/// The change if every reference agrees that we are slower, measured in the first of them.
void add_slower(const std::string& scene, const std::map<std::string, Speeds>& speeds,
                double factor, double seconds, BaselineReport& report) {
  std::optional<SpeedChange> change;
  for (const auto& [reference, speed] : speeds) {
    if (speed.ours_was <= 0 || speed.ours_now <= 0) continue;
    if (speed.now() <= factor * speed.was() || speed.ours_now - speed.ours_was < seconds) return;
    if (!change) change = SpeedChange{scene, reference, speed.was(), speed.now()};
  }
  if (change) report.slower.push_back(std::move(*change));
}

void find_slower(const Study& study, const Study& baseline, BaselineReport& report) {
  std::map<std::string, Speeds> all;
  std::map<std::string, std::map<std::string, Speeds>> scenes;
  for (const Case& now : study.cases)
    for (const Case& was : baseline.cases) {
      if (was.scene != now.scene) continue;
      for (const CaseReference& reference : now.references) {
        all[reference.reference].add(was, now, reference.reference);
        scenes[now.scene][reference.reference].add(was, now, reference.reference);
      }
    }
  add_slower("all", all, kSlowerAll, 0, report);
  for (const auto& [scene, speeds] : scenes)
    add_slower(scene, speeds, kSlowerScene, kSlowerSeconds, report);
}

void find_versions(const Study& study, const Study& baseline, BaselineReport& report) {
  std::set<std::array<std::string, 3>> known;
  for (const Case& now : study.cases)
    for (const Case& was : baseline.cases) {
      if (was.scene != now.scene) continue;
      for (const CaseReference& a : was.references)
        for (const CaseReference& b : now.references) {
          if (a.reference != b.reference || a.version == b.version) continue;
          if (a.version.empty() || b.version.empty()) continue;
          if (known.insert({a.reference, a.version, b.version}).second)
            report.versions.push_back({a.reference, a.version, b.version});
        }
    }
}

std::string in_words(const std::string& figure) {
  return figure == "mean_abs" ? "the mean difference" : "the largest difference";
}

}  // namespace

double noise_limit(double was, double allowed) {
  return kNoiseFactor * was + kNoiseShare * allowed;
}

BaselineReport against_baseline(const Study& study, const Study& baseline,
                                const std::string& file) {
  BaselineReport report;
  report.file = file;
  const std::map<Key, const Comparison*> was = by_key(baseline);
  for (const Comparison& row : study.comparisons) {
    const auto found = was.find(key_of(row));
    compare_row(found == was.end() ? nullptr : found->second, row, report);
  }
  find_missing(study, baseline, by_key(study), report);
  tidy(report.changes);
  find_slower(study, baseline, report);
  find_versions(study, baseline, report);
  return report;
}

bool is_regression(const BaselineReport& report) {
  return std::any_of(report.changes.begin(), report.changes.end(), [](const auto& change) {
    return change.kind == "new failure" || change.kind == "worse";
  });
}

std::string baseline_headline(const BaselineReport& report) {
  std::map<std::string, int> counts;
  for (const BaselineChange& change : report.changes) ++counts[change.kind];
  std::vector<std::string> parts;
  const auto add = [&](long long count, std::string_view one, std::string_view many) {
    if (count > 0) parts.push_back(counted(count, one, many));
  };
  add(counts["new failure"], "new failure", "new failures");
  add(counts["worse"], "worse", "worse");
  add(counts["missing"], "missing", "missing");
  add(counts["fixed"], "fixed", "fixed");
  add(report.still_failing, "still fails", "still fail");
  if (parts.empty()) parts.push_back("nothing new, nothing worse");
  return fmt::format("{}; {} in both, {} new", fmt::join(parts, ", "),
                     counted(report.compared, "row", "rows"), report.added);
}

std::string sentence_of(const BaselineChange& change) {
  const std::string where = fmt::format("{}, {}, {}, {}", change.scene,
                                        change.light == "all" ? "whole picture" : change.light,
                                        reference_title(change.reference), change.region);
  if (change.kind == "missing") return fmt::format("{}: {}", where, change.why);
  const std::string was = short_number(change.was), now = short_number(change.now);
  // A renderer that failed, or a cause of another kind, has no figure that says so.
  if (change.kind == "new failure" && (change.figure == "nonfinite" || change.now <= change.limit))
    return fmt::format("{}: {}", where, change.why);
  if (change.kind == "new failure")
    return fmt::format("{}: {} {}{}; allowed is {}", where, in_words(change.figure),
                       change.was > 0 ? "was " + was + " and is " : "is ", now,
                       short_number(change.limit));
  if (change.kind == "fixed")
    return fmt::format("{}: the largest difference was {} and is {}", where, was, now);
  if (change.figure == "nonfinite")
    return fmt::format("{}: {} pixels are not finite, {} were", where, change.now, change.was);
  return fmt::format("{}: {} was {} and is {}; noise ends at {}", where, in_words(change.figure),
                     was, now, short_number(change.limit));
}

std::string sentence_of(const SpeedChange& change) {
  return fmt::format("{}: litmus took {} of {}'s time and takes {}, {} times as much",
                     change.scene == "all" ? "all scenes" : change.scene, short_number(change.was),
                     reference_title(change.reference), short_number(change.now),
                     short_number(change.now / change.was));
}

std::string sentence_of(const VersionChange& change) {
  return fmt::format("{} was {} and is {}", reference_title(change.reference), change.was,
                     change.now);
}

}  // namespace litmus

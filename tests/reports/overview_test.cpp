// overview_test.cpp: what is said about many rows at once.
#include "reports/overview.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Comparison row(const std::string& region, double max_abs, const std::string& verdict) {
  Comparison row;
  row.scene = "scene", row.reference = "povray", row.source = "live", row.light = "lamp";
  row.light_type = "point", row.region = region, row.verdict = verdict;
  row.pixels = 10, row.max_abs = max_abs, row.tolerance = 1e-3, row.mean_tolerance = 1e-3;
  return row;
}

Tally all(const Study& study) {
  return tally(study, [](const Comparison&) { return true; });
}

TEST(Tally, CountsVerdictsAndFindsTheWorstOfEachRegion) {
  Study study;
  study.comparisons = {row("interior", 1e-6, "pass"), row("interior", 3e-6, "pass"),
                       row("edge", 0.5, "fail"), row("all", 0.5, "fail"),
                       row("interior", 9, "skipped")};
  const Tally result = all(study);
  EXPECT_EQ(result.rows, 5);
  EXPECT_EQ(result.passed, 2);
  EXPECT_EQ(result.failed, 2);
  EXPECT_EQ(result.skipped, 1);
  EXPECT_EQ(result.interior, &study.comparisons[1]) << "a skipped row has no figures";
  EXPECT_EQ(result.edge, &study.comparisons[2]);
  EXPECT_EQ(result.failure, &study.comparisons[2]);
}

TEST(Tally, NeverCallsARowWithoutASourceLive) {
  Study study;
  study.comparisons = {row("all", 0, "fail")};
  study.comparisons[0].source = "";
  EXPECT_EQ(source_of(all(study)), "");
  study.comparisons.push_back(row("all", 0, "pass"));
  EXPECT_EQ(source_of(all(study)), "live");
  study.comparisons[0].source = "stored";
  EXPECT_EQ(source_of(all(study)), "live and stored");
}

TEST(VerdictOf, PutsFailuresFirst) {
  Tally tally;
  EXPECT_EQ(verdict_of(tally), "");
  tally.passed = 5;
  EXPECT_EQ(verdict_of(tally), "pass");
  tally.skipped = 1;
  EXPECT_EQ(verdict_of(tally), "skipped");
  tally.failed = 1;
  EXPECT_EQ(verdict_of(tally), "fail");
}

TEST(Failures, AreSortedByHowFarTheyAreOverWithNonFiniteFirst) {
  Study study;
  study.comparisons = {row("interior", 0.002, "fail"), row("interior", 0.1, "fail"),
                       row("interior", 0.0, "fail"), row("all", 0.9, "fail"),
                       row("interior", 0.0, "pass")};
  study.comparisons[2].nonfinite = 1;
  EXPECT_THAT(failures_of(study), ElementsAre(&study.comparisons[2], &study.comparisons[1],
                                              &study.comparisons[0], &study.comparisons[3]));
}

TEST(Cases, ThatFailComeFirstThenThoseSkipped) {
  const Study study = mixed_study();
  std::vector<std::string> scenes;
  for (const Case* one : cases_by_verdict(study)) scenes.push_back(one->scene);
  EXPECT_THAT(scenes, ElementsAre("r2-nan", "r1-failing", "r3-skipped", "d1-sun-floor",
                                  "p4-point-both", "s3-spot-cone", kHostile));
}

TEST(LightTypes, ComeInTheModelsOrder) {
  EXPECT_THAT(light_types_of(mixed_study()),
              ElementsAre("directional", "point", "spot", "area", "ambient", "all"));
}

TEST(Headline, SaysWhatHappened) {
  EXPECT_EQ(headline(passing_study()), "Everything agrees");
  EXPECT_EQ(headline(mixed_study()), "8 of 120 comparisons disagree");
  Study skipped = passing_study();
  add_case(skipped, {"r3-skipped", "grid", "area", 1.2e-7, 6e-7, true});
  EXPECT_EQ(headline(skipped), "Nothing disagrees, but 3 of 66 comparisons were skipped");
  Study broken = passing_study();
  broken.cases[0].references[0].failure = "povray exited with 1";
  EXPECT_EQ(headline(broken), "A renderer failed");
}

}  // namespace
}  // namespace litmus

// baseline_test.cpp: each kind of change is told, and nothing else is.
#include "reports/baseline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The row of the point light inside, against POV-Ray.
Comparison& lamp_row(Study& study) {
  for (Comparison& row : study.comparisons)
    if (row.light == "lamp" && row.reference == "povray" && row.region == "interior") return row;
  throw std::logic_error("the sample has no such row");
}

std::vector<std::string> kinds(const BaselineReport& report) {
  std::vector<std::string> kinds;
  for (const BaselineChange& change : report.changes) kinds.push_back(change.kind);
  return kinds;
}

BaselineReport compared(const Study& now, const Study& was) {
  return against_baseline(now, was, "old.json");
}

TEST(Baseline, OfTheSameRunHasNothingToSay) {
  const Study study = mixed_study();
  const BaselineReport report = compared(study, study);
  EXPECT_THAT(report.changes, IsEmpty());
  EXPECT_THAT(report.slower, IsEmpty());
  EXPECT_THAT(report.versions, IsEmpty());
  EXPECT_FALSE(is_regression(report));
  EXPECT_EQ(report.still_failing, 8);
  EXPECT_THAT(baseline_headline(report), HasSubstr("8 still fail"));
}

TEST(Baseline, TellsANewFailureWithItsReason) {
  const Study was = passing_study();
  Study now = was;
  lamp_row(now).verdict = "fail", lamp_row(now).reason = "too far", lamp_row(now).max_abs = 1e-3;
  const BaselineReport report = compared(now, was);
  EXPECT_THAT(kinds(report), ElementsAre("new failure"));
  EXPECT_TRUE(is_regression(report));
  EXPECT_THAT(
      sentence_of(report.changes[0]),
      HasSubstr("p4-point-both, lamp, POV-Ray, interior: the largest difference was 1.2e-7 and "
                "is 1e-3; allowed is 8e-7"));
  EXPECT_EQ(report.changes[0].why, "too far");
}

TEST(Baseline, CallsAFailingRowOfANewSceneANewFailure) {
  const Study was = passing_study();
  Study now = was;
  add_case(now, {"r1-failing", "grid", "area", 3e-4});
  const BaselineReport report = compared(now, was);
  EXPECT_EQ(report.added, 18);
  EXPECT_TRUE(is_regression(report));
}

TEST(Baseline, TellsAFixWithoutCallingItARegression) {
  Study was = passing_study();
  const Study now = was;
  lamp_row(was).verdict = "fail", lamp_row(was).max_abs = 1e-3;
  const BaselineReport report = compared(now, was);
  EXPECT_THAT(kinds(report), ElementsAre("fixed"));
  EXPECT_FALSE(is_regression(report));
}

TEST(Baseline, CallsARowThatPassesWorseJustBeyondItsNoise) {
  Study was = passing_study(), now = was;
  const double limit = noise_limit(lamp_row(was).max_abs, lamp_row(was).tolerance);
  EXPECT_LT(limit, lamp_row(was).tolerance) << "else only failures could be worse";
  lamp_row(now).max_abs = limit * (1 - 1e-9);
  EXPECT_THAT(compared(now, was).changes, IsEmpty());
  lamp_row(now).max_abs = limit * (1 + 1e-9);
  const BaselineReport report = compared(now, was);
  EXPECT_THAT(kinds(report), ElementsAre("worse"));
  EXPECT_TRUE(is_regression(report));
  EXPECT_THAT(sentence_of(report.changes[0]), HasSubstr("the largest difference was 1.2e-7"));
}

TEST(Baseline, JudgesTheMeanByItself) {
  Study was = passing_study(), now = was;
  lamp_row(now).mean_abs = 1.01 * noise_limit(lamp_row(was).mean_abs, lamp_row(was).mean_tolerance);
  const BaselineReport report = compared(now, was);
  ASSERT_THAT(kinds(report), ElementsAre("worse"));
  EXPECT_EQ(report.changes[0].figure, "mean_abs");
}

TEST(Baseline, CallsAnyGrowthWhereNothingIsAllowedWorse) {
  Study was = passing_study(), now = was;
  lamp_row(was).max_abs = lamp_row(was).tolerance = lamp_row(now).tolerance = 0;
  lamp_row(now).max_abs = 1e-12;
  EXPECT_THAT(kinds(compared(now, was)), ElementsAre("worse"));
}

TEST(Baseline, CallsAFailureThatGrewWorseAndOneThatDidNotTheSame) {
  Study was = passing_study();
  lamp_row(was).verdict = "fail", lamp_row(was).max_abs = 1e-3;
  Study now = was;
  EXPECT_EQ(compared(now, was).still_failing, 1);
  EXPECT_FALSE(is_regression(compared(now, was)));
  lamp_row(now).max_abs = 1e-2;
  EXPECT_THAT(kinds(compared(now, was)), ElementsAre("worse"));
  now = was;
  lamp_row(now).nonfinite = 1;
  EXPECT_THAT(sentence_of(compared(now, was).changes.at(0)), HasSubstr("1 pixels are not finite"));
}

TEST(Baseline, LeavesEdgePixelsWithAKnownCauseAlone) {
  Study was = passing_study(), now = was;
  lamp_row(now).max_abs = 0.5, lamp_row(now).over_tolerance = lamp_row(now).explained = 2;
  EXPECT_THAT(compared(now, was).changes, IsEmpty());
}

TEST(Baseline, TellsWhatIsNoLongerCompared) {
  const Study was = passing_study();
  Study now = was;
  std::erase_if(now.comparisons, [](const Comparison& row) {
    return row.light == "lamp" && row.reference == "povray" && row.region == "edge";
  });
  const BaselineReport report = compared(now, was);
  EXPECT_THAT(kinds(report), ElementsAre("missing"));
  EXPECT_EQ(report.changes[0].region, "edge");
}

TEST(Baseline, TellsWhatIsSkippedNow) {
  Study was = with_provenance(), now = with_provenance();
  add_case(was, {"p4-point-both", "lamp", "point"});
  SampleCase skipped{"p4-point-both", "lamp", "point"};
  skipped.blender_skipped = true;
  add_case(now, skipped);
  const BaselineReport report = compared(now, was);
  EXPECT_THAT(kinds(report), ElementsAre("missing", "missing", "missing")) << "one for each layer";
  EXPECT_THAT(report.changes[0].why, HasSubstr("not installed"));
}

TEST(Baseline, SaysNothingOfScenesAndReferencesThatWereNotAskedFor) {
  const Study was = mixed_study();
  Study now = with_provenance();
  add_case(now, {"p4-point-both", "lamp", "point"});
  now.cases[0].references.pop_back();
  std::erase_if(now.comparisons, [](const Comparison& row) { return row.reference == "blender"; });
  EXPECT_THAT(compared(now, was).changes, IsEmpty());
}

TEST(Baseline, TellsAllLightsOnlyWhereNoLightSaysSo) {
  Study was = passing_study(), now = was;
  for (Comparison& row : now.comparisons)
    if (row.scene == "p4-point-both" && row.reference == "povray" && row.light != "ambient")
      row.verdict = "fail", row.max_abs = 1e-3;
  const BaselineReport report = compared(now, was);
  EXPECT_EQ(report.changes.size(), 2u) << "the lamp's interior and edge";
  for (const BaselineChange& change : report.changes) EXPECT_EQ(change.light, "lamp");
}

TEST(BaselineSpeed, IsMeasuredInTheReferencesOfTheSameRun) {
  Study was = passing_study(), now = was;
  for (Case& one : now.cases) {
    one.seconds *= 10;  // a machine that is ten times as slow
    for (CaseReference& r : one.references) r.seconds *= 10;
  }
  EXPECT_THAT(compared(now, was).slower, IsEmpty());
  for (Case& one : now.cases) one.seconds *= 2.1;
  const BaselineReport report = compared(now, was);
  ASSERT_EQ(report.slower.size(), 1u);
  EXPECT_EQ(report.slower[0].scene, "all");
  EXPECT_THAT(sentence_of(report.slower[0]), HasSubstr("2.1 times as much"));
  EXPECT_FALSE(is_regression(report)) << "a busy machine fails nobody";
}

TEST(BaselineSpeed, NamesASceneThatLostMuch) {
  Study was = passing_study(), now = was;
  was.cases[0].seconds = now.cases[0].seconds = 10;  // the rest hides in it
  now.cases[2].seconds = 0.1;
  const BaselineReport report = compared(now, was);
  ASSERT_EQ(report.slower.size(), 1u);
  EXPECT_EQ(report.slower[0].scene, "s3-spot-cone");
}

TEST(BaselineSpeed, IsNotTakenFromStoredPictures) {
  Study was = passing_study();
  for (Case& one : was.cases) one.references[0].source = "stored";
  Study now = was;
  for (Case& one : now.cases) one.seconds *= 100;
  EXPECT_THAT(compared(now, was).slower, IsEmpty());
}

TEST(Baseline, NamesAnotherVersionOnce) {
  Study was = passing_study(), now = was;
  for (Case& one : now.cases) one.references[0].version = "3.8.0";
  const BaselineReport report = compared(now, was);
  ASSERT_EQ(report.versions.size(), 1u);
  EXPECT_EQ(sentence_of(report.versions[0]), "POV-Ray was 3.7.0.10 and is 3.8.0");
}

}  // namespace
}  // namespace litmus

// approval_test.cpp: what may be approved, with what figures, and what may not.
#include "reports/approval.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;

/// One scene that fails against POV-Ray inside.
Study failing() {
  Study study = with_provenance();
  add_case(study, {"r1-failing", "grid", "area", 3e-4});
  return study;
}

std::string refusal(const Study& study) { return approval_refusal(study, "r1-failing", "povray"); }

TEST(Approval, OfAPlainFailureIsNotRefused) { EXPECT_EQ(refusal(failing()), ""); }

TEST(Approval, IsRefusedWhereNothingFails) {
  EXPECT_THAT(approval_refusal(failing(), "r1-failing", "blender"), HasSubstr("nothing fails"));
}

TEST(Approval, IsRefusedForPixelsThatAreNotFinite) {
  Study study = with_provenance();
  add_case(study, {"r1-failing", "grid", "area", 1.2e-7, 6e-7, false, true});
  EXPECT_THAT(refusal(study), HasSubstr("1 pixels of grid are NaN or infinite"));
}

TEST(Approval, IsRefusedForUnregisteredPictures) {
  Study study = failing();
  for (Comparison& row : study.comparisons)
    if (row.verdict == "fail") row.reason = "unregistered: shifted by (-0.5, 0) px";
  EXPECT_THAT(refusal(study), HasSubstr("unregistered: shifted by (-0.5, 0) px"));
}

TEST(Approval, IsRefusedForARunWithAPlantedMistake) {
  Study study = failing();
  study.provenance.command = "litmus run r1 --control cutoff";
  EXPECT_THAT(refusal(study), HasSubstr("planted mistake"));
}

TEST(Approval, IsRefusedForARendererThatFailed) {
  Study study = failing();
  study.cases[0].references[0].failure = "povray exited with 1";
  EXPECT_THAT(refusal(study), HasSubstr("povray exited with 1"));
  EXPECT_THAT(approval_refusal(study, "r1-failing", "blender"), HasSubstr("nothing fails"));
}

TEST(Approval, IsRefusedWhereAClosedFormContradicts) {
  Study study = failing();
  Comparison row = study.comparisons[0];
  row.reference = "closed-form", row.verdict = "fail", row.reason = "off by 1 %";
  study.comparisons.push_back(row);
  EXPECT_THAT(refusal(study), HasSubstr("so the mistake is litmus's"));
  study.comparisons.back().verdict = "pass";
  EXPECT_EQ(refusal(study), "");
}

TEST(Approval, IsRefusedForACandidateWhichHasNoToleranceOfItsOwn) {
  Study study = failing();
  study.candidates.push_back({"mine", "float", 1, ""});
  for (Comparison& row : study.comparisons)
    if (row.reference == "povray") row.reference = "mine";
  EXPECT_THAT(approval_refusal(study, "r1-failing", "mine"), HasSubstr("a candidate has no"));
}

TEST(Approval, RaisesTheToleranceOfTheFailingRegionAlone) {
  const Study study = failing();
  const auto changes = raised_tolerances(failing_rows(study, "r1-failing", "povray"), "why");
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].reference, "povray");
  EXPECT_EQ(changes[0].region, Region::Interior);
  EXPECT_GE(changes[0].tolerance.max_abs, 6e-4 * 0.99);
  EXPECT_EQ(changes[0].reason, "why");
}

TEST(Approval, CommandSurvivesTheShell) {
  Case one;
  one.scene = "it's; rm";
  EXPECT_EQ(approve_command(one, "povray"), "litmus approve 'it'\\''s; rm/povray' --reason '...'");
}

}  // namespace
}  // namespace litmus

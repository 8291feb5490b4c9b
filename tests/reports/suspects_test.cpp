// suspects_test.cpp: one of four disagrees, and the majority names it.
#include "reports/suspects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/closed_form_rows.h"
#include "scene/scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

/// A verdict between two sources of the lamp in one scene.
Comparison pair_row(const std::string& reference, const std::string& against, bool pass) {
  Comparison result;
  result.scene = "p1", result.light = "lamp", result.light_type = "point";
  result.reference = reference, result.against = against, result.region = "interior";
  result.verdict = pass ? "pass" : "fail";
  result.max_abs = pass ? 1e-9 : 0.5;
  return result;
}

/// Four sources, of which `odd` disagrees with all others.
Study study_with(const std::string& odd) {
  Study study;
  const auto agree = [&](const std::string& a, const std::string& b) {
    return a != odd && b != odd;
  };
  for (const char* reference : {"povray", "blender", "closed-form"})
    study.comparisons.push_back(pair_row(reference, "litmus", agree(reference, "litmus")));
  study.pairs = {pair_row("blender", "povray", agree("blender", "povray")),
                 pair_row("closed-form", "povray", agree("closed-form", "povray")),
                 pair_row("closed-form", "blender", agree("closed-form", "blender"))};
  return study;
}

TEST(Suspects, AreNamedByTheMajority) {
  for (const char* odd : {"litmus", "povray", "blender", "closed-form"}) {
    Study study = study_with(odd);
    name_suspects(study);
    int failed = 0;
    for (const Comparison& each : study.comparisons) {
      EXPECT_EQ(each.suspect, each.verdict == "fail" ? odd : "");
      failed += each.verdict == "fail";
    }
    EXPECT_EQ(failed, std::string_view(odd) == "litmus" ? 3 : 1);
  }
}

TEST(Suspects, AreNamedInASentence) {
  Study study = study_with("litmus");
  name_suspects(study);
  EXPECT_THAT(study.comparisons[0].reason,
              HasSubstr("Blender Cycles, closed form and POV-Ray agree with each other, so litmus "
                        "is the suspect"));
}

TEST(Suspects, AreNotNamedInATie) {
  Study study = study_with("none");
  for (Comparison* each :
       {&study.comparisons[0], &study.comparisons[1], &study.pairs[1], &study.pairs[2]})
    each->verdict = "fail";  // litmus and the closed form against both renderers
  name_suspects(study);
  for (const Comparison& each : study.comparisons) EXPECT_EQ(each.suspect, "");
}

TEST(Suspects, NeedAThirdOpinion) {
  Study study;
  study.comparisons = {pair_row("povray", "litmus", false)};
  name_suspects(study);
  EXPECT_EQ(study.comparisons[0].suspect, "");
  EXPECT_EQ(study.comparisons[0].reason, "");
}

TEST(Suspects, AreFoundPerLightOfAScene) {
  Study study = study_with("povray");
  Comparison elsewhere = pair_row("povray", "litmus", false);
  elsewhere.light = "other";
  study.comparisons.push_back(elsewhere);
  name_suspects(study);
  EXPECT_EQ(study.comparisons.back().suspect, "");
}

TEST(PairLines, HaveTheLargestDifferenceOfEachPair) {
  const std::vector<PairLine> lines = pair_lines(study_with("blender"));
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0].against, "litmus");
  for (const PairLine& line : lines) {
    const bool odd = line.reference == "blender" || line.against == "blender";
    EXPECT_EQ(line.failed, odd);
    EXPECT_EQ(line.largest, odd ? 0.5 : 1e-9);
  }
}

/// One layer of four pixels, seen by litmus and by both references.
Case four_pixels(double povray, double blender) {
  Case entry;
  entry.scene = "p1", entry.width = 4, entry.height = 1;
  CaseLayer layer{"lamp", "point", Picture(4, 1), {0, 0, 0, 1}, {}, {}};
  const auto constant = [](double value) {
    Picture picture(4, 1);
    for (auto& pixel : picture.pixels) pixel = glm::dvec3(value);
    return picture;
  };
  layer.theirs = {{"povray", "stored", constant(povray)}, {"blender", "stored", constant(blender)}};
  entry.layers = {layer};
  return entry;
}

TEST(CompareReferences, MeasuresEachAgainstEachInTheInterior) {
  Study study;
  compare_references(four_pixels(0.5, 0.5), study);
  ASSERT_EQ(study.pairs.size(), 1u);
  EXPECT_EQ(study.pairs[0].reference, "blender");
  EXPECT_EQ(study.pairs[0].against, "povray");
  EXPECT_EQ(study.pairs[0].pixels, 3);
  EXPECT_EQ(study.pairs[0].verdict, "pass");
  compare_references(four_pixels(0.5, 0.6), study);
  EXPECT_EQ(study.pairs[1].verdict, "fail");
  EXPECT_NEAR(study.pairs[1].max_abs, 0.1, 1e-15);
}

TEST(CompareReferences, LeavesOutWhatIsMissing) {
  Case entry = four_pixels(0.5, 0.5);
  entry.layers[0].theirs[1] = {"blender", "", {}};
  Study study;
  compare_references(entry, study);
  EXPECT_TRUE(study.pairs.empty());
}

}  // namespace
}  // namespace litmus

// triage_rows_test.cpp: failing rows of whole pictures get their figures, and no others.
#include "reports/triage_rows.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/write_json.h"

namespace litmus {
namespace {

Comparison layer_row(const std::string& light, const std::string& region,
                     const std::string& verdict, const std::string& reference = "blender") {
  Comparison result;
  result.scene = "one", result.reference = reference, result.light = light;
  result.region = region, result.verdict = verdict;
  return result;
}

Study study_of_rows(std::vector<Comparison> rows) {
  Picture ours(16, 16), theirs(16, 16);
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    theirs.pixels[i] = glm::dvec3(0.003 * double(i));
    ours.pixels[i] = 1.1 * theirs.pixels[i];
  }
  CaseLayer layer;
  layer.light = layer.light_type = "all";
  layer.ours = ours;
  layer.theirs = {{"povray", "", {}}, {"blender", "stored", theirs}};
  Case one;
  one.scene = "one";
  one.layers = {layer};
  Study study;
  study.cases = {one};
  study.comparisons = std::move(rows);
  add_triage(study);
  return study;
}

TEST(TriageRows, AreTheFailuresOfWholePictures) {
  const Study study = study_of_rows({layer_row("all", "all", "fail")});
  ASSERT_TRUE(study.comparisons[0].triage);
  EXPECT_GT(study.comparisons[0].triage->ldr_flip, 0.01);
  EXPECT_LT(study.comparisons[0].triage->ssim, 1);
}

TEST(TriageRows, AreNoOthers) {
  const Study study =
      study_of_rows({layer_row("all", "all", "pass"), layer_row("all", "edge", "fail"),
                     layer_row("spot", "all", "fail"), layer_row("all", "all", "fail", "povray"),
                     layer_row("all", "all", "fail", "nobody")});
  for (const Comparison& each : study.comparisons) EXPECT_FALSE(each.triage) << each.light;
}

TEST(TriageRows, AreInTheJsonWhereTheyAre) {
  const Study study =
      study_of_rows({layer_row("all", "all", "fail"), layer_row("all", "all", "pass")});
  const auto rows = nlohmann::json::parse(results_json(study))["comparisons"];
  EXPECT_EQ(rows[0]["triage"]["hdr_flip"], study.comparisons[0].triage->hdr_flip);
  EXPECT_FALSE(rows[1].contains("triage"));
}

}  // namespace
}  // namespace litmus

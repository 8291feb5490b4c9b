// page_data_test.cpp: what the page gets of a scene.
#include "reports/page_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/reports/sample_study.h"

namespace litmus {
namespace {

TEST(PackedDifference, LeavesTheirsInReachEvenWhereOursIsNotFinite) {
  Picture ours(2, 1), theirs(2, 1);
  ours.at(0, 0) = {0.5, NAN, INFINITY};
  theirs.at(0, 0) = {0.25, 0.75, 1};
  const glm::dvec3 packed = packed_difference(ours, theirs).at(0, 0);
  EXPECT_EQ(packed, glm::dvec3(0.25, -0.75, -1));
}

TEST(SceneWord, IsQuotedForTheShellWhereItHasToBe) {
  Case one;
  one.scene = "d1-sun-floor", one.file = "/anywhere/scene/canonical/d1-sun-floor.toml";
  EXPECT_EQ(scene_word(one), "d1-sun-floor");
  one.file = "my scenes/d1-sun-floor.toml";
  EXPECT_EQ(scene_word(one), "'my scenes/d1-sun-floor.toml'");
  one.file = "it's.toml";
  EXPECT_EQ(scene_word(one), "'it'\\''s.toml'");
}

TEST(PicturesJson, NamesAPictureThatItHasShownBefore) {
  Study study = passing_study();
  for (Case& one : study.cases) {
    for (glm::dvec3& pixel : one.layers[0].ours.pixels) pixel = glm::dvec3(0);
    one.layers[2].ours = one.layers[1].ours;
  }
  const auto json = nlohmann::json::parse(pictures_json(study, study.cases[0]));
  EXPECT_EQ(json["layers"][2]["ours"], (nlohmann::json{{"same", "1"}}));
  EXPECT_TRUE(json["layers"][0]["ours"].contains("data"));
}

}  // namespace
}  // namespace litmus

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

TEST(PicturesJson, HasTheWholeAsASumOnlyWhereItIsOne) {
  Study study = passing_study();
  Case& one = study.cases[0];
  const auto whole = [&] {
    return nlohmann::json::parse(pictures_json(study, one))["layers"].back()["ours"];
  };
  EXPECT_EQ(whole(), (nlohmann::json{{"sum", true}}));
  one.layers.back().ours.at(20, 12).x *= 1.01;
  EXPECT_TRUE(whole().contains("data"));
}

TEST(PicturesWithin, MakesFailingScenesCoarseWhereRoomIsShort) {
  const Study study = mixed_study();
  const auto full = pictures_within(study, std::size_t(-1)), least = pictures_within(study, 0);
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    EXPECT_EQ(full[i], pictures_json(study, study.cases[i]));
    const std::string& scene = study.cases[i].scene;
    if (scene == "r1-failing") {
      EXPECT_LT(least[i].size(), full[i].size());
    }
    if (scene == "d1-sun-floor") {
      EXPECT_EQ(least[i], full[i]) << "a scene that passes keeps what it has";
    }
  }
}

}  // namespace
}  // namespace litmus

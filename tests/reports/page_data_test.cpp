// page_data_test.cpp: packed pictures keep their values.
#include "reports/page_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/reports/sample_study.h"

namespace litmus {
namespace {

// The value of a half float's bits, by its definition.
double half_value(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, digits = bits & 1023;
  const double size = exponent == 31 ? (digits ? std::nan("") : INFINITY)
                      : exponent     ? std::ldexp(1024 + digits, exponent - 25)
                                     : std::ldexp(digits, -24);
  return bits & 0x8000 ? -size : size;
}

TEST(HalfBits, AreThoseOfTheStandard) {
  EXPECT_EQ(half_bits(0), 0x0000);
  EXPECT_EQ(half_bits(-0.0), 0x8000);
  EXPECT_EQ(half_bits(1), 0x3c00);
  EXPECT_EQ(half_bits(-2), 0xc000);
  EXPECT_EQ(half_bits(65504), 0x7bff);
  EXPECT_EQ(half_bits(std::ldexp(1, -14)), 0x0400) << "the smallest normal number";
  EXPECT_EQ(half_bits(std::ldexp(1, -24)), 0x0001) << "the smallest number";
  EXPECT_EQ(half_bits(1.0 / 3), 0x3555);
  EXPECT_EQ(half_bits(INFINITY), 0x7c00);
  EXPECT_EQ(half_bits(65520), 0x7c00) << "halfway past the largest number";
  EXPECT_TRUE(std::isnan(half_value(half_bits(std::nan("")))));
}

TEST(HalfBits, AreTheNearestForEveryHalfAndBetween) {
  for (int bits = 0; bits < 0x7bff; ++bits) {
    const double low = half_value(std::uint16_t(bits)), high = half_value(std::uint16_t(bits + 1));
    ASSERT_EQ(half_bits(low), bits);
    ASSERT_EQ(half_bits(low + 0.49 * (high - low)), bits);
    ASSERT_EQ(half_bits(low + 0.51 * (high - low)), bits + 1);
  }
}

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

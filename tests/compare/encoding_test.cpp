// encoding_test.cpp: what codes round away, and that nothing more is forgiven.
#include "compare/encoding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace litmus {
namespace {

using testing::HasSubstr;

constexpr Encoding kFloat{}, kLinear8{8, false}, kSrgb8{8, true}, kSrgb16{16, true};

Picture grey(double value) {
  Picture picture(2, 1);
  picture.pixels = {glm::dvec3(value), glm::dvec3(value)};
  return picture;
}

/// What is written for `light` and read back.
double through(double light, const Encoding& encoding) {
  const double top = encoding.bits == 8 ? 255 : 65535;
  const double value = std::min(light * encoding.exposure, 1.0);
  const double code = std::round((encoding.srgb ? srgb_encoded(value) : value) * top) / top;
  return to_light(grey(code), encoding).pixels[0].x;
}

TEST(Srgb, DecodesWhatItEncodes) {
  for (const double light : {0.0, 1e-4, 0.0031308, 0.01, 0.214, 0.5, 1.0})
    EXPECT_NEAR(srgb_decoded(srgb_encoded(light)), light, 1e-7) << light;
}

TEST(HalfStep, IsHalfOfACodeForALinearEncoding) {
  EXPECT_NEAR(half_step(0.3, kLinear8), 0.5 / 255, 1e-15);
  EXPECT_NEAR(half_step(0.3, {16, false}), 0.5 / 65535, 1e-15);
  EXPECT_EQ(half_step(0.3, kFloat), 0);
}

TEST(HalfStep, OfSrgbIsTheSlopeOfItsTransferFunctionTimesHalfACode) {
  // d/dv ((v + 0.055) / 1.055)^2.4 = 2.4 / 1.055 * (...)^1.4 at v = 0.5 (light 0.214): 0.925.
  EXPECT_NEAR(half_step(0.214, kSrgb8), 0.925 * 0.5 / 255, 1e-5);
  EXPECT_NEAR(half_step(0, kSrgb8), 0.5 / 255 / 12.92, 1e-9);
  EXPECT_NEAR(half_step(1, kSrgb8), 2.2749 * 0.5 / 255, 2e-5);
}

TEST(HalfStep, ShrinksWithTheExposure) {
  EXPECT_NEAR(half_step(0.03, {8, false, 10}), 0.05 / 255, 1e-15);
}

class EveryEncoding : public testing::TestWithParam<std::pair<std::string_view, Encoding>> {};

TEST_P(EveryEncoding, HidesItsOwnRoundingAtEveryLevelAndNoMoreThanTheHalfStep) {
  for (const double exposure : {0.25, 1.0, 3.0}) {
    Encoding encoding = GetParam().second;
    encoding.exposure = exposure;
    if (encoding.bits == 0) continue;
    for (int i = 0; i <= 1000; ++i) {
      const double light = i / 1000.0 / exposure;
      const Cell cell = cell_of(through(light, encoding), encoding);
      ASSERT_LE(cell.low, light) << light;
      ASSERT_GE(cell.high, light) << light;
      ASSERT_LE(std::abs(through(light, encoding) - light),
                half_step(through(light, encoding), encoding) * (1 + 1e-9));
    }
  }
}

TEST_P(EveryEncoding, HasItsName) { EXPECT_EQ(name_of(GetParam().second), GetParam().first); }

INSTANTIATE_TEST_SUITE_P(Encoding, EveryEncoding, testing::ValuesIn(kEncodings),
                         [](const auto& info) {
                           std::string name(info.param.first);
                           std::erase(name, '-');
                           return name;
                         });

TEST(Cell, OfWhiteHoldsEverythingAboveItAndThatOfBlackEverythingBelow) {
  EXPECT_EQ(cell_of(1, kSrgb8).high, std::numeric_limits<double>::infinity());
  EXPECT_LT(cell_of(1, kSrgb8).low, 1);
  EXPECT_EQ(cell_of(0, kSrgb8).low, -std::numeric_limits<double>::infinity());
  EXPECT_GT(cell_of(0, kSrgb8).high, 0);
}

TEST(NearestThatRoundsTo, IsOursWithinTheCellAndItsEndBeyond) {
  const double light = 0.3, read = through(light, kSrgb8);
  const Picture theirs = grey(read);
  EXPECT_EQ(nearest_that_rounds_to(grey(light), {&theirs}, kSrgb8).pixels[0].x, light);
  const Cell cell = cell_of(read, kSrgb8);
  EXPECT_EQ(nearest_that_rounds_to(grey(0.5), {&theirs}, kSrgb8).pixels[0].x, cell.high);
  EXPECT_EQ(nearest_that_rounds_to(grey(0.1), {&theirs}, kSrgb8).pixels[0].x, cell.low);
}

TEST(NearestThatRoundsTo, AddsUpTheRoundingOfEachLayer) {
  const double a = 0.1234, b = 0.0567;
  const Picture first = grey(through(a, kSrgb8)), second = grey(through(b, kSrgb8));
  const Picture nearest = nearest_that_rounds_to(grey(a + b), {&first, &second}, kSrgb8);
  EXPECT_EQ(nearest.pixels[0].x, a + b);
  const double far = a + b + 3 * (half_step(a, kSrgb8) + half_step(b, kSrgb8));
  EXPECT_LT(nearest_that_rounds_to(grey(far), {&first, &second}, kSrgb8).pixels[0].x, far);
}

TEST(NearestThatRoundsTo, KeepsWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Picture good = grey(0.25), bad = grey(nan);
  EXPECT_TRUE(std::isnan(nearest_that_rounds_to(good, {&bad}, kFloat).pixels[0].x));
  EXPECT_TRUE(std::isnan(nearest_that_rounds_to(good, {&bad}, kSrgb8).pixels[0].x));
}

TEST(FinerThan, FindsSixteenBitsWhereEightAreSaid) {
  Picture read = grey(128 / 255.0);
  EXPECT_FALSE(finer_than(read, kSrgb8));
  read.pixels[1].y = (128 * 257 + 1) / 65535.0;
  EXPECT_EQ(finer_than(read, kSrgb8), (std::array{1, 0}));
  EXPECT_FALSE(finer_than(read, kSrgb16));
  EXPECT_FALSE(finer_than(read, kFloat));
}

TEST(ClippedPixels, AreThoseAtWhite) {
  Picture light = grey(0.5);
  EXPECT_EQ(clipped_pixels(light, kSrgb8), 0);
  light.pixels[1].z = 1;
  EXPECT_EQ(clipped_pixels(light, kSrgb8), 1);
  EXPECT_EQ(clipped_pixels(light, kFloat), 0);
}

TEST(Blindness, NamesTheRoundingInMidGrey) {
  EXPECT_EQ(blindness(kFloat), "");
  EXPECT_THAT(blindness(kSrgb8), HasSubstr("0.0018 in mid-grey"));
  EXPECT_THAT(blindness(kSrgb8), HasSubstr("exponent of 66 in place of 64 where ks is below 0."));
}

}  // namespace
}  // namespace litmus

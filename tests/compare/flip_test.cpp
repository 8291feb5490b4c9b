// flip_test.cpp: FLIP against its published values, closed forms and invariants.
#include "compare/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/difference.h"
#include "tests/compare/pictures.h"

namespace litmus {
namespace {

Picture ramp(int width, int height) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture.at(x, y) = {0.1 + 0.8 * x / width, 0.5, 0.2 + 0.6 * y / height};
  return picture;
}

// The largest Hunt-adjusted HyAB distance, green to blue, is 203.6; to the power 0.7 it is 41.28.
// A grey difference of L* below the knee gives 0.95 / (0.4 * 41.28) * L^0.7.
double of_lightness(double difference) {
  return 0.95 / (0.4 * 41.2760) * std::pow(difference, 0.7);
}
double lightness(double y) { return 116 * std::cbrt(y) - 16; }

TEST(LdrFlip, OfConstantsIsThePublishedValue) {
  EXPECT_NEAR(ldr_flip(flat(32, 24, 0.1), flat(32, 24, 0.9)), 0.9514, 5e-5);
}

TEST(LdrFlip, OfASmallGreyDifferenceIsTheClosedForm) {
  EXPECT_NEAR(ldr_flip(flat(8, 8, 0.5), flat(8, 8, 0.55)),
              of_lightness(lightness(0.55) - lightness(0.5)), 1e-6);
}

// The reference program computes in single precision and prints 0.2045: its rounding in the feature
// pipeline, about 1e-8, enters by its square root.
TEST(HdrFlip, OfConstantsIsThePublishedValue) {
  const Exposures exposures = exposures_for(flat(32, 24, 0.1));
  EXPECT_NEAR(exposures.start, 4.41, 5e-3);
  EXPECT_NEAR(exposures.stop, 4.41, 5e-3);
  EXPECT_EQ(exposures.count, 2);
  const double flip = hdr_flip(flat(32, 24, 0.9), flat(32, 24, 0.1));
  EXPECT_NEAR(flip, 0.2045, 1e-4);
  EXPECT_NEAR(flip, of_lightness(100 - lightness(0.85)), 1e-6) << "tone mapped to 0.85 and to 1";
}

TEST(Flip, OfEqualPicturesIsZero) {
  EXPECT_EQ(ldr_flip(ramp(30, 20), ramp(30, 20)), 0);
  EXPECT_EQ(hdr_flip(ramp(30, 20), ramp(30, 20)), 0);
}

TEST(Flip, IsOneAtMostAndSymmetricInTheLdrForm) {
  Picture white = flat(20, 20, 0);
  white.at(10, 10) = glm::dvec3(1);
  const double there = ldr_flip(white, flat(20, 20, 0)), back = ldr_flip(flat(20, 20, 0), white);
  EXPECT_GT(there, 0);
  EXPECT_LE(there, 1);
  EXPECT_DOUBLE_EQ(there, back);
  EXPECT_LE(ldr_flip(flat(9, 9, 0), flat(9, 9, 1)), 1);
}

TEST(Flip, NoticesAnEdgeMoreThanTheSameDifferenceSpreadOut) {
  Picture edge = flat(40, 40, 0.5), smooth = flat(40, 40, 0.5);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      edge.at(x, y) += x < 20 ? 0.02 : -0.02;
      smooth.at(x, y) += 0.02;
    }
  EXPECT_GT(ldr_flip(edge, flat(40, 40, 0.5)), 1.05 * ldr_flip(smooth, flat(40, 40, 0.5)));
}

TEST(Flip, DependsOnTheViewersResolution) {
  Picture checked = flat(40, 40, 0.4);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) checked.at(x, y) += (x + y) % 2 ? 0.3 : 0;
  EXPECT_LT(ldr_flip(checked, flat(40, 40, 0.55), 120), ldr_flip(checked, flat(40, 40, 0.55), 20))
      << "from far away the squares merge";
}

TEST(HdrFlip, SeesADifferenceAboveOneThatTheLdrFormClips) {
  EXPECT_EQ(ldr_flip(flat(16, 16, 4), flat(16, 16, 2)), 0);
  EXPECT_GT(hdr_flip(flat(16, 16, 4), flat(16, 16, 2)), 0.01);
}

TEST(HdrFlip, SeesADifferenceInTheDark) {
  Picture theirs = flat(16, 16, 0.001);
  for (int x = 0; x < 16; ++x) theirs.at(x, 0) = glm::dvec3(1);
  Picture ours = theirs;
  for (int x = 0; x < 16; ++x) ours.at(x, 12) *= 1.5;
  EXPECT_GT(hdr_flip(ours, theirs), 10 * ldr_flip(ours, theirs));
}

TEST(Exposures, StartAtTheBrightestAndStopAtTheMedian) {
  Picture theirs = flat(10, 10, 0.25);
  theirs.at(0, 0) = glm::dvec3(2);
  const Exposures exposures = exposures_for(theirs);
  EXPECT_NEAR(exposures.stop - exposures.start, 3, 1e-12) << "2 is three stops over 0.25";
  EXPECT_EQ(exposures.count, 3);
}

TEST(Exposures, WithABlackMedianTakeThatOfTheLitPixels) {
  Picture theirs = flat(10, 10, 0);
  for (int x = 0; x < 5; ++x) theirs.at(x, 0) = glm::dvec3(x == 0 ? 1 : 0.5);
  const Exposures exposures = exposures_for(theirs);
  EXPECT_NEAR(exposures.stop - exposures.start, 1, 1e-12);
  Picture ours = theirs;
  ours.at(3, 0) *= 1.2;
  const double flip = hdr_flip(ours, theirs);
  EXPECT_GT(flip, 0);
  EXPECT_LE(flip, 1);
}

TEST(Exposures, AreAtMostSixteenStopsApart) {
  Picture theirs = flat(10, 10, 1e-300);
  theirs.at(0, 0) = glm::dvec3(1e6);
  EXPECT_EQ(exposures_for(theirs).count, 16);
}

TEST(Exposures, OfABlackPictureLookAtItAsItIs) {
  const Exposures exposures = exposures_for(flat(4, 4, 0));
  EXPECT_EQ(exposures.start, 0);
  EXPECT_EQ(exposures.stop, 0);
  EXPECT_GT(hdr_flip(flat(4, 4, 0.5), flat(4, 4, 0)), 0.5);
}

TEST(Flip, IsFiniteWhateverThePixels) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity(), 1e308, -1e308, 1e-308}) {
    Picture odd = flat(8, 8, 0.5);
    odd.at(3, 3).y = value;
    for (const double flip :
         {ldr_flip(odd, flat(8, 8, 0.5)), hdr_flip(odd, flat(8, 8, 0.5)),
          hdr_flip(flat(8, 8, 0.5), odd), hdr_flip(flat(8, 8, value), flat(8, 8, 0.5))}) {
      EXPECT_GE(flip, 0) << value;
      EXPECT_LE(flip, 1) << value;
    }
  }
}

TEST(Flip, RefusesDifferentSizesAndIsZeroWithoutPixels) {
  EXPECT_THROW(ldr_flip(flat(2, 3, 0), flat(3, 2, 0)), SizeMismatch);
  EXPECT_THROW(hdr_flip(flat(2, 3, 0), flat(3, 2, 0)), SizeMismatch);
  EXPECT_EQ(ldr_flip({}, {}), 0);
  EXPECT_EQ(hdr_flip({}, {}), 0);
}

}  // namespace
}  // namespace litmus

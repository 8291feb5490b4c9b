// verdict_test.cpp: each gate fails alone.
#include "compare/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace litmus {
namespace {
using ::testing::HasSubstr;

constexpr Tolerance kTolerance{1e-5, 1e-6, "a test"};

// Passes, with every figure at its limit.
Difference at_the_limit() {
  Difference d;
  d.pixels = 100;
  d.max_abs = 1e-5;
  d.mean_abs = 1e-6;
  d.max_at = {12, 40};
  return d;
}

TEST(Judge, PassesAtTheLimit) {
  EXPECT_TRUE(judge(at_the_limit(), kTolerance).pass);
  EXPECT_EQ(judge(at_the_limit(), kTolerance).reason, "");
}

TEST(Judge, FailsOnTheLargestDifferenceAlone) {
  Difference d = at_the_limit();
  d.max_abs = 1.01e-5;
  d.over_tolerance = 3;
  const Verdict verdict = judge(d, kTolerance);
  EXPECT_FALSE(verdict.pass);
  EXPECT_EQ(verdict.reason,
            "the largest difference 1.01e-05 at (12, 40) is over 1e-05; 3 of 100 pixels are");
}

TEST(Judge, FailsOnTheMeanAlone) {
  Difference d = at_the_limit();
  d.mean_abs = 1.01e-6;
  const Verdict verdict = judge(d, kTolerance);
  EXPECT_FALSE(verdict.pass);
  EXPECT_EQ(verdict.reason, "the mean difference 1.01e-06 is over 1e-06");
}

TEST(Judge, FailsOnOneNonFinitePixelWhateverTheTolerance) {
  Difference d = at_the_limit();
  d.nonfinite = 1;
  const double infinity = std::numeric_limits<double>::infinity();
  const Verdict verdict = judge(d, {infinity, infinity, "", true}, 1000);
  EXPECT_FALSE(verdict.pass);
  EXPECT_EQ(verdict.reason, "1 of 100 pixels are NaN or infinite");
}

TEST(Judge, FailsOnAFigureThatIsNaN) {
  Difference d = at_the_limit();
  d.max_abs = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(judge(d, kTolerance).pass);
  d = at_the_limit();
  d.mean_abs = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(judge(d, kTolerance).pass);
}

TEST(Judge, FailsOnARegionWithoutPixelsUnlessItMayBeEmpty) {
  EXPECT_THAT(judge({}, kTolerance).reason, HasSubstr("no pixels"));
  EXPECT_FALSE(judge({}, kTolerance).pass);
  EXPECT_TRUE(judge({}, {1e-5, 1e-6, "", true}).pass);
}

TEST(Judge, PassesOnlyWhereEveryPixelOverToleranceIsExplained) {
  Difference d = at_the_limit();
  d.max_abs = 0.5;
  d.over_tolerance = 3;
  EXPECT_FALSE(judge(d, kTolerance, 2).pass);
  const Verdict verdict = judge(d, kTolerance, 3);
  EXPECT_TRUE(verdict.pass);
  EXPECT_THAT(verdict.reason, HasSubstr("3 pixels are over 1e-05"));
}

TEST(Combine, PassesWhereBothPassAndNamesTheRegionThatFails) {
  EXPECT_TRUE(combine({true, ""}, {true, "explained"}).pass);
  EXPECT_EQ(combine({false, "x"}, {true, ""}).reason, "interior: x");
  EXPECT_EQ(combine({true, ""}, {false, "y"}).reason, "edge: y");
  EXPECT_EQ(combine({false, "x"}, {false, "y"}).reason, "interior: x; edge: y");
  EXPECT_FALSE(combine({false, "x"}, {true, ""}).pass);
}

TEST(Combine, NamesEachRegionThatFails) {
  const RegionVerdict regions[] = {{Region::Interior, {true, ""}},
                                   {Region::Umbra, {false, "x"}},
                                   {Region::Highlight, {false, "y"}}};
  EXPECT_FALSE(combine(regions).pass);
  EXPECT_EQ(combine(regions).reason, "umbra: x; highlight: y");
  EXPECT_TRUE(combine(std::span(regions).first(1)).pass);
}

}  // namespace
}  // namespace litmus

// difference_test.cpp: every figure against a value worked out by hand.
#include "compare/difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/compare/pictures.h"

namespace litmus {
namespace {
using ::testing::ElementsAre;

Difference all(const Picture& ours, const Picture& theirs, double tolerance = 1) {
  return difference(ours, theirs, {}, Region::All, tolerance);
}

std::vector<double> figures(const Difference& d) {
  std::vector<double> values;
  for (const auto& metric : kMetrics<Difference>) values.push_back(d.*metric.member);
  return values;
}

TEST(Difference, OfEqualPicturesIsZero) {
  const Difference d = all(flat(4, 3, 0.3), flat(4, 3, 0.3), 0);
  EXPECT_EQ(d.pixels, 12);
  EXPECT_EQ(d.nonfinite, 0);
  EXPECT_EQ(d.over_tolerance, 0);
  EXPECT_THAT(figures(d), ::testing::Each(0.0));
}

TEST(Difference, BiasIsOursMinusTheirs) {
  EXPECT_DOUBLE_EQ(all(flat(2, 2, 0.5), flat(2, 2, 0.25)).bias, 0.25);
  EXPECT_DOUBLE_EQ(all(flat(2, 2, 0.25), flat(2, 2, 0.5)).bias, -0.25);
}

TEST(Difference, SignsCancelInTheBiasAndNowhereElse) {
  Picture ours = flat(2, 1, 1);
  ours.at(0, 0) += 0.5;
  ours.at(1, 0) -= 0.5;
  const Difference d = all(ours, flat(2, 1, 1));
  EXPECT_EQ(d.bias, 0);
  EXPECT_EQ(d.mean_abs, 0.5);
  EXPECT_EQ(d.rmse, 0.5);
}

TEST(Difference, AveragesOverPixelsAndChannels) {
  Picture ours = flat(2, 1, 0);
  ours.at(1, 0).z = 0.6;
  const Difference d = all(ours, flat(2, 1, 0));
  EXPECT_DOUBLE_EQ(d.bias, 0.1);
  EXPECT_DOUBLE_EQ(d.mean_abs, 0.1);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(0.06));
}

TEST(Difference, FindsTheLargestInAnyChannelAndSaysWhere) {
  Picture ours = flat(5, 4, 0.5);
  ours.at(3, 2).y -= 0.25;
  ours.at(1, 1).x += 0.125;
  const Difference d = all(ours, flat(5, 4, 0.5));
  EXPECT_EQ(d.max_abs, 0.25);
  EXPECT_THAT(d.max_at, ElementsAre(3, 2));
}

TEST(Difference, RelativeIsToTheirsWithAFloor) {
  Picture ours = flat(1, 1, 0), theirs = flat(1, 1, 0);
  ours.at(0, 0) = {0.4, 0, 0};
  theirs.at(0, 0) = {0.5, 0, 0};
  EXPECT_DOUBLE_EQ(all(ours, theirs).max_relative, 0.2);
  ours.at(0, 0) = {0, 0, 1e-6};
  theirs.at(0, 0) = {0, 0, 0};
  EXPECT_DOUBLE_EQ(all(ours, theirs).max_relative, 1e-3) << "1e-6 over the floor of 1e-3";
}

TEST(Difference, PercentilesAreByNearestRank) {
  Picture ours(1000, 1);
  for (int x = 0; x < 1000; ++x) ours.at(999 - x, 0) = glm::dvec3(x + 1);  // 1..1000
  const Difference d = all(ours, Picture(1000, 1));
  EXPECT_EQ(d.p50, 500);
  EXPECT_EQ(d.p95, 950);
  EXPECT_EQ(d.p99, 990);
  EXPECT_EQ(d.p999, 999);
  EXPECT_EQ(d.max_abs, 1000);
}

TEST(Difference, PercentilesOfOnePixelAreItsValue) {
  const Difference d = all(flat(1, 1, 3), flat(1, 1, 1));
  EXPECT_EQ(d.p50, 2);
  EXPECT_EQ(d.p999, 2);
}

TEST(Difference, CountsThePixelsOverToleranceWorstFirst) {
  Picture ours = flat(4, 1, 0);
  ours.at(0, 0) = {0.1, 0.1, 0.1};
  ours.at(1, 0) = {0.2, -0.3, 0};
  ours.at(3, 0) = {0, 0, 0.25};
  const Difference d = all(ours, flat(4, 1, 0), 0.1);
  EXPECT_EQ(d.over_tolerance, 2) << "equal to the tolerance is not over it";
  ASSERT_EQ(d.over.size(), 2u);
  EXPECT_EQ(d.over[0].x, 1);
  EXPECT_EQ(d.over[0].max_abs, 0.3);
  EXPECT_EQ(d.over[1].x, 3);
  EXPECT_EQ(d.over[1].y, 0);
}

TEST(Difference, SplitsTheRegions) {
  Picture ours = flat(3, 1, 0);
  ours.at(1, 0) = glm::dvec3(1);
  const std::vector<std::uint8_t> edge{0, 1, 0};
  const auto in = [&](Region region) { return difference(ours, flat(3, 1, 0), edge, region, 0.5); };
  EXPECT_EQ(in(Region::Interior).pixels, 2);
  EXPECT_EQ(in(Region::Interior).max_abs, 0);
  EXPECT_EQ(in(Region::Edge).pixels, 1);
  EXPECT_EQ(in(Region::Edge).mean_abs, 1);
  EXPECT_EQ(in(Region::All).pixels, 3);
  EXPECT_EQ(in(Region::All).over_tolerance, 1);
}

TEST(Difference, OfAnEmptyRegionIsZeros) {
  const Difference d = difference(flat(2, 2, 1), flat(2, 2, 5), {}, Region::Edge, 0);
  EXPECT_EQ(d.pixels, 0);
  EXPECT_EQ(d.over_tolerance, 0);
  EXPECT_THAT(figures(d), ::testing::Each(0.0));
}

// The value, in ours or in theirs, in one channel of one pixel of two.
struct NonFinite : ::testing::TestWithParam<double> {};

TEST_P(NonFinite, PixelIsCountedInOursAndLeftOutOfTheFigures) {
  Picture ours = flat(2, 1, 0.75);
  ours.at(0, 0).y = GetParam();
  const Difference d = all(ours, flat(2, 1, 0.5));
  EXPECT_EQ(d.pixels, 2);
  EXPECT_EQ(d.nonfinite, 1);
  EXPECT_EQ(d.mean_abs, 0.25);
  EXPECT_EQ(d.max_abs, 0.25);
  EXPECT_THAT(d.max_at, ElementsAre(1, 0));
}

TEST_P(NonFinite, PixelIsCountedInTheirs) {
  Picture theirs = flat(2, 1, 0.5);
  theirs.at(1, 0).z = GetParam();
  const Difference d = all(flat(2, 1, 0.75), theirs);
  EXPECT_EQ(d.nonfinite, 1);
  EXPECT_EQ(d.max_abs, 0.25);
}

TEST_P(NonFinite, PixelEqualInBothIsStillCounted) {
  EXPECT_EQ(all(flat(1, 1, GetParam()), flat(1, 1, GetParam())).nonfinite, 1);
}

TEST_P(NonFinite, PicturesGiveFiniteFigures) {
  const Difference d = all(flat(3, 3, GetParam()), flat(3, 3, 0.5));
  EXPECT_EQ(d.nonfinite, 9);
  EXPECT_THAT(figures(d), ::testing::Each(0.0));
}

INSTANTIATE_TEST_SUITE_P(Kinds, NonFinite, ::testing::Values(kNaN, kInfinity, -kInfinity));

TEST(Difference, OfHugeValuesNeitherOverflowsNorLosesThem) {
  const Difference d = all(flat(10, 10, 1e200), flat(10, 10, -1e200));
  EXPECT_DOUBLE_EQ(d.rmse, 2e200);
  EXPECT_DOUBLE_EQ(d.bias, 2e200);
  EXPECT_DOUBLE_EQ(d.p99, 2e200);
}

TEST(Difference, BeyondTheRangeOfDoubleStaysFinite) {
  const Difference d = all(flat(1, 1, 1.7e308), flat(1, 1, -1.7e308));
  EXPECT_EQ(d.max_abs, std::numeric_limits<double>::max());
  EXPECT_EQ(d.rmse, std::numeric_limits<double>::max());
  EXPECT_EQ(d.nonfinite, 0);
}

TEST(Difference, OfTinyValuesDoesNotUnderflow) {
  EXPECT_DOUBLE_EQ(all(flat(2, 2, 1e-200), flat(2, 2, 0)).rmse, 1e-200);
}

TEST(Difference, RefusesPicturesOfDifferentSize) {
  EXPECT_THROW(all(flat(2, 3, 0), flat(3, 2, 0)), SizeMismatch);
  const std::vector<std::uint8_t> edge(5);
  EXPECT_THROW(difference(flat(2, 2, 0), flat(2, 2, 0), edge, Region::All, 0), SizeMismatch);
}

TEST(Metrics, HaveDifferentNames) {
  std::set<std::string_view> names;
  for (const auto& metric : kMetrics<Difference>)
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
}

TEST(Difference, OfMembersLooksAtNoOtherPixel) {
  Picture ours(3, 1), theirs(3, 1);
  ours.at(0, 0) = glm::dvec3(5), ours.at(1, 0) = glm::dvec3(0.5);
  const Difference d = difference(ours, theirs, std::vector<std::uint8_t>{0, 1, 1}, 0.1);
  EXPECT_EQ(d.pixels, 2);
  EXPECT_EQ(d.max_abs, 0.5);
  EXPECT_EQ(d.over_tolerance, 1);
}

}  // namespace
}  // namespace litmus

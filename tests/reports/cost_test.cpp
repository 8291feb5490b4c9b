// cost_test.cpp: reading a cost study: the front, the cheapest setting, regions and times.
#include "reports/cost.h"

#include <gtest/gtest.h>

#include "reports/cost_measure.h"

namespace litmus {
namespace {

CostPoint point(double knob, double seconds, double error) {
  return {knob, "n", {{CostRegion::All, {error, error, error}}}, {seconds, seconds, 0, 7}};
}

CostTopic topic() {
  CostTopic topic;
  topic.series = {{"grid", "litmus"}, {"povray-grid", "povray"}};
  topic.series[0].points = {point(1, 1, 0.1), point(2, 4, 0.02), point(4, 16, 0.03)};
  topic.series[1].points = {point(1, 2, 0.2), point(2, 8, 0.001)};
  topic.truth_error = {{CostRegion::All, {1e-4, 1e-4, 1e-4}}};
  return topic;
}

TEST(ParetoFront, HoldsWhatNothingBeatsInBothTimeAndError) {
  const CostTopic one = topic();
  const auto front = pareto_front(one, ErrorMetric::Max);
  ASSERT_EQ(front.size(), 3u);
  EXPECT_EQ(front[0].point, &one.series[0].points[0]);
  EXPECT_EQ(front[1].point, &one.series[0].points[1]);
  EXPECT_EQ(front[2].point, &one.series[1].points[1]);
}

TEST(Cheapest, KeepsTheErrorAndTheRenderer) {
  const CostTopic one = topic();
  EXPECT_EQ(cheapest(one, "", ErrorMetric::Max, 0.05).point, &one.series[0].points[1]);
  EXPECT_EQ(cheapest(one, "povray", ErrorMetric::Max, 0.05).point, &one.series[1].points[1]);
  EXPECT_EQ(cheapest(one, "litmus", ErrorMetric::Max, 0.01).point, nullptr);
  EXPECT_EQ(cheapest(one, "blender", ErrorMetric::Max, 1).point, nullptr);
}

TEST(Cheapest, SaysNothingBelowThreeTimesTheTruthsOwnError) {
  CostTopic one = topic();
  one.series[0].points.push_back(point(64, 99, 1e-5));
  EXPECT_NE(cheapest(one, "", ErrorMetric::Max, 4e-4).point, nullptr);
  EXPECT_EQ(cheapest(one, "", ErrorMetric::Max, 2e-4).point, nullptr);
}

TEST(TimeOf, IsTheLeastTheMedianAndTheMedianDeviation) {
  const CostTime time = time_of({3, 1, 2, 10, 2.5});
  EXPECT_EQ(time.least, 1);
  EXPECT_EQ(time.median, 2.5);
  EXPECT_EQ(time.spread, 0.5);
  EXPECT_EQ(time.repeats, 5);
}

TEST(RegionsOf, PutsAPixelWhereItsLightsAre) {
  Rendering rendering;
  rendering.whole = Picture(5, 1);
  rendering.flags = {
      {0, 0, 0, 0, 0}, {kLit, kPenumbra, kUmbra, kUmbra, 0}, {kLit, kLit, kLit, kPenumbra, 0}};
  EXPECT_EQ(regions_of(rendering),
            (std::vector{CostRegion::Lit, CostRegion::Penumbra, CostRegion::Umbra,
                         CostRegion::Penumbra, CostRegion::All}));
}

TEST(Figures, AreByRegionAndLeaveOutEmptyOnes) {
  CostTruth truth{Picture(2, 1), {CostRegion::Lit, CostRegion::All}, {}};
  Picture picture(2, 1);
  picture.at(0, 0) = {0, -0.25, 0.125};
  picture.at(1, 0) = {0.5, 0, 0};
  const CostFigures found = figures(picture, truth);
  EXPECT_EQ(found.at(CostRegion::Lit)[0], 0.25);
  EXPECT_EQ(found.at(CostRegion::All)[0], 0.5);
  EXPECT_EQ(found.count(CostRegion::Umbra), 0u);
}

TEST(Measure, TakesEachSettingsErrorAndTimesItInTurns) {
  CostTopic one;
  one.series = {{"a", "litmus"}};
  one.series[0].points = {{1, "one", {}, {}}, {2, "two", {}, {}}};
  std::string order;
  const auto job = [&](std::size_t i, double value) {
    return CostJob{0, i, [&order, i, value] {
                     order += char('0' + i);
                     Picture picture(1, 1);
                     picture.at(0, 0) = {value, 0, 0};
                     return picture;
                   }};
  };
  measure(one, {job(0, 0.5), job(1, 0.25)}, {Picture(1, 1), {CostRegion::All}, {}},
          {.quick = true});
  EXPECT_EQ(order, "01010101") << "once for the error and to warm up, three times for the time";
  EXPECT_EQ(one.series[0].points[1].errors.at(CostRegion::All)[0], 0.25);
  EXPECT_EQ(one.series[0].points[1].time.repeats, 3);
}

}  // namespace
}  // namespace litmus

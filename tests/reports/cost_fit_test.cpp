// cost_fit_test.cpp: orders of curves whose order is known.
#include "reports/cost_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace litmus {
namespace {

std::vector<KnobError> power_law(double order, double noise) {
  std::vector<KnobError> curve;
  int sign = 1;
  for (const double n : {4, 6, 8, 11, 16, 23, 32, 45, 64}) {
    curve.push_back({n, 0.3 * std::pow(n, order) * (1 + sign * noise)});
    sign = -sign;
  }
  return curve;
}

TEST(FitOrder, IsTheExponentOfAPowerLaw) {
  const CostFit fit = fit_order(power_law(-1.5, 0));
  EXPECT_NEAR(fit.order, -1.5, 1e-12);
  EXPECT_NEAR(fit.low, -1.5, 1e-9);
  EXPECT_NEAR(fit.high, -1.5, 1e-9);
  EXPECT_EQ(fit.points, 9);
}

TEST(FitOrder, HasAnIntervalThatGrowsWithTheNoise) {
  const CostFit little = fit_order(power_law(-2, 0.05)), much = fit_order(power_law(-2, 0.3));
  EXPECT_LT(little.low, -2 + 0.03);
  EXPECT_GT(little.high, -2 - 0.03);
  EXPECT_GT(much.high - much.low, 3 * (little.high - little.low));
}

TEST(FitOrder, NeedsThreePoints) {
  EXPECT_EQ(fit_order(std::vector<KnobError>{{1, 1}, {2, 0.5}}).points, 0);
  EXPECT_EQ(fit_order(std::vector<KnobError>{{1, 1}, {2, 0.5}, {4, 0}}).points, 0)
      << "an error of 0 has no logarithm";
}

TEST(FitOrders, LeavesOutSmallKnobsAndWhatTheTruthCannotTell) {
  CostSeries series;
  for (const double n : {1, 2, 4, 8, 16, 32}) {
    const double error = n < 4 ? 1 : std::pow(n, -2);
    series.points.push_back({n, "", {{CostRegion::All, {error, error, error}}}, {}});
  }
  const CostFigures truth{{CostRegion::All, {1.0 / 600, 0, 1}}};
  const std::vector<CostFit> fits = fit_orders(series, truth);
  ASSERT_EQ(fits.size(), 1u) << "max has points 4 and 8 left, rms none";
  EXPECT_EQ(fits[0].metric, ErrorMetric::P99);
  EXPECT_EQ(fits[0].points, 4);
  EXPECT_NEAR(fits[0].order, -2, 1e-12);
}

}  // namespace
}  // namespace litmus

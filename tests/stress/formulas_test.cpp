// formulas_test.cpp: every formula keeps its bound where its usual form does not.
#include <gtest/gtest.h>

#include "stress/random.h"
#include "stress/stress.h"
#include "stress/ulp.h"

namespace litmus {
namespace {

TEST(Ulps, CountUnitsInTheLastPlaceOfTheExactValue) {
  EXPECT_EQ(ulps(1.0 + 0x1p-52, Quad(1)), 1.0);
  EXPECT_EQ(ulps(0.75, Quad(0.75) + Quad(0x1p-54)), 0.5);
  EXPECT_EQ(ulps(3.0f, Quad(3)), 0.0);
}

TEST(Ulps, AreInfiniteForWhatIsNotFinite) {
  EXPECT_TRUE(std::isinf(ulps(std::nan(""), Quad(1))));
  EXPECT_TRUE(std::isinf(ulps(std::numeric_limits<float>::infinity(), Quad(1))));
}

TEST(Ulps, BelowTheSmallestNormalNumberCountThatNumber) {
  EXPECT_EQ(ulps(0.0, Quad(std::numeric_limits<double>::min()) / 4), 0.25);
}

TEST(Draw, DependsOnStreamAndIndexAlone) {
  EXPECT_EQ(Draw(1, 7).bits(), Draw(1, 7).bits());
  EXPECT_NE(Draw(1, 7).bits(), Draw(1, 8).bits());
  EXPECT_NE(Draw(1, 7).bits(), Draw(2, 7).bits());
}

TEST(Draw, SpreadsEvenlyOverTheDecades) {
  int low = 0;
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const double x = Draw(3, i).decades(1e-300, 1e300);
    ASSERT_TRUE(x >= 1e-300 && x <= 1e300);
    low += x < 1;
  }
  EXPECT_NEAR(low, 5000, 250);
}

TEST(StressFormulas, KeepTheirBoundsWhereTheUsualFormsDoNot) {
  StressOptions options;
  options.samples = 30'000;
  const std::vector<StressRow> rows = stress_formulas(options);
  EXPECT_EQ(rows.size(), 16u);
  for (const StressRow& row : rows) {
    EXPECT_LE(row.seen, row.bound) << row.id;
    EXPECT_GT(row.control_seen, row.bound) << row.id << ": " << row.control;
    EXPECT_TRUE(holds(row)) << row.id;
  }
}

TEST(StressFormulas, AreTheSameEveryTime) {
  StressOptions options;
  options.samples = 3'000;
  const std::vector<StressRow> once = stress_formulas(options), again = stress_formulas(options);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].seen, again[i].seen) << once[i].id;
    EXPECT_EQ(once[i].curve->robust, again[i].curve->robust) << once[i].id;
  }
}

}  // namespace
}  // namespace litmus

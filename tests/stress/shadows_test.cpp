// shadows_test.cpp: no surface shadows itself and no occluder is missed, at the same settings.
#include <gtest/gtest.h>

#include "stress/stress.h"

namespace litmus {
namespace {

TEST(StressShadows, AreNeitherFalseNorMissedInTenMillionRays) {
  StressOptions options;
  options.rays = 14'000'000;  // a quarter of the rays sees nothing, or a lamp behind the surface
  const std::vector<StressRow> rows = stress_shadows(options);
  ASSERT_EQ(rows.size(), 8u);
  for (const StressRow& row : rows) {
    if (!row.judged) continue;
    EXPECT_EQ(row.seen, 0) << row.id;
    EXPECT_GT(row.control_seen, 0) << row.id << ": " << row.control;
    if (row.id.starts_with("self-shadow")) {
      EXPECT_GE(row.samples, 10'000'000u) << row.id;
    }
  }
}

}  // namespace
}  // namespace litmus

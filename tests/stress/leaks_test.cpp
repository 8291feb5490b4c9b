// leaks_test.cpp: nothing gets out of a closed mesh, in either build.
#include <gtest/gtest.h>

#include "stress/stress.h"

namespace litmus {
namespace {

TEST(StressLeaks, AreNoneWhereMoellerTrumboreHasMany) {
  StressOptions options;
  options.rays = 10'000'000;
  const std::vector<StressRow> rows = stress_leaks(options);
  ASSERT_EQ(rows.size(), 4u);
  for (const StressRow& row : rows) {
    EXPECT_TRUE(row.judged) << row.domain;
    EXPECT_GE(row.samples, 9'900'000u) << row.id;
    EXPECT_EQ(row.seen, 0) << row.id;
    EXPECT_GT(row.control_seen, 1000) << row.id;
  }
}

}  // namespace
}  // namespace litmus

// pictures_test.cpp: hostile scenes stay finite; rounding modes agree on every decision.
#include <gtest/gtest.h>

#include <cfenv>
#include <set>

#include "stress/hostile_scenes.h"
#include "stress/stress.h"

namespace litmus {
namespace {

TEST(StressPictures, KeepTheirBoundsWhereTheirControlsDoNot) {
  for (const StressRow& row : stress_pictures({})) {
    EXPECT_LE(row.seen, row.bound) << row.id;
    EXPECT_GT(row.control_seen, row.bound) << row.id << ": " << row.control;
  }
}

TEST(StressPictures, LeaveTheRoundingModeAsItWas) {
  StressOptions options;
  stress_pictures(options);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(HostileScenes, AreManyAndNamed) {
  std::set<std::string> names;
  for (const Scene& scene : hostile_scenes()) names.insert(scene.name);
  EXPECT_GE(names.size(), 30u);
}

}  // namespace
}  // namespace litmus

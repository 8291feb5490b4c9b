// peers_test.cpp: turns, ratios within a repeat, and who is missing.
#include "reports/peers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "reports/peer_entrants.h"

namespace litmus {
namespace {

using testing::ElementsAre;

TEST(TakeTurns, LetsEveryRowGoOnceARepeat) {
  std::string order;
  const auto entrant = [&](char name) {
    return Entrant{std::string(1, name), [&order, name] { return order += name, 1.0; }};
  };
  const PeerTask task = take_turns({}, {entrant('a'), entrant('b')}, {.repeats = 3});
  EXPECT_EQ(order, "ababab");
  EXPECT_THAT(task.rows[1].seconds, ElementsAre(1, 1, 1));
}

TEST(TakeTurns, SaysWhyARowIsMissing) {
  int calls = 0;
  const auto fails = [&]() -> double {
    ++calls;
    throw std::runtime_error("stopped after 300 s");
  };
  const std::vector<PeerTask> tasks{take_turns(
      {}, {{"ours", [] { return 1.0; }}, {"theirs", fails}, {"absent", {}, "not installed"}},
      {.repeats = 2})};
  EXPECT_EQ(tasks[0].rows[0].missing, "");
  EXPECT_EQ(tasks[0].rows[1].missing, "stopped after 300 s");
  EXPECT_EQ(tasks[0].rows[2].missing, "not installed");
  EXPECT_EQ(calls, 1) << "what failed is not tried again";
  EXPECT_FALSE(complete(tasks));
}

TEST(PeerRatio, DoesNotSeeAMachineThatIsBusyForARepeat) {
  const PeerTask task{.rows = {{"ours", "", {0.010, 0.020, 0.010}},
                               {"theirs", "", {0.040, 0.080, 0.050}},
                               {"absent", "not installed", {}}}};
  const PeerRatio ratio = task.ratio(task.rows[1]);
  EXPECT_DOUBLE_EQ(ratio.median, 4);
  EXPECT_DOUBLE_EQ(ratio.least, 4);
  EXPECT_DOUBLE_EQ(ratio.most, 5);
  EXPECT_EQ(task.ratio(task.rows[2]).median, 0) << "no ratio where there is no time";
}

TEST(LeastOf, TakesTheShortestOfSeveral) {
  double next = 0.06;
  EXPECT_NEAR(least_of([&] { return next -= 0.01; }), 0.03, 1e-9) << "0.05 + 0.04 + 0.03 > 0.1";
}

}  // namespace
}  // namespace litmus

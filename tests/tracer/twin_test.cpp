// Twins: the lanes of two packets in order.
#include "tracer/twin.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace litmus {
namespace {

using P = NativePacket<double>;
using T = Twin<P>;
constexpr int kLanesOfTwin = kLanes<T>;

T numbered() {
  T twin;
  for (int i = 0; i < kLanesOfTwin; ++i) set_lane(twin, i, double(i));
  return twin;
}

TEST(Twin, NumbersItsLanesThroughBothPackets) {
  const T twin = numbered();
  for (int i = 0; i < kLanesOfTwin; ++i) EXPECT_EQ(lane(twin, i), i);
  EXPECT_EQ(lane(twin.high, 0), kLanes<P>);
  EXPECT_EQ(largest_of(twin), kLanesOfTwin - 1);
  EXPECT_EQ(smallest_of(twin), 0);
}

TEST(Twin, ComparesLaneByLane) {
  for (int least = 0; least <= kLanesOfTwin; ++least) {
    const Mask<T> mask = numbered() >= T(double(least));
    EXPECT_EQ(any_of(mask), least < kLanesOfTwin);
    EXPECT_EQ(none_of(mask), least == kLanesOfTwin);
    EXPECT_EQ(all_of(mask), least == 0);
    EXPECT_EQ(count_of(mask), kLanesOfTwin - least);
    EXPECT_EQ(lanes_of(mask), ((1u << kLanesOfTwin) - 1) >> least << least);
    EXPECT_EQ(any_of(mask) ? first_of(mask) : kLanesOfTwin, least);
  }
}

TEST(Twin, WritesThreeValuesLaneByLane) {
  const T x = numbered(), y = x + T(100.0), z = x + T(200.0);
  std::vector<double> written(3 * kLanesOfTwin);
  copy_interleaved(x, y, z, written.data());
  for (int i = 0; i < kLanesOfTwin; ++i) {
    EXPECT_EQ(written[std::size_t(3 * i)], i);
    EXPECT_EQ(written[std::size_t(3 * i + 1)], 100 + i);
    EXPECT_EQ(written[std::size_t(3 * i + 2)], 200 + i);
  }
}

}  // namespace
}  // namespace litmus

// regions_test.cpp: the edge mask.
#include "compare/regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace litmus {
namespace {
using ::testing::Each;
using ::testing::ElementsAre;

TEST(EdgeMask, IsEmptyWhereTheSignatureIsConstant) {
  EXPECT_THAT(edge_mask({4, 3, std::vector<std::uint64_t>(12, 7)}), Each(0));
}

TEST(EdgeMask, MarksAllEightNeighboursOfAPixelThatDiffers) {
  Signature signature{5, 5, std::vector<std::uint64_t>(25, 1)};
  signature.values[12] = 2;
  // clang-format off
  EXPECT_THAT(edge_mask(signature), ElementsAre(0, 0, 0, 0, 0,
                                                0, 1, 1, 1, 0,
                                                0, 1, 1, 1, 0,
                                                0, 1, 1, 1, 0,
                                                0, 0, 0, 0, 0));
  // clang-format on
}

TEST(EdgeMask, MarksBothSidesOfAnEdge) {
  EXPECT_THAT(edge_mask({6, 1, {1, 1, 1, 2, 2, 2}}), ElementsAre(0, 0, 1, 1, 0, 0));
}

TEST(EdgeMask, DoesNotReachAroundTheBorder) {
  EXPECT_THAT(edge_mask({4, 2, {1, 1, 1, 1, 1, 1, 1, 2}}), ElementsAre(0, 0, 1, 1, 0, 0, 1, 1));
}

TEST(EdgeMask, SeesADifferenceInTheHighestBit) {
  EXPECT_THAT(edge_mask({2, 1, {1, 1 | std::uint64_t{1} << 63}}), Each(1));
}

TEST(EdgeMask, OfOnePixelIsZero) { EXPECT_THAT(edge_mask({1, 1, {5}}), ElementsAre(0)); }

TEST(EdgeMask, OfNothingIsNothing) { EXPECT_TRUE(edge_mask({}).empty()); }

}  // namespace
}  // namespace litmus

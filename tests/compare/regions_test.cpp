// regions_test.cpp: the edge mask, and the regions of a light.
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

TEST(RegionMask, TellsLitPenumbraAndUmbraApart) {
  const std::vector<std::uint8_t> flags{0, kLit, kPenumbra, kUmbra, kLit | kUmbra};
  const std::vector<std::uint8_t> edge(5);
  EXPECT_THAT(region_mask(flags, edge, Region::Lit), ElementsAre(0, 1, 0, 0, 0));
  EXPECT_THAT(region_mask(flags, edge, Region::Penumbra), ElementsAre(0, 0, 1, 0, 1));
  EXPECT_THAT(region_mask(flags, edge, Region::Umbra), ElementsAre(0, 0, 0, 1, 0));
}

TEST(RegionMask, OfTheHighlightOverlapsTheOthers) {
  const std::vector<std::uint8_t> flags{kLit, kLit | kHighlight, kPenumbra | kHighlight};
  const std::vector<std::uint8_t> edge(3);
  EXPECT_THAT(region_mask(flags, edge, Region::Highlight), ElementsAre(0, 1, 1));
  EXPECT_THAT(region_mask(flags, edge, Region::Lit), ElementsAre(1, 1, 0));
}

TEST(RegionMask, LeavesOutEdges) {
  EXPECT_THAT(region_mask(std::vector<std::uint8_t>{kLit, kLit}, std::vector<std::uint8_t>{0, 1},
                          Region::Lit),
              ElementsAre(1, 0));
}

}  // namespace
}  // namespace litmus

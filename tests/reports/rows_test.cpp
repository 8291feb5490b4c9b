// rows_test.cpp: one layer's rows, region by region.
#include "reports/rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/tolerances.h"

namespace litmus {
namespace {
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<glm::dvec3> nothing(double, double) { return {}; }

/// 20 x 10 pixels: a lit half with a highlight in it, an umbra, and an edge between them.
CaseLayer lamp() {
  CaseLayer layer;
  layer.light = "lamp", layer.light_type = "point";
  layer.ours = Picture(20, 10);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) {
      const bool lit = x < 10, edge = x == 9 || x == 10;
      layer.ours.at(x, y) = glm::dvec3(lit ? 0.2 + 0.05 * x + 0.01 * y : 0);
      layer.edge.push_back(edge);
      layer.flags.push_back(std::uint8_t(lit ? kLit : kUmbra) | (x == 4 ? kHighlight : 0));
    }
  return layer;
}

std::vector<std::string> regions(const std::vector<Comparison>& rows) {
  std::vector<std::string> names;
  for (const Comparison& row : rows) names.push_back(row.region);
  return names;
}

std::vector<std::string> failing(const std::vector<Comparison>& rows) {
  std::vector<std::string> names;
  for (const Comparison& row : rows)
    if (row.verdict == "fail") names.push_back(row.region);
  return names;
}

TEST(CompareLayer, HasARowForEachRegionWithPixels) {
  const CaseLayer layer = lamp();
  const std::vector<Comparison> rows = compare_layer(layer, 1, layer.ours, "povray", nothing);
  EXPECT_THAT(regions(rows), ElementsAre("interior", "lit", "umbra", "highlight", "edge", "all"));
  EXPECT_THAT(failing(rows), ElementsAre());
  EXPECT_EQ(rows[0].pixels, 180);
  EXPECT_EQ(rows[1].pixels, 90);
  EXPECT_EQ(rows[3].pixels, 10);
  EXPECT_EQ(rows[3].tolerance, find_tolerance("povray", Region::Highlight).max_abs);
}

TEST(CompareLayer, HasNoRegionsOfAmbientLightOrTheWhole) {
  CaseLayer layer = lamp();
  for (const char* light : {"ambient", "all"}) {
    layer.light = light;
    EXPECT_THAT(regions(compare_layer(layer, 0, layer.ours, "povray", nothing)),
                ElementsAre("interior", "edge", "all"));
  }
}

TEST(CompareLayer, FailsTheRegionThatIsOffAndWhatHoldsIt) {
  const CaseLayer layer = lamp();
  Picture theirs = layer.ours;
  theirs.at(4, 5) += glm::dvec3(1e-3);
  const std::vector<Comparison> rows = compare_layer(layer, 1, theirs, "povray", nothing);
  EXPECT_THAT(failing(rows), ElementsAre("interior", "lit", "highlight", "all"));
  EXPECT_THAT(rows.back().reason, HasSubstr("highlight: the largest difference 0.001 at (4, 5)"));
}

TEST(CompareLayer, FailsAnUmbraThatOnlyItsOwnToleranceSees) {
  const CaseLayer layer = lamp();
  Picture theirs = layer.ours;
  theirs.at(15, 5) = glm::dvec3(1e-8);  // within the interior's tolerance
  EXPECT_THAT(failing(compare_layer(layer, 1, theirs, "blender", nothing)),
              ElementsAre("umbra", "all"));
}

TEST(CompareLayer, HintsAtAFactor) {
  const CaseLayer layer = lamp();
  Picture theirs = layer.ours;
  for (glm::dvec3& pixel : theirs.pixels) pixel /= 3.141592653589793;
  for (const Comparison& row : compare_layer(layer, 1, theirs, "povray", nothing)) {
    if (row.verdict == "fail")
      EXPECT_THAT(row.hint, StartsWith("ours is 3.1416 times theirs: a factor of pi"));
    else
      EXPECT_EQ(row.hint, "");
  }
}

}  // namespace
}  // namespace litmus

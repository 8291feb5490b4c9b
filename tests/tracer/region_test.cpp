// region_test.cpp: what is left of a square, against sums over fine grids and exact integrals.
#include "tracer/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace litmus {
namespace {

ConvexSet random_triangle(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> random(-1, 1);
  ConvexSet set;
  const double u = random(engine), v = random(engine), turn = random(engine);
  for (int side = 0; side < 3; ++side) {
    const double angle = turn + side * 2.0943951;
    const double a = -std::cos(angle), b = -std::sin(angle);
    set.add({0.3 - a * u - b * v, a, b});
  }
  return set;
}

bool inside(const ConvexSet& set, const Corner& at) {
  return std::ranges::all_of(set.all(), [&](const HalfPlane& side) { return side.at(at) > 0; });
}

TEST(Polygon, IsClippedToTheHalfPlane) {
  Polygon part = Polygon::square();
  part.clip(HalfPlane{0.5, -1, 0});  // u < 1/2
  EXPECT_NEAR(part.area(), 3, 1e-15);
  EXPECT_NEAR(part.centroid().u, -0.25, 1e-15);
  EXPECT_NEAR(part.centroid().v, 0, 1e-15);
  Polygon all = part;
  all.clip(HalfPlane{3, 1, 1});
  EXPECT_EQ(all.area(), part.area());
  all.clip(HalfPlane{-3, 1, 1});
  EXPECT_TRUE(all.empty());
}

TEST(AddPolygon, GivesTheIntegralsOfLegendresPolynomials) {
  Polygon part = Polygon::square();
  part.clip(HalfPlane{0, -1, 1});  // v > u
  Moments moments{3};
  add_polygon(moments, part, 1);
  EXPECT_NEAR(moments.of[0][0], 1 / 2., 1e-15);
  EXPECT_NEAR(moments.of[1][0], -1 / 6., 1e-15);
  EXPECT_NEAR(moments.of[0][1], 1 / 6., 1e-15);
  EXPECT_NEAR(moments.of[1][1], 0, 1e-15);
  Moments whole{4};
  add_polygon(whole, Polygon::square(), 1);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) EXPECT_NEAR(whole.of[i][j], i + j == 0, 1e-15);
}

TEST(AddVisible, LeavesOutWhatAnyOfSeveralSetsHides) {
  std::mt19937_64 engine(7);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<ConvexSet> hidden;
    for (int k = 0; k < kMostHidden; ++k) hidden.push_back(random_triangle(engine));
    Moments moments{3};
    add_visible(moments, Polygon::square(), hidden);
    constexpr int kSide = 400;
    double share = 0, along_u = 0, along_both = 0;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const Corner at{(2 * i + 1.0) / kSide - 1, (2 * j + 1.0) / kSide - 1};
        if (std::ranges::any_of(hidden, [&](const ConvexSet& set) { return inside(set, at); }))
          continue;
        share += 1, along_u += at.u, along_both += at.u * (1.5 * at.v * at.v - 0.5);
      }
    }
    const double samples = kSide * kSide;
    EXPECT_NEAR(moments.share(), share / samples, 1e-3);
    EXPECT_NEAR(moments.of[1][0], along_u / samples, 1e-3);
    EXPECT_NEAR(moments.of[1][2], along_both / samples, 1e-3);
  }
}

TEST(NodeWeights, AreGausssOwnForTheWholeSquare) {
  for (int points = 1; points <= kMostPoints; ++points) {
    Moments moments{points};
    moments.of[0][0] = 1;
    const auto weights = node_weights(moments);
    const GaussRule& rule = short_rule(points);
    for (int a = 0; a < points; ++a)
      for (int b = 0; b < points; ++b)
        EXPECT_NEAR(weights[std::size_t(a * points + b)],
                    rule.weights[std::size_t(a)] * rule.weights[std::size_t(b)], 1e-15);
  }
}

TEST(NodeWeights, IntegratePolynomialsOverARegionExactly) {
  Polygon part = Polygon::square();
  part.clip(HalfPlane{0, -1, 1});  // v > u
  Moments moments{3};
  add_polygon(moments, part, 1);
  const auto weights = node_weights(moments);
  const GaussRule& rule = short_rule(3);
  double sum = 0;  // of u^2 v^2 + u
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      const double u = rule.nodes[a], v = rule.nodes[b];
      sum += weights[a * 3 + b] * (u * u * v * v + u);
    }
  }
  EXPECT_NEAR(sum, 1 / 18. - 1 / 6., 1e-15);  // by symmetry half of 4/9, and -2/3, over 4
}

}  // namespace
}  // namespace litmus

// silhouette_test.cpp: where no shadow ends, all rays agree.
#include "tracer/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace litmus {
namespace {

using V3 = Vec<double>;
using Triangles = std::vector<std::array<V3, 3>>;

/// A closed torus of m x k quads; `flip` winds every second triangle the other way.
Triangles torus(int m, int k, bool flip) {
  const auto at = [&](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % m) / m, b = 2 * std::numbers::pi * (j % k) / k;
    const double r = 1 + 0.4 * std::cos(b);
    return V3{r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)};
  };
  Triangles triangles;
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < k; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      if (flip) std::swap(triangles.back()[0], triangles.back()[1]);
    }
  }
  return triangles;
}

std::size_t count_ends(const EdgeTree& tree, const V3& apex, const Shaft& shaft) {
  std::vector<std::uint32_t> found;
  find_shadow_ends(tree, apex, shaft, found);
  return found.size();
}

int rays_blocked(const Triangles& triangles, const V3& apex, const Shaft& shaft, int rays) {
  int blocked = 0;
  for (int i = 0; i < rays; ++i) {
    for (int j = 0; j < rays; ++j) {
      const Ray<double> ray{apex, shaft.center + ((2 * i + 1.0) / rays - 1) * shaft.across +
                                      ((2 * j + 1.0) / rays - 1) * shaft.up};
      const ShearedRay<double> sheared(ray.direction);
      for (const auto& triangle : triangles) {
        const double t = intersect(triangle, ray, sheared).t;
        if (t > 0 && t < 1) {
          ++blocked;
          break;
        }
      }
    }
  }
  return blocked;
}

void check_torus(bool flip) {
  const Triangles triangles = torus(24, 12, flip);
  const EdgeTree tree = edge_tree(triangles);
  EXPECT_EQ(tree.edges.size(), triangles.size() * 3 / 2) << "every edge has two triangles";
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> random(-1, 1);
  int dark = 0, bright = 0, undecided = 0;
  for (int i = 0; i < 1500; ++i) {
    const V3 apex{2 * random(engine), 2 * random(engine), -2};
    const Shaft shaft = shaft_to(V3{random(engine), random(engine), 2} - apex,
                                 {0.1, 0.02 * random(engine), 0}, {0, 0.1, 0.03});
    constexpr int kRays = 5;
    if (count_ends(tree, apex, shaft) > 0) {
      ++undecided;
      continue;
    }
    const int blocked = rays_blocked(triangles, apex, shaft, kRays);
    EXPECT_TRUE(blocked == 0 || blocked == kRays * kRays) << blocked;
    ++(blocked ? dark : bright);
  }
  EXPECT_GT(dark, 100);
  EXPECT_GT(bright, 100);
  EXPECT_LT(undecided, 1000);
}

TEST(ShadowEnds, AreMissingOnlyWhereAllRaysAgree) { check_torus(false); }

TEST(ShadowEnds, DoNotDependOnHowTrianglesAreWound) { check_torus(true); }

TEST(ShadowEnds, AreAllContourEdgesThatMeetTheShaft) {
  std::mt19937_64 engine(4);
  std::uniform_real_distribution<double> random(-1, 1);
  std::size_t total = 0;
  for (const bool flip : {false, true}) {
    const EdgeTree tree = edge_tree(torus(24, 12, flip));
    for (int i = 0; i < 300; ++i) {
      const V3 apex{2 * random(engine), 2 * random(engine), -2 * random(engine) - 0.5};
      const Shaft shaft =
          shaft_to(V3{random(engine), random(engine), 2} - apex, {0.5, 0, 0}, {0, 0.6, 0.03});
      std::size_t expected = 0;
      for (const MeshEdge& edge : tree.edges) {
        const V3 a = edge.a - apex, b = edge.b - apex, plane = cross(a, b);
        const bool contour =
            dot(plane, edge.opposite[0] - apex) * dot(plane, edge.opposite[1] - apex) > 0;
        expected += contour && may_meet(shaft, a, b);
      }
      EXPECT_EQ(count_ends(tree, apex, shaft), expected);
      total += expected;
    }
  }
  EXPECT_GT(total, 500u) << "there were some";
}

TEST(ShadowEnds, AreTheBorderOfAnOpenSheet) {
  const EdgeTree tree = edge_tree(
      {{V3{-1, -1, 1}, V3{1, -1, 1}, V3{1, 1, 1}}, {V3{-1, -1, 1}, V3{1, 1, 1}, V3{-1, 1, 1}}});
  const auto over = [&](double x, double y) {
    return count_ends(tree, {}, shaft_to({x, y, 2}, {0.1, 0, 0}, {0, 0.1, 0}));
  };
  EXPECT_EQ(over(2, 0.3), 1u) << "over the border";
  EXPECT_EQ(over(2, 2), 2u) << "over a corner";
  EXPECT_EQ(over(0.3, 0.2), 0u) << "over the diagonal, which the triangles share";
  EXPECT_EQ(over(3, 0), 0u) << "beside it";
}

}  // namespace
}  // namespace litmus

// bvh_test.cpp: the tree finds what a plain loop finds.
#include "tracer/bvh.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace litmus {
namespace {

using Corners = std::array<Vec<double>, 3>;

std::vector<Corners> random_triangles(int count) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-5, 5), size(-0.5, 0.5);
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec<double> a{place(random), place(random), place(random)};
    triangles.push_back({a, a + Vec<double>{size(random), size(random), size(random)},
                         a + Vec<double>{size(random), size(random), size(random)}});
  }
  return triangles;
}

TEST(Bvh, HoldsEveryTriangleOnce) {
  const auto bvh = build_bvh(random_triangles(1000));
  std::vector<int> seen(1000);
  for (const std::uint32_t triangle : bvh.order) ++seen[triangle];
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 1000);
}

TEST(Bvh, FindsWhatAPlainLoopFinds) {
  const auto triangles = random_triangles(2000);
  const auto bvh = build_bvh(triangles);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    Ray<double> ray{{normal(random), normal(random), normal(random)},
                    {normal(random), normal(random), normal(random)}};
    const ShearedRay<double> sheared(ray.direction);
    double plain = ray.limit, tree = ray.limit;
    for (const Corners& corners : triangles) {
      const double t = intersect(corners, ray, sheared).t;
      if (t > 0 && t < plain) plain = t;
    }
    traverse(bvh, ray, [&](std::uint32_t index) {
      const double t = intersect(triangles[index], ray, sheared).t;
      if (t > 0 && t < tree) tree = ray.limit = t;
      return false;
    });
    ASSERT_EQ(tree, plain);
    hits += plain < std::numeric_limits<double>::infinity();
  }
  EXPECT_GT(hits, 50);
}

TEST(Bvh, HoldsEveryTriangleOnceInItsWideNodes) {
  const auto bvh = build_bvh(random_triangles(1000));
  std::vector<int> seen(1000);
  for (const WideNode<double>& node : bvh.wide) {
    for (int k = 0; k < WideNode<double>::kWidth; ++k) {
      for (std::uint32_t i = 0; i < node.count[k]; ++i) ++seen[bvh.order[node.first[k] + i]];
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 1000);
  EXPECT_LT(bvh.wide.size(), bvh.nodes.size() / 5);
}

TEST(Bvh, MeetsAFlatBoxSeenAlongAnAxis) {
  const std::vector<Corners> square{{Vec<double>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                    {Vec<double>{1, 1, 0}, {0, 1, 0}, {1, 0, 0}}};
  const auto bvh = build_bvh(square);
  Ray<double> ray{{1.0 / 3, 1.0 / 7, 1}, {0, 0, -1}};
  int visited = 0;
  traverse(bvh, ray, [&](std::uint32_t) { return ++visited, false; });
  EXPECT_GT(visited, 0);
}

TEST(Bvh, SplitsTrianglesThatShareOneCentre) {
  const std::vector<Corners> pile(100000, Corners{Vec<double>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(build_bvh(pile).order.size(), pile.size());
}

}  // namespace
}  // namespace litmus

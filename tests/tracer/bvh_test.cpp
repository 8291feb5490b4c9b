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

/// Triangle i belongs to object 2 i.
Bvh<double> tree_of(const std::vector<Corners>& triangles) {
  std::vector<int> objects(triangles.size());
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i] = int(2 * i);
  return build_bvh(triangles, objects);
}

/// How often each of `count` triangles is in a leaf, with its own corners and object.
std::vector<int> times_held(const std::vector<Corners>& triangles, const Bvh<double>& bvh) {
  std::vector<int> times(triangles.size());
  for (const WideNode<double>& node : bvh.nodes) {
    for (int k = 0; k < kWide; ++k) {
      for (std::uint32_t i = 0; i < node.children[k].count; ++i) {
        const TriangleBlock<double>& block = bvh.blocks[node.children[k].first + i / kWide];
        const std::uint32_t place = i % kWide, number = block.numbers[place];
        bool same = block.objects[place] == 2 * number;
        for (std::size_t c = 0; c < 3; ++c) {
          for (int axis = 0; axis < 3; ++axis)
            same &= block.corners[c][axis][place] == triangles[number][c][axis];
        }
        times[number] += same;
      }
    }
  }
  return times;
}

TEST(Bvh, HoldsEveryTriangleOnce) {
  const auto triangles = random_triangles(1000);
  const auto times = times_held(triangles, tree_of(triangles));
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), 1000);
}

TEST(Bvh, FillsHalfOfItsBlocksAndAThirdOfItsNodes) {
  const auto bvh = tree_of(random_triangles(1000));
  EXPECT_LT(bvh.blocks.size() * kWide, 1000 * 2);
  EXPECT_LT(bvh.nodes.size() * kWide, (bvh.blocks.size() + bvh.nodes.size()) * 3);
}

TEST(Bvh, FindsWhatAPlainLoopFinds) {
  const auto triangles = random_triangles(2000);
  const auto bvh = tree_of(triangles);
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
    traverse<double, Order::NearestFirst>(bvh, ray, [&](const auto& block, int count) {
      for (int k = 0; k < count; ++k) {
        const double t = BlockRay<double>(ray).crossing(block, k).t;
        if (t > 0 && t < tree) tree = ray.limit = t;
      }
      return false;
    });
    ASSERT_EQ(tree, plain);
    hits += plain < std::numeric_limits<double>::infinity();
  }
  EXPECT_GT(hits, 50);
}

TEST(Bvh, MeetsAFlatBoxSeenAlongAnAxis) {
  const std::vector<Corners> square{{Vec<double>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                    {Vec<double>{1, 1, 0}, {0, 1, 0}, {1, 0, 0}}};
  const auto bvh = tree_of(square);
  Ray<double> ray{{1.0 / 3, 1.0 / 7, 1}, {0, 0, -1}};
  int visited = 0;
  traverse<double, Order::Any>(bvh, ray, [&](const auto&, int) { return ++visited, false; });
  EXPECT_GT(visited, 0);
}

TEST(Bvh, SplitsTrianglesThatShareOneCentre) {
  const std::vector<Corners> pile(100000, Corners{Vec<double>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto times = times_held(pile, tree_of(pile));
  EXPECT_EQ(std::size_t(std::count(times.begin(), times.end(), 1)), pile.size());
}

}  // namespace
}  // namespace litmus

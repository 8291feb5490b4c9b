// area_grid_test.cpp: the grid of an area light against positions worked out by hand.
#include "exporters/area_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/refusal.h"

namespace litmus {
namespace {

AreaLight ceiling(int columns, int rows) {
  AreaLight light;
  light.point.origin = {0, 0, 3};
  light.normal = Vector(0, 0, -1);
  light.width = 1.2;
  light.height = 0.4;
  light.columns = columns;
  light.rows = rows;
  return light;
}

void expect_near(const Vector& a, const Vector& b, double tolerance = 1e-15) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(AreaGrid, OneSampleIsThePointItself) {
  AreaLight light = ceiling(1, 1);
  light.normal.reset();
  light.point.origin = {0.3, -0.7, 2.1};
  for (Placement placement : {Placement::Centres, Placement::Corners}) {
    light.placement = placement;
    ASSERT_EQ(area_samples(light).size(), 1u);
    EXPECT_EQ(area_samples(light)[0], light.point.origin);
  }
}

TEST(AreaGrid, CentresLieInTheMiddleOfTheirCells) {
  const auto samples = area_samples(ceiling(3, 2));
  ASSERT_EQ(samples.size(), 6u);
  // n = (0,0,-1): right = (1,0,0), up' = n x right = (0,-1,0).
  expect_near(samples[0], {-0.4, 0.1, 3});
  expect_near(samples[1], {0, 0.1, 3});
  expect_near(samples[2], {0.4, 0.1, 3});
  expect_near(samples[5], {0.4, -0.1, 3});
}

TEST(AreaGrid, CornersReachTheEdges) {
  AreaLight light = ceiling(3, 2);
  light.placement = Placement::Corners;
  const auto samples = area_samples(light);
  expect_near(samples[0], {-0.6, 0.2, 3});
  expect_near(samples[1], {0, 0.2, 3});
  expect_near(samples[5], {0.6, -0.2, 3});
}

TEST(AreaGrid, ASingleColumnOfCornersIsTheCentreLine) {
  AreaLight light = ceiling(1, 3);
  light.placement = Placement::Corners;
  for (const Point& sample : area_samples(light)) EXPECT_EQ(sample.x, 0);
}

TEST(AreaGrid, IsExactlyAntisymmetric) {
  for (Placement placement : {Placement::Centres, Placement::Corners}) {
    AreaLight light = ceiling(7, 5);
    light.point.origin = {0, 0, 0};  // so that no addition rounds
    light.normal = Vector(0.3, -0.5, 0.7);
    light.width = 1.1;
    light.height = 0.3;
    light.placement = placement;
    const auto samples = area_samples(light);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      EXPECT_EQ(samples[i], -samples[samples.size() - 1 - i]) << "sample " << i;
    }
  }
}

TEST(AreaGrid, TheFrameOfTheSlideIsOrthonormal) {
  AreaLight light = ceiling(1, 1);
  for (const Vector& n : {Vector(0.3, -0.5, 0.7), Vector(-2, 0, 0), Vector(0, 5, -1),
                          Vector(1e-200, 0, 1), Vector(1e-9, -1e-9, -1)}) {
    light.normal = n;
    const GridAxes frame = grid_axes(light);
    EXPECT_NEAR(glm::length(frame.right), 1, 1e-15);
    EXPECT_NEAR(glm::length(frame.up), 1, 1e-15);
    EXPECT_NEAR(glm::dot(frame.right, frame.normal), 0, 1e-15);
    EXPECT_EQ(frame.right.z, 0) << "right = up x n is horizontal";
    expect_near(glm::cross(frame.right, frame.up), frame.normal);
  }
}

TEST(AreaGrid, RightIsUpCrossNormal) {
  AreaLight light = ceiling(1, 1);
  light.normal = Vector(1, 0, 0);  // (0,0,1) x (1,0,0) = (0,1,0)
  expect_near(grid_axes(light).right, {0, 1, 0});
  expect_near(grid_axes(light).up, {0, 0, 1});
}

TEST(AreaGrid, AtThePolesRightIsX) {
  AreaLight light = ceiling(1, 1);
  for (double z : {1.0, -1.0, 7.5, -1e-300}) {
    light.normal = Vector(0, 0, z);
    EXPECT_EQ(grid_axes(light).right, Vector(1, 0, 0));
    EXPECT_EQ(grid_axes(light).up, Vector(0, z > 0 ? 1 : -1, 0));
  }
}

TEST(AreaGrid, AMissingNormalPointsToTheOrigin) {
  AreaLight light = ceiling(2, 2);
  light.normal.reset();
  light.point.origin = {3, 0, 4};
  expect_near(grid_axes(light).normal, {-0.6, 0, -0.8});
}

TEST(AreaGrid, AGivenRightIsMadeOrthogonal) {
  AreaLight light = ceiling(1, 1);
  light.right = Vector(0, 4, 9);
  EXPECT_EQ(grid_axes(light).right, Vector(0, 1, 0));
  expect_near(grid_axes(light).up, {1, 0, 0});  // (0,0,-1) x (0,1,0)
}

TEST(AreaGrid, RefusesWhatHasNoFrame) {
  AreaLight at_origin = ceiling(2, 2);
  at_origin.normal.reset();
  at_origin.point.origin = {0, 0, 0};
  EXPECT_THROW(area_samples(at_origin), Refusal);
  AreaLight along_normal = ceiling(2, 2);
  along_normal.right = Vector(0, 0, 3);
  EXPECT_THROW(area_samples(along_normal), Refusal);
  AreaLight nothing = ceiling(0, 2);
  EXPECT_THROW(area_samples(nothing), Refusal);
}

}  // namespace
}  // namespace litmus

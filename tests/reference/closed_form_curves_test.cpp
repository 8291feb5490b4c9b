// closed_form_curves_test.cpp: each explicit curve against the inequality of the solid that casts
// it.
#include "reference/closed_form_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/closed_form_shadow.h"
#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

constexpr int kSide = 200;       // points per side of the floor
constexpr Exact kHalfWidth = 3;  // of the floor, from -3 to 3

/// Calls visit(point) over the floor; the offset keeps points off symmetric places.
template <class Visit>
void over_the_floor(Visit visit) {
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j)
      visit(FloorPoint((2 * i + 1.013L - kSide) / kSide * kHalfWidth,
                       (2 * j + 0.971L - kSide) / kSide * kHalfWidth));
}

/// Whether curve and implicit inequality agree everywhere outside the band; both sides must occur.
template <class Depth>
void expect_same_shadow(const Object& caster, const ExactLamp& lamp, Depth depth_at) {
  int inside = 0, outside = 0;
  over_the_floor([&](const FloorPoint& p) {
    const Exact d = depth_at(p);
    const Way way = passage_by(caster, {ExactVec(p.x, p.y, 0), lamp.place, lamp.sun});
    if (way == Way::Unsure || std::fabs(d) < kBoundaryBand) return;
    ASSERT_EQ(d > 0, way == Way::Blocked) << double(p.x) << ", " << double(p.y);
    ++(d > 0 ? inside : outside);
  });
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
}

ExactLamp sun(const ExactVec& toward) { return {true, glm::normalize(toward)}; }
ExactLamp lamp(const ExactVec& place) { return {false, place}; }

TEST(SunShadow, IsTheCylinderOfTheSphere) {
  const Sphere ball{{0.3, 0.1, 1.7}, 0.6};
  const ExactLamp light = sun({0.6, 0.35, 1});
  const Conic ellipse = sun_shadow(ball, light.place, 0);
  expect_same_shadow({"ball", ball, 0}, light, [&](auto& p) { return depth(ellipse, p); });
}

TEST(LampShadow, IsTheConeOfTangents) {
  const Sphere ball{{0.5, 0.4, 1.2}, 0.5};
  const Conic ellipse = lamp_shadow(ball, {-0.7, -0.3, 4}, 0);
  EXPECT_FALSE(ellipse.hyperbola);
  expect_same_shadow({"ball", ball, 0}, lamp({-0.7, -0.3, 4}),
                     [&](auto& p) { return depth(ellipse, p); });
}

TEST(LampShadow, HasTheAxesOfTheWorkedExample) {
  const Conic ellipse = lamp_shadow({{0.5, 0.4, 1.2}, 0.5}, {-0.7, -0.3, 4}, 0);
  EXPECT_NEAR(double(ellipse.a), 0.813030, 1e-6);
  EXPECT_NEAR(double(ellipse.b), 0.725954, 1e-6);
  EXPECT_NEAR(double(ellipse.centre.x), 1.070751, 1e-6);
  EXPECT_NEAR(double(ellipse.centre.y), 0.732938, 1e-6);
  // It is not the projected centre of the sphere.
  EXPECT_GT(std::fabs(double(ellipse.centre.x) - 1.0143), 0.05);
}

/// Where y = 0 leaves the conic, from its middle outwards.
double edge_on_the_axis(const Conic& conic, double outwards) {
  Exact in = 0, out = outwards;
  for (int i = 0; i < 80; ++i) (depth(conic, {(in + out) / 2, 0}) > 0 ? in : out) = (in + out) / 2;
  return double(in);
}

TEST(LampShadow, OfTheCornersOfAPanelBoundUmbraAndPenumbra) {
  // A panel of 0.5 x 0.5 at height 4 over a sphere of radius 0.4 at 1.5: along y = 0.
  const Sphere ball{{0, 0, 1.5}, 0.4};
  double umbra = 9, penumbra = 0;
  for (const double x : {-0.25, 0.25})
    for (const double y : {-0.25, 0.25}) {
      const double edge = edge_on_the_axis(lamp_shadow(ball, {x, y, 4}, 0), 3);
      umbra = std::min(umbra, edge), penumbra = std::max(penumbra, edge);
    }
  EXPECT_NEAR(umbra, 0.472684, 1e-6);
  EXPECT_NEAR(penumbra, 0.790441, 1e-6);
}

TEST(LampShadow, OfALowLampIsABranchOfAHyperbola) {
  const Sphere ball{{0.2, 0.1, 0.9}, 0.5};
  const ExactVec low(-1.6, -0.7, 1.1);
  const Conic hyperbola = lamp_shadow(ball, low, 0);
  EXPECT_TRUE(hyperbola.hyperbola);
  expect_same_shadow({"ball", ball, 0}, lamp(low), [&](auto& p) { return depth(hyperbola, p); });
}

TEST(LampShadow, OfASphereBehindTheLampIsNone) {
  EXPECT_TRUE(lamp_shadow({{0.1, 0, 3}, 0.5}, {0, 0, 1.5}, 0).none);
}

TEST(LampShadow, FollowsTheFloorsHeight) {
  const Conic low = lamp_shadow({{0.5, 0.4, 1.2}, 0.5}, {-0.7, -0.3, 4}, 0),
              high = lamp_shadow({{0.5, 0.4, 6.2}, 0.5}, {-0.7, -0.3, 9}, 5);
  EXPECT_NEAR(double(low.a), double(high.a), 1e-15);
  EXPECT_NEAR(double(low.centre.x), double(high.centre.x), 1e-15);
}

TEST(ConeOnFloor, IsWhereTheAngleOffTheAxisIsTheCutoff) {
  for (const double cutoff : {0.2, 0.4, 1.2}) {
    const ExactLamp lamp =
        exact_lamps(light_of(SpotLight{{{-0.9, -0.5, 2.5}, {}}, {0.5, 0.3, -1}, cutoff, 1}))
            .front();
    const Conic conic = cone_on_floor(lamp.place, lamp.cone->axis, cutoff, 0);
    EXPECT_EQ(conic.hyperbola, cutoff == 1.2);
    over_the_floor([&](const FloorPoint& p) {
      const Exact alpha = angle_off_axis(lamp, {p.x, p.y, 0}), d = depth(conic, p);
      if (std::fabs(alpha - cutoff) > 1e-9) {
        ASSERT_EQ(d > 0, alpha < cutoff) << double(p.x) << ", " << double(p.y);
      }
    });
  }
}

TEST(ConeOnFloor, OfAnUpwardConeIsNone) {
  EXPECT_TRUE(cone_on_floor({0, 0, 1}, {0, 0, 1}, 0.5L, 0).none);
}

TEST(CornerShadow, OfABoxIsTheHullOfItsCorners) {
  const Object block{"block", Box{{-0.7, -0.4, 0.3}, {0.5, 0.6, 1.1}}, 0};
  for (const ExactLamp& light : {lamp({0.8, -0.9, 3}), sun({0.4, -0.3, 1})}) {
    const auto polygon = corner_shadow(block, light, 0);
    EXPECT_GE(polygon.size(), 4u);
    expect_same_shadow(block, light, [&](auto& p) { return depth(polygon, p); });
  }
}

TEST(CornerShadow, OfATriangleHasThreeCorners) {
  const Object blind{"blind", Triangle{{0.01, -0.8, 1.5}, {0.01, 0.8, 1.2}, {-1, 0, 1}}, 0};
  const ExactLamp light = lamp({0.3, 0.2, 3});
  const auto polygon = corner_shadow(blind, light, 0);
  EXPECT_EQ(polygon.size(), 3u);
  expect_same_shadow(blind, light, [&](auto& p) { return depth(polygon, p); });
}

TEST(CornerShadow, OfAStraightEdgeIsAtMinusXhOverHMinusH) {
  const Exact H = 3, h = 1.5, X = 0.4;  // the lamp at (X, H), the edge at (0, h)
  const auto polygon = corner_shadow(
      {"blind", Triangle{{0, -8, double(h)}, {0, 8, double(h)}, {-10, 0, double(h)}}, 0},
      lamp({X, 0, H}), 0);
  const Exact edge = -X * h / (H - h);
  EXPECT_GT(double(depth(polygon, {edge - 1e-9L, 0})), 0);
  EXPECT_LT(double(depth(polygon, {edge + 1e-9L, 0})), 0);
}

TEST(CornerShadow, OfAHoleIsScaledByHOverHMinusH) {
  // Four strips around the hole [-0.2, 0.3] x [-0.1, 0.4] at h = 1 leave its patch open.
  const ExactLamp light = lamp({0.1, 0.05, 2.5});
  const Exact scale = 2.5L / 1.5L;
  const std::array strips{
      Box{{-9, -9, 1}, {-0.2, 9, 1.0000001}}, Box{{0.3, -9, 1}, {9, 9, 1.0000001}},
      Box{{-9, -9, 1}, {9, -0.1, 1.0000001}}, Box{{-9, 0.4, 1}, {9, 9, 1.0000001}}};
  int open = 0;
  over_the_floor([&](const FloorPoint& p) {
    const Exact x = 0.1L + (p.x - 0.1L) / scale, y = 0.05L + (p.y - 0.05L) / scale;
    const Exact inside = std::min({x + 0.2L, 0.3L - x, y + 0.1L, 0.4L - y});
    if (std::fabs(inside) < 1e-6) return;
    Exact deepest = -1;
    for (const Box& strip : strips)
      deepest = std::max(deepest, depth(corner_shadow({"strip", strip, 0}, light, 0), p));
    ASSERT_EQ(deepest<0, inside> 0) << double(p.x) << ", " << double(p.y);
    open += inside > 0;
  });
  EXPECT_GT(open, 100);
}

TEST(CornerShadow, RefusesWhatRisesAboveTheLamp) {
  const Object tall{"tall", Box{{0, 0, 0}, {1, 1, 4}}, 0};
  EXPECT_THROW(corner_shadow(tall, lamp({0, 0, 3}), 0), Refusal);
  EXPECT_THROW(corner_shadow({"ball", Sphere{}, 0}, lamp({0, 0, 3}), 0), Refusal);
}

}  // namespace
}  // namespace litmus

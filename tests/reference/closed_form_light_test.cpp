// closed_form_light_test.cpp: the slides' forms against other ways to the same numbers.
#include "reference/closed_form_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "exporters/area_grid.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

AreaLight panel(int columns, int rows, Placement placement) {
  AreaLight area;
  area.point.origin = {0.3, -1.2, 2.5};
  area.width = 1.3, area.height = 0.7;
  area.columns = columns, area.rows = rows, area.placement = placement;
  return area;
}

TEST(ExactLamps, OfAnAreaLightLieWhereTheExportersPutThem) {
  for (const Placement placement : {Placement::Centres, Placement::Corners})
    for (int variant = 0; variant < 4; ++variant) {
      AreaLight area = panel(variant == 3 ? 1 : 4, 3, placement);
      if (variant == 1) area.normal = Vector(0, 0, -2);
      if (variant == 2) area.normal = Vector(1, 2, -3), area.right = Vector(1, 0, 0.3);
      const std::vector<ExactLamp> lamps = exact_lamps(light_of(area));
      const std::vector<Point> expected = area_samples(area);
      ASSERT_EQ(lamps.size(), expected.size());
      Exact shares = 0;
      for (std::size_t i = 0; i < lamps.size(); ++i) {
        EXPECT_LE(double(glm::distance(lamps[i].place, ExactVec(expected[i]))), 1e-15);
        shares += lamps[i].share;
      }
      EXPECT_NEAR(double(shares), 1, 1e-18);
    }
}

TEST(ExactLamps, OfTheSunPointTowardsIt) {
  const ExactLamp sun = exact_lamps(light_of(DirectionalLight{{0, 3, -4}})).front();
  EXPECT_TRUE(sun.sun);
  EXPECT_NEAR(double(glm::distance(sun.place, ExactVec(0, -0.6L, 0.8L))), 0, 1e-18);
}

TEST(Arriving, IsTheProductOfTwoHalvesAtTheRange) {
  const ExactLamp lamp{false, {0, 0, 0}, {2, 1, 1}};
  EXPECT_EQ(double(arriving(lamp, {0, 0, 2})), 0.25);
  EXPECT_EQ(double(arriving({false, {0, 0, 0}, {2, 0, 0}}, {0, 0, 2})), 1.0);
}

TEST(Arriving, SolvesTheDifferentialEquationsOfItsFactors) {
  // l' = -(L/R) l^2 and q' = -(2 Q d / R^2) q^2, by central differences.
  const Exact R = 2, h = 1e-6L;
  for (const Exact d : {0.3L, 1.7L, 6.0L}) {
    const auto at = [&](Attenuation a, Exact x) {
      return arriving({false, {0, 0, 0}, a}, {x, 0, 0});
    };
    const auto slope = [&](Attenuation a) { return (at(a, d + h) - at(a, d - h)) / (2 * h); };
    const Attenuation linear{2, 0.7, 0}, quadratic{2, 0, 0.4};
    const Exact l = at(linear, d), q = at(quadratic, d);
    EXPECT_NEAR(double(slope(linear)), double(-Exact(0.7) / R * l * l), 1e-10);
    EXPECT_NEAR(double(slope(quadratic)), double(-2 * Exact(0.4) * d / (R * R) * q * q), 1e-10);
  }
}

TEST(Arriving, NeitherOverflowsNorVanishesAtExtremeRanges) {
  for (const double range : {1e-25, 1e20, 1e30, 1e300}) {
    const Exact arrives = arriving({false, {0, 0, 0}, {range, 1, 1}}, {0, 0, 2});
    EXPECT_GE(arrives, 0);
    EXPECT_LE(arrives, 1);
    if (range > 1) {
      EXPECT_EQ(double(arrives), 1);
    }
  }
}

TEST(AngleOffAxis, IsThatOfTheLawOfCosines) {
  const SpotLight spot{{{1, 2, 3}, {}}, {0.5, 0.3, -1}, 1, 1};
  for (const ExactVec p : {ExactVec(0, 0, 0), ExactVec(4, -2, 1), ExactVec(1, 2.5L, 9)}) {
    const ExactVec apex(spot.point.origin), on_axis = apex + ExactVec(spot.direction);
    const Exact a = glm::distance(apex, p), b = glm::distance(apex, on_axis),
                c = glm::distance(p, on_axis);
    EXPECT_NEAR(double(angle_off_axis(exact_lamps(light_of(spot)).front(), p)),
                double(std::acos((a * a + b * b - c * c) / (2 * a * b))), 1e-15);
  }
}

TEST(AngleOffAxis, KeepsItsDigitsNearTheAxis) {
  const ExactLamp lamp =
      exact_lamps(light_of(SpotLight{{{0, 0, 1}, {}}, {0, 0, -1}, 1, 1})).front();
  for (const double x : {1e-3, 1e-8, 1e-15})
    EXPECT_NEAR(double(angle_off_axis(lamp, {x, 0, 0})) / std::atan(x), 1, 1e-15);
}

TEST(Arriving, DecaysToHalfAtTheAngleOfSlideSixteen) {
  for (const double exponent : {0.25, 1.0, 3.0, 30.0}) {
    const SpotLight spot{{{0, 0, 1}, {}}, {0, 0, -1}, 0.4, exponent};
    const Exact half = 0.4L * std::pow(2.0L, -1 / Exact(exponent));
    const ExactLamp lamp = exact_lamps(light_of(spot)).front();
    EXPECT_NEAR(double(arriving(lamp, {std::tan(half), 0, 0})), 0.5, 1e-14);
    EXPECT_EQ(double(arriving(lamp, {std::tan(0.401L), 0, 0})), 0);
  }
}

}  // namespace
}  // namespace litmus

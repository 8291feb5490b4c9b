// lights_test.cpp: slides 8-20 against closed forms and quad precision.
#include "tracer/lights.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace litmus {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Attenuation, HasTheSlidesCurvesAtTheRange) {
  EXPECT_DOUBLE_EQ(linear_attenuation(1.0, 1.0), 1.0 / 2);     // slide 12, curve a
  EXPECT_DOUBLE_EQ(quadratic_attenuation(1.0, 1.0), 1.0 / 2);  // curve b
  EXPECT_DOUBLE_EQ(linear_attenuation(1.0, 0.5) * quadratic_attenuation(1.0, 0.5),
                   4.0 / 9);  // curve c
}

TEST(Attenuation, IsExactlyOneWithoutCoefficientsEvenAtInfinity) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, 1e-300, 0.1, 1e300, infinity}) {
    EXPECT_EQ(linear_attenuation(x, 0.0), 1.0);
    EXPECT_EQ(quadratic_attenuation(x, 0.0), 1.0);
  }
}

TEST(Attenuation, EqualsTheSlidesFractions) {
  const double range = 2.5, distance = 1.7, linear = 0.3, quadratic = 0.9, x = distance / range;
  EXPECT_NEAR(linear_attenuation(x, linear), range / (range + linear * distance), 1e-15);
  EXPECT_NEAR(quadratic_attenuation(x, quadratic),
              range * range / (range * range + quadratic * distance * distance), 1e-15);
}

TEST(QuadraticAttenuation, StaysFiniteWhereTheSlidesFormDoesNot) {
  const float range = 1e20f, distance = 1e20f;
  EXPECT_TRUE(std::isnan(range * range / (range * range + distance * distance)));  // the control
  EXPECT_FLOAT_EQ(quadratic_attenuation(distance / range, 1.0f), 0.5f);
}

TEST(AngleBetween, IsZeroOnTheAxisForEveryDirection) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  int arccosine_fails = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec<double> axis = normalize(Vec<double>{normal(random), normal(random), normal(random)});
    ASSERT_EQ(angle_between(axis, axis), 0.0);
    arccosine_fails += !(std::acos(dot(axis, axis)) == 0.0);
  }
  EXPECT_GT(arccosine_fails, 1000);  // the control: acos is NaN or not zero there
}

TEST(AngleBetween, KeepsTinyAngles) {
  const Vec<double> axis{0, 0, -1};
  for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12}) {
    EXPECT_NEAR(angle_between(axis, Vec<double>{std::sin(angle), 0, -std::cos(angle)}) / angle, 1,
                1e-15);
  }
}

TEST(SpotDecay, IsTheSlidesFormula) {
  for (const double exponent : {0.25, 1.0, 3.0, 30.0}) {
    for (const double ratio : {0.1, 0.5, 0.9}) {
      EXPECT_NEAR(spot_decay(ratio * 0.4, 0.4, exponent), 1 - std::pow(ratio, exponent), 4e-16);
    }
  }
}

TEST(SpotDecay, IsOneOnTheAxisAndZeroAtTheCutoff) {
  EXPECT_EQ(spot_decay(0.0, 0.4, 3.0), 1.0);
  EXPECT_EQ(spot_decay(0.4, 0.4, 3.0), 0.0);
}

TEST(SpotDecay, IsZeroPastTheCutoff) {
  EXPECT_EQ(spot_decay(std::nextafter(0.4, 1.0), 0.4, 3.0), 0.0);
}

TEST(SpotDecay, OfExponentZeroIsZeroEverywhere) {
  EXPECT_EQ(spot_decay(0.0, 0.4, 0.0), 0.0);
  EXPECT_EQ(spot_decay(0.2, 0.4, 0.0), 0.0);
}

TEST(SpotDecay, KeepsItsDigitsJustInsideTheCutoff) {
  const double cutoff = 0.4, alpha = std::nextafter(cutoff, 0.0), exponent = 1e-6;
  EXPECT_EQ(1 - std::pow(alpha / cutoff, exponent),
            0.0);  // the control: the slide's form has lost all
  const Quad exact = -expm1(Quad(exponent) * log(Quad(alpha) / Quad(cutoff)));
  EXPECT_NEAR(spot_decay(alpha, cutoff, exponent) / double(exact), 1, 1e-15);
}

TEST(SpotDecay, StaysFiniteForAHugeExponent) { EXPECT_EQ(spot_decay(0.3, 0.4, 1e30), 1.0); }

AreaLight area(const Vector& normal) {
  AreaLight light;
  light.normal = normal;
  light.width = 2, light.height = 0.3, light.columns = 7, light.rows = 2;
  return light;
}

TEST(AreaFrame, IsOrthonormalForEveryNormal) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    const auto f = area_frame<double>(area({normal(random), normal(random), normal(random)}));
    ASSERT_NEAR(dot(f.right, f.right), 1, 1e-15);
    ASSERT_NEAR(dot(f.up, f.up), 1, 1e-15);
    ASSERT_NEAR(dot(f.right, f.up), 0, 1e-15);
    ASSERT_NEAR(dot(f.right, f.normal), 0, 1e-15);
  }
}

TEST(AreaFrame, OfAVerticalNormalTakesXAsRight) {
  const auto down = area_frame<double>(area({0, 0, -3}));
  EXPECT_EQ(down.right, (Vec<double>{1, 0, 0}));
  EXPECT_EQ(down.up, (Vec<double>{0, -1, 0}));
}

TEST(AreaFrame, NeedsNoEpsilonNearThePole) {
  const auto f = area_frame<double>(area({1e-300, 0, 1}));
  EXPECT_EQ(f.right, (Vec<double>{0, 1, 0}));
}

TEST(AreaFrame, WithoutANormalLooksAtTheOrigin) {
  AreaLight light;
  light.point.origin = {0, -4, 3};
  const auto f = area_frame<double>(light);
  EXPECT_NEAR(f.normal.y, 0.8, 1e-15);
  EXPECT_NEAR(f.normal.z, -0.6, 1e-15);
}

TEST(AreaFrame, MakesAGivenRightPerpendicularToTheNormal) {
  AreaLight light = area({0, 0, 1});
  light.right = Vector{0, 2, 5};
  EXPECT_EQ(area_frame<double>(light).right, (Vec<double>{0, 1, 0}));
}

TEST(AreaSamples, LieAtTheCentresOfTheirCells) {
  const auto samples = area_samples<double>(area({0, 0, 1}));
  ASSERT_EQ(samples.size(), 14u);
  EXPECT_DOUBLE_EQ(samples[0].x, -6.0 / 7);
  EXPECT_DOUBLE_EQ(samples[1].x - samples[0].x, 2.0 / 7);
  EXPECT_DOUBLE_EQ(samples[0].y, -0.075);
  EXPECT_DOUBLE_EQ(samples[7].y, 0.075);
}

TEST(AreaSamples, AtTheCornersReachTheRectanglesBorder) {
  AreaLight light = area({0, 0, 1});
  light.placement = Placement::Corners;
  const auto samples = area_samples<double>(light);
  EXPECT_EQ(samples.front().x, -1.0);
  EXPECT_EQ(samples.back().x, 1.0);
  EXPECT_EQ(samples.back().y, 0.15);
}

TEST(AreaSamples, AreExactlyAntisymmetric) {
  for (const int n : {2, 3, 7, 64, 4096}) {
    for (int i = 0; i < n; ++i) {
      for (const Placement placement : {Placement::Centres, Placement::Corners}) {
        ASSERT_EQ(grid_position<float>(i, n, placement),
                  -grid_position<float>(n - 1 - i, n, placement));
      }
    }
  }
}

TEST(AreaSamples, OfOneByOneAreTheCentre) {
  EXPECT_EQ(grid_position<double>(0, 1, Placement::Centres), 0.0);
  EXPECT_EQ(grid_position<double>(0, 1, Placement::Corners), 0.0);
}

TEST(Incident, OfTheSunIsTheSameEverywhere) {
  Lamp<double> sun;
  sun.directional = true;
  sun.toward = {0, 0, 1};
  const auto light = incident(sun, Vec<double>{1e9, -3, 5});
  EXPECT_EQ(light.intensity, 1.0);
  EXPECT_EQ(light.direction, sun.toward);
}

TEST(Incident, OfASpotIsZeroOutsideTheCone) {
  Lamp<double> spot;
  spot.cone = true;
  spot.origin = {0, 0, 2}, spot.axis = {0, 0, -1};
  spot.cutoff = kPi / 4, spot.exponent = 1;
  EXPECT_EQ(incident(spot, Vec<double>{2.01, 0, 0}).intensity, 0.0);
  EXPECT_FALSE(incident(spot, Vec<double>{2.01, 0, 0}).in_cone);
  const double alpha = std::atan2(1.0, 2.0);
  EXPECT_NEAR(incident(spot, Vec<double>{1, 0, 0}).intensity, 1 - alpha / (kPi / 4), 1e-15);
}

TEST(Incident, AtTheLightItselfIsFinite) {
  Lamp<double> lamp;
  lamp.attenuated = lamp.cone = true;
  lamp.quadratic = 1, lamp.axis = {0, 0, -1}, lamp.cutoff = 1, lamp.exponent = 2;
  const auto light = incident(lamp, Vec<double>{});
  EXPECT_EQ(light.direction, (Vec<double>{}));
  EXPECT_TRUE(std::isfinite(light.intensity));
}

}  // namespace
}  // namespace litmus

// blender_fit_test.cpp: least squares against cases that have an answer.
#include "exporters/blender_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace litmus {
namespace {

constexpr double kCutoff = 28 * std::numbers::pi / 180;

Light point_light(double range, double linear, double quadratic) {
  return {.name = "lamp", .shape = PointLight{{0, 0, 3}, {range, linear, quadratic}}};
}

const std::vector<Point> kPoints = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {-1, 4, 0.5}, {0, 0, 2}};

TEST(BlenderFit, InverseSquareIsTheLimitOfQuadraticAttenuation) {
  // R^2 / (R^2 + Q d^2) -> (R^2 / Q) / d^2
  const LampFit fit = fit_distance(point_light(2, 0, 1e8), kPoints);
  EXPECT_NEAR(fit.gain, 4e-8, 4e-14);
  EXPECT_LT(fit.rms, 4e-14);
}

TEST(BlenderFit, OnePointIsFittedExactly) {
  const LampFit fit = fit_distance(point_light(1, 1, 0), {{0, 0, 0}});  // l = 1/4 at d = 3
  EXPECT_DOUBLE_EQ(fit.gain, 9.0 / 4);
  EXPECT_NEAR(fit.rms, 0, 1e-16);
}

TEST(BlenderFit, AConstantLightLeavesAnError) {
  EXPECT_GT(fit_distance(point_light(1, 0, 0), kPoints).rms, 0.3);
}

TEST(BlenderFit, NothingToFitLeavesTheGainAtOne) {
  EXPECT_EQ(fit_distance(point_light(1, 0, 0), {}).gain, 1);
  EXPECT_EQ(fit_distance(point_light(1, 0, 0), {{0, 0, 3}}).gain, 1) << "a point in the lamp";
}

TEST(BlenderFit, AnAreaLampDimsWithTheCosineOfEmission) {
  AreaLight panel;
  panel.point = {{0, 0, 2}, {1, 0, 0}};
  panel.normal = Vector(0, 0, -1);
  panel.width = panel.height = 0;
  const Light light{.name = "panel", .shape = panel};
  // At (2, 0, 0): d^2 = 8, cosine = 1 / sqrt(2), wanted 1.
  EXPECT_NEAR(fit_distance(light, {{2, 0, 0}}).gain, 8 * std::sqrt(2.0), 1e-12);
}

TEST(BlenderSpot, IsOneOnTheAxisAndZeroAtTheCutoff) {
  for (const double blend : {0.0, 0.3, 1.0}) {
    EXPECT_EQ(blender_spot(0, kCutoff, blend), 1);
    EXPECT_EQ(blender_spot(kCutoff, kCutoff, blend), 0);
  }
  EXPECT_DOUBLE_EQ(blender_spot(0.4, kCutoff, 0), std::cos(0.4));
}

TEST(BlenderSpot, ASharperExponentNeedsLessBlend) {
  // Found by rendering a cutoff of 28 degrees: 1.00, 0.68, 0.27, 0.10.
  EXPECT_NEAR(fit_spot(kCutoff, 1).blend, 1.00, 0.02);
  EXPECT_NEAR(fit_spot(kCutoff, 3).blend, 0.68, 0.02);
  EXPECT_NEAR(fit_spot(kCutoff, 10).blend, 0.27, 0.02);
  EXPECT_NEAR(fit_spot(kCutoff, 30).blend, 0.10, 0.02);
}

TEST(BlenderSpot, IsNeverTheModelsCone) {
  for (const double exponent : {1.0, 3.0, 10.0, 30.0}) {
    EXPECT_GT(fit_spot(kCutoff, exponent).rms, 0.045);
    EXPECT_LT(fit_spot(kCutoff, exponent).rms, 0.075);
  }
}

}  // namespace
}  // namespace litmus

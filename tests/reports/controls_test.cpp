// controls_test.cpp: each known mistake is the mistake that its name says.
#include "reports/controls.h"

#include <gtest/gtest.h>

#include <numbers>

namespace litmus {
namespace {

struct Mistaken {
  Scene scene;
  RenderOptions options;
};

Mistaken with(std::string_view name) {
  Mistaken result;
  result.scene.materials = {{"m", Color(1), Color(1), Color(1), 100}};
  Light spot;
  spot.shape = SpotLight{{{1, 2, 3}, {4, 0.5, 0.25}}, {0, 0, -1}, 0.3, 2};
  Light area;
  area.shape = AreaLight{};
  Light sun;
  sun.shape = DirectionalLight{};
  result.scene.lights = {spot, area, sun};
  find_control(name)->apply(result.scene, result.options);
  return result;
}

const SpotLight& spot_of(const Mistaken& result) {
  return std::get<SpotLight>(result.scene.lights[0].shape);
}

TEST(Control, OfShininessRaisesItByThreePercent) {
  EXPECT_DOUBLE_EQ(with("shininess").scene.materials[0].shininess, 103);
}

TEST(Control, OfIntensityRaisesEveryLightByOnePercent) {
  for (const Light& light : with("intensity").scene.lights) EXPECT_DOUBLE_EQ(light.intensity, 1.01);
}

TEST(Control, OfAttenuationSwapsLinearAndQuadratic) {
  EXPECT_EQ(spot_of(with("attenuation")).point.attenuation.linear, 0.25);
  EXPECT_EQ(spot_of(with("attenuation")).point.attenuation.quadratic, 0.5);
}

TEST(Control, OfTheCutoffWidensTheConeByHalfADegree) {
  EXPECT_DOUBLE_EQ(spot_of(with("cutoff")).cutoff, 0.3 + std::numbers::pi / 360);
}

TEST(Control, OfPlacementTakesCornersForCentres) {
  EXPECT_EQ(std::get<AreaLight>(with("placement").scene.lights[1].shape).placement,
            Placement::Corners);
}

TEST(Control, OfHalfAPixelShiftsTheSamplePoints) {
  EXPECT_EQ(with("half-pixel").options.shift_x, 0.5);
}

TEST(Control, OfAMovedLightMovesThoseThatHaveAPlace) {
  EXPECT_DOUBLE_EQ(spot_of(with("light-moved")).point.origin.x, 1.01);
  EXPECT_DOUBLE_EQ(std::get<AreaLight>(with("light-moved").scene.lights[1].shape).point.origin.x,
                   0.01);
}

TEST(Control, ThatDoesNotExistIsNotFound) { EXPECT_EQ(find_control("cut-off"), nullptr); }

}  // namespace
}  // namespace litmus

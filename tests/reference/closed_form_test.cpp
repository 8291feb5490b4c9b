// closed_form_test.cpp: whole pictures, claims and refusals of the closed forms.
#include "reference/closed_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "reference/closed_form_view.h"
#include "scene/observer.h"
#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

/// A matte floor from above, 41 x 41 pixels over a square of side 4.1: one is exactly at 0.
Scene small_floor() {
  Scene scene;
  scene.name = "test";
  scene.width = scene.height = 41;
  scene.camera.projection = Projection::Orthographic;
  scene.camera.eye = {0, 0, 10}, scene.camera.up = {0, 1, 0}, scene.camera.height = 4.1;
  scene.materials = {{"matte", Color(1), Color(1), Color(0), 1}};
  scene.objects = {{"floor", Plane{}, 0}};
  scene.expect = {Oracle::Floor};
  return scene;
}

std::string refusal_of(const Scene& scene) {
  try {
    closed_form(scene);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return {};
}

TEST(FloorOracle, IsTheProfileOfSlideElevenInCircles) {
  Scene scene = small_floor();
  scene.lights = {light_of(PointLight{{0, 0, 1.25}, {2, 1, 1}})};
  const ClosedForm known = closed_form(scene);
  ASSERT_EQ(known.layers.size(), 2u);
  for (int x = 0; x < 41; ++x) {
    const double rho = std::fabs(x - 20) * 0.1, d = std::hypot(rho, 1.25);
    const double expected = 1.25 / d * 2 / (2 + d) * 4 / (4 + d * d);
    EXPECT_NEAR(known.layers[1].picture.at(x, 20).x, expected, 1e-15);
    EXPECT_NEAR(known.layers[1].picture.at(20, x).x, expected, 1e-15);
  }
}

TEST(FloorOracle, IsAThirdAtTheRangeOfThreeFactors) {
  // On the ring d = R: l = q = 1/2; l.n = H/R.
  Scene scene = small_floor();
  scene.lights = {light_of(PointLight{{0, 0, 1.2}, {2, 1, 1}})};
  scene.camera.height = 4.1 * 1.6 / 2;  // the pixel at x = 20 + 20 sees rho = 1.6
  const ClosedForm known = closed_form(scene);
  EXPECT_NEAR(known.layers[1].picture.at(40, 20).x, 1.2 / 2 / 4, 1e-15);
}

TEST(FloorOracle, IsSilentWhereSomethingInViewHidesTheFloor) {
  Scene scene = small_floor();
  scene.lights = {light_of(DirectionalLight{})};
  scene.objects.push_back({"ball", Sphere{{0, 0, 1}, 0.55}, 0});
  const ClosedForm known = closed_form(scene);
  EXPECT_EQ(known.layers[0].known[20 * 41 + 20], 0);
  EXPECT_EQ(known.layers[0].known[0], 1);
  const auto unknown = std::count(known.layers[0].known.begin(), known.layers[0].known.end(), 0);
  EXPECT_NEAR(double(unknown), std::numbers::pi * 5.5 * 5.5, 6);
}

TEST(FloorOracle, LeavesOutPixelsOnABoundary) {
  Scene scene = small_floor();
  scene.lights = {light_of(DirectionalLight{})};
  scene.objects.push_back({"block", Box{{0, -9, 1}, {9, 9, 2}}, 0, false});
  const ClosedForm known = closed_form(scene);  // the edge is at x = 0, which a column sees
  EXPECT_EQ(known.layers[1].known[5 * 41 + 20], 0);
  EXPECT_EQ(known.layers[1].known[5 * 41 + 19], 1);
  EXPECT_EQ(known.layers[1].picture.at(21, 5), glm::dvec3(0));
  EXPECT_EQ(known.layers[1].picture.at(19, 5), glm::dvec3(1));
}

TEST(FloorOracle, ConservesTheLightOfALampOnAnEndlessFloor) {
  // Of the flux of an inverse-square lamp half falls on the floor: the sum of H/d^3 over it is 2 pi
  // but for what lies beyond the picture. Q/R^2 -> infinity makes q an inverse square.
  Scene scene = small_floor();
  const double far = 1e-4;
  scene.lights = {light_of(PointLight{{0, 0, 0.5}, {far, 0, 1}})};
  scene.width = scene.height = 401, scene.camera.height = 40.1;
  const ClosedForm known = closed_form(scene);
  double flux = 0;
  for (const glm::dvec3& pixel : known.layers[1].picture.pixels)
    flux += pixel.x * 0.01 / (far * far);
  const double s = 20.05;  // the square's own share, by O7: 4 atan(s^2 / (H sqrt(2 s^2 + H^2)))
  const double expected = 4 * std::atan(s * s / (0.5 * std::sqrt(2 * s * s + 0.25)));
  EXPECT_NEAR(flux / expected, 1, 2e-3);
}

TEST(SpheresOracle, IsMirroredWhereTheSunIs) {
  Scene scene = small_floor();
  scene.objects = {{"ball", Sphere{{0, 0, 0}, 2}, 0}};
  scene.materials[0].specular = Color(0.5), scene.materials[0].shininess = 20;
  scene.expect = {Oracle::Spheres};
  scene.lights = {light_of(DirectionalLight{{-1, 0, -1}}), light_of(DirectionalLight{{1, 0, -1}})};
  scene.lights[1].name = "other";
  const ClosedForm known = closed_form(scene);
  for (int y = 0; y < 41; ++y)
    for (int x = 0; x < 41; ++x)
      EXPECT_NEAR(known.layers[1].picture.at(x, y).x, known.layers[2].picture.at(40 - x, y).x,
                  1e-15);
  // The peak of h.n is at C + r h, where the specular term is ks.
  const double c = std::cos(std::numbers::pi / 8);
  const int peak = 20 + int(std::lround(20 * std::sin(std::numbers::pi / 8)));
  EXPECT_NEAR(known.layers[1].picture.at(peak, 20).x, c + 0.5, 0.01);
}

TEST(SpheresOracle, IntegratesToTwoThirdsOfTheDisc) {
  // A matte sphere under a headlight: the mean of sqrt(1 - rho^2) over the disc is 2/3.
  Scene scene = small_floor();
  scene.width = scene.height = 201;
  scene.objects = {{"ball", Sphere{{0, 0, 0}, 2}, 0}};
  scene.expect = {Oracle::Spheres};
  scene.lights = {light_of(DirectionalLight{})};
  const ClosedForm known = closed_form(scene);
  double total = 0;
  for (const glm::dvec3& pixel : known.layers[1].picture.pixels) total += pixel.x;
  const double pixel = 4.1 / 201;
  EXPECT_NEAR(total * pixel * pixel / (std::numbers::pi * 4), 2.0 / 3, 1e-3);
}

TEST(SpheresOracle, KnowsTheBackgroundWhereOnlySpheresAreInView) {
  Scene scene = small_floor();
  scene.objects = {{"ball", Sphere{{0, 0, 0}, 1}, 0}};
  scene.expect = {Oracle::Spheres};
  EXPECT_EQ(closed_form(scene).layers[0].known[0], 1);
  scene.objects.push_back({"block", Box{{1.5, 1.5, 0}, {1.9, 1.9, 1}}, 0});
  EXPECT_EQ(closed_form(scene).layers[0].known[0], 0);
}

TEST(SpheresOracle, FillsItsSolidAngleInPerspective) {
  // From the distance D a sphere covers 2 pi (1 - sqrt(1 - r^2 / D^2)); a pixel at the angle theta
  // from the middle covers cos^3(theta) of its area at the distance 1.
  Scene scene = small_floor();
  scene.width = scene.height = 301;
  scene.camera.projection = Projection::Perspective, scene.camera.fov = 0.9;
  scene.objects = {{"ball", Sphere{{0.7, -0.4, 6}, 1.1}, 0}};
  scene.ambient = Color(1), scene.expect = {Oracle::Spheres};
  const ClosedForm known = closed_form(scene);
  const ClosedFormView view = view_of(scene);
  const double side = 2 * std::tan(0.45) / 301;
  double covered = 0;
  for (int y = 0; y < 301; ++y)
    for (int x = 0; x < 301; ++x)
      covered += known.layers[0].picture.at(x, y).x * side * side *
                 std::pow(double(glm::dot(sight(view, x, y).along, view.frame.forward)), 3);
  const double D2 = 0.7 * 0.7 + 0.4 * 0.4 + 16;
  EXPECT_NEAR(covered, 2 * std::numbers::pi * (1 - std::sqrt(1 - 1.1 * 1.1 / D2)), 1e-4);
}

TEST(BoxesOracle, ShowsTheFacesThatLookAtTheEye) {
  // A cube over a corner shows three faces; the light along (3, 2, 1) gives each its own cosine.
  Scene scene = small_floor();
  scene.camera.eye = {10, 10, 10}, scene.camera.up = {0, 0, 1};
  scene.objects = {{"cube", Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, 0}};
  scene.expect = {Oracle::Boxes};
  scene.lights = {light_of(DirectionalLight{{-3, -2, -1}})};
  const ClosedForm known = closed_form(scene);
  std::map<int, int> pixels;
  for (const glm::dvec3& value : known.layers[1].picture.pixels)
    ++pixels[int(std::lround(value.x * std::sqrt(14.0)))];
  const double face = std::sqrt(1.0 / 3) / (0.1 * 0.1);  // each is seen at the same angle
  for (const int cosine : {1, 2, 3}) EXPECT_NEAR(pixels[cosine], face, 6) << cosine;
  EXPECT_EQ(pixels.size(), 4u);  // and the background
}

TEST(SpectralForm, IsTheRgbOneWhereAllBandsAreEqual) {
  Scene scene = small_floor();
  scene.objects.push_back({"ball", Sphere{{0.3, 0.2, 0.9}, 0.6}, 0});
  scene.expect = {Oracle::Floor, Oracle::Spheres};
  scene.materials[0].specular = Color(0.5), scene.materials[0].shininess = 9;
  scene.ambient = Color(0.25);
  scene.lights = {light_of(PointLight{{1.2, -0.7, 3}, {2, 1, 1}})};
  const ClosedForm rgb = closed_form(scene);
  constexpr std::size_t kBands = 5;  // the last picture has two
  const auto all = [](double value) { return std::vector<double>(kBands, value); };
  scene.spectra = Spectra{int(kBands),
                          all(0.25),
                          {{all(1), all(1), all(0.5)}},
                          {{all(0), all(1), all(1)}},
                          std::vector(kBands, glm::dvec3(0.1))};
  const ClosedForm bands = closed_form(scene);
  ASSERT_EQ(bands.bands.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(bands.layers[k].known, rgb.layers[k].known);
    for (std::size_t i = 0; i < rgb.layers[k].picture.pixels.size(); ++i) {
      const glm::dvec3& value = rgb.layers[k].picture.pixels[i];
      ASSERT_EQ(bands.bands[0][k].picture.pixels[i], value);
      ASSERT_EQ(bands.bands[1][k].picture.pixels[i], glm::dvec3(value.x, value.y, 0));
      const glm::dvec3 seen = linear_srgb(glm::dvec3(0.5 * value.x));
      ASSERT_NEAR(bands.layers[k].picture.pixels[i].y, seen.y, 1e-15);
    }
  }
}

TEST(ShellOracle, IsOneConstant) {
  Scene scene = small_floor();
  scene.objects = {{"shell", Sphere{{0, 0, 10}, 1.5}, 0}};
  scene.lights = {light_of(PointLight{{0, 0, 10}, {2, 0.5, 1}})};
  scene.expect = {Oracle::Shell};
  const ClosedForm known = closed_form(scene);
  for (const glm::dvec3& pixel : known.layers[1].picture.pixels)
    EXPECT_NEAR(pixel.x, 1 / (1 + 0.5 * 0.75) / (1 + 0.75 * 0.75), 1e-15);
}

TEST(AmbientClaim, IsThatOfLevels) {
  Scene scene = small_floor();
  scene.ambient = Color(0.2, 0.4, 0.6);
  scene.materials[0].ambient = Color(0.5);
  scene.expect = {Oracle::Ambient};
  const ClosedForm known = closed_form(scene);
  ASSERT_EQ(known.claims.size(), 1u);
  EXPECT_EQ(known.claims[0].holds(0, 0, {0.1, 0.2, 0.3}), true);
  EXPECT_EQ(known.claims[0].holds(0, 0, {0, 0, 0}), true);
  EXPECT_EQ(known.claims[0].holds(0, 0, {0.2, 0.4, 0.6}), false);
}

TEST(ConeClaim, IsDarkOutsideTheCone) {
  Scene scene = small_floor();
  scene.lights = {light_of(SpotLight{{{0.01, 0.02, 2}, {}}, {0, 0, -1}, 0.4, 1})};
  scene.expect = {Oracle::ConeCurve};
  const ClosedForm known = closed_form(scene);
  const Claim& claim = known.claims.at(0);
  EXPECT_EQ(claim.holds(20, 20, glm::dvec3(1)), true);
  EXPECT_EQ(claim.holds(20, 20, glm::dvec3(0)), false);
  EXPECT_EQ(claim.holds(0, 0, glm::dvec3(0)), true);
  EXPECT_EQ(claim.holds(0, 0, glm::dvec3(1e-9)), false);
}

TEST(ClosedForm, RefusesByNameWhatAnOracleCannotSay) {
  Scene scene = small_floor();
  scene.samples = 2;
  EXPECT_THAT(refusal_of(scene), HasSubstr("one sample"));
  scene = small_floor();
  scene.shading = Shading::SampleCode;
  EXPECT_THAT(refusal_of(scene), HasSubstr("sample code"));
  scene = small_floor();
  scene.objects.clear();
  EXPECT_THAT(refusal_of(scene), HasSubstr("a plane that the camera sees"));
  scene = small_floor();
  scene.objects.push_back({"other", Plane{{0, 0, 1}, {0, 0, 1}}, 0});
  EXPECT_THAT(refusal_of(scene), HasSubstr("two that differ"));
  scene = small_floor();
  scene.expect = {Oracle::ConeCurve};
  EXPECT_THAT(refusal_of(scene), HasSubstr("cone-curve"));
  scene.expect = {Oracle::Shell};
  EXPECT_THAT(refusal_of(scene), HasSubstr("shell"));
  scene.expect = {Oracle::Spheres};
  EXPECT_THAT(refusal_of(scene), HasSubstr("no floor, sphere or box"));
  scene.camera.projection = Projection::Perspective;
  scene.objects.push_back({"ball", Sphere{scene.camera.eye, 0.5}, 0});
  EXPECT_THAT(refusal_of(scene), HasSubstr("inside of \"ball\""));
  scene.spectra.emplace();
  scene.expect = {Oracle::Ambient};
  EXPECT_THAT(refusal_of(scene), HasSubstr("not of bands"));
}

TEST(ClosedForm, SaysNothingOfASceneThatExpectsNothing) {
  Scene scene = small_floor();
  scene.expect.clear(), scene.samples = 3;
  const ClosedForm known = closed_form(scene);
  EXPECT_TRUE(known.layers.empty() && known.claims.empty() && known.figures.empty());
}

}  // namespace
}  // namespace litmus

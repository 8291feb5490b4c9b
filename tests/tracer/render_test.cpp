// render_test.cpp: whole pictures against closed forms, and relations that need no reference.
#include "tracer/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/largest_difference.h"
#include "tests/tracer/scenes.h"

namespace litmus {
namespace {

const Vector kSlanted{-0.6, -0.35, -1};

Scene busy_scene() {
  Scene scene = floor_from_above(48);
  scene.ambient = Color(0.1, 0.2, 0.3);
  scene.materials.push_back({"glossy", Color(1), Color(0.5, 0.3, 0.2), Color(0.4), 37.5});
  scene.objects.push_back({"ball", Sphere{{0.5, 0.4, 1.2}, 0.5}, 1, true});
  scene.objects.push_back({"block", Box{{-1.5, -1, 0.1}, {-0.7, 0.2, 0.8}}, 1, true});
  scene.lights = {sun(kSlanted), bulb({1, -1, 3}, {2, 0.5, 0.25})};
  scene.lights.push_back(
      make_light(SpotLight{{{-1, 1, 3}, {3, 0, 1}}, {0.4, -0.3, -1}, 0.5, 3}, "spot"));
  AreaLight area;
  area.point.origin = {0.3, 2, 3};
  area.columns = 3, area.rows = 2;
  scene.lights.push_back(make_light(area, "panel"));
  scene.lights.back().ambient = Color(0.05);
  return scene;
}

double peak(const Picture& picture) {
  return largest_difference(picture, Picture(picture.width, picture.height));
}

TEST(Render, GivesAFloorUnderTheSunOneValue) {
  Scene scene = floor_from_above();
  scene.lights = {sun(kSlanted)};
  const Rendering result = render(scene);
  const double expected = 0.8 / glm::length(kSlanted);
  for (const auto& pixel : result.whole.pixels) ASSERT_EQ(pixel, result.whole.pixels[0]);
  EXPECT_NEAR(result.whole.pixels[0].x, expected, 1e-15);
}

TEST(Render, LightsAFloorByAPointLightAsSlide11Says) {
  Scene scene = floor_from_above();
  const double height = 1.25, range = 2, linear = 0.7, quadratic = 1.3;
  scene.lights = {bulb({0.2, -0.1, height}, {range, linear, quadratic})};
  const Rendering result = render(scene);
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const double d = glm::length(floor_point(scene, x, y) - Point(0.2, -0.1, height));
      const double expected = 0.8 * (height / d) * (range / (range + linear * d)) *
                              (range * range / (range * range + quadratic * d * d));
      ASSERT_NEAR(result.whole.at(x, y).y, expected, 1e-14);
    }
  }
}

TEST(Render, ShadesASphereAsTheClosedFormDoes) {
  Scene scene = seen_from_above(65);
  scene.materials[0] = {"gloss", Color(0), Color(0.6), Color(0.4), 50};
  scene.objects.push_back({"ball", Sphere{{0, 0, 0}, 2}, 0, true});
  scene.lights = {sun({-1, -2, -3})};
  const Rendering result = render(scene);
  const Vector l = glm::normalize(Vector(1, 2, 3)), h = glm::normalize(l + Vector(0, 0, 1));
  int on_the_sphere = 0;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const Point p = floor_point(scene, x, y) / 2.0;
      const double squared = 1 - p.x * p.x - p.y * p.y;
      double expected = 0;
      if (squared > 0) {
        ++on_the_sphere;
        const Vector n{p.x, p.y, std::sqrt(squared)};
        const double cosine = glm::dot(l, n);
        if (cosine > 0) expected = 0.6 * cosine + 0.4 * std::pow(std::max(glm::dot(h, n), 0.0), 50);
      }
      ASSERT_NEAR(result.whole.at(x, y).x, expected, 1e-12);
    }
  }
  EXPECT_GT(on_the_sphere, 1000);
}

TEST(Render, CastsTheEllipseThatTheSunMakesOfASphere) {
  Scene scene = floor_from_above(200);
  scene.objects.push_back({"ball", Sphere{{0.3, 0.1, 1.7}, 0.6}, 0, false});
  scene.lights = {sun(kSlanted)};
  const Rendering result = render(scene);
  const Vector l = -glm::normalize(kSlanted);
  int shadowed = 0;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const Vector to_center = Point(0.3, 0.1, 1.7) - floor_point(scene, x, y);
      const double along = glm::dot(to_center, l);
      const bool dark = glm::dot(to_center, to_center) - along * along < 0.36;
      shadowed += dark;
      ASSERT_EQ(result.whole.at(x, y).x == 0, dark) << x << ", " << y;
    }
  }
  EXPECT_NEAR(shadowed * 36.0 / 40000, std::numbers::pi * 0.36 / l.z, 0.01);
}

TEST(Render, IsConstantInsideASphereWithTheLightAtItsCentre) {
  Scene scene = seen_from_above(32);
  scene.camera.projection = Projection::Perspective;
  scene.camera.eye = {0.3, -0.2, 0.5};
  scene.camera.target = {1, 1, 0};
  scene.camera.up = {0, 0, 1};
  scene.objects.push_back({"shell", Sphere{{0, 0, 0}, 1.5}, 0, true});
  scene.lights = {bulb({0, 0, 0}, {2, 1, 1})};
  const double x = 1.5 / 2, expected = 0.8 / (1 + x) / (1 + x * x);
  for (const auto& pixel : render(scene).whole.pixels) ASSERT_NEAR(pixel.x, expected, 1e-15);
}

TEST(Render, KeepsAnOccluderBehindTheLightOutOfTheWay) {
  Scene scene = floor_from_above();
  scene.lights = {bulb({0, 0, 1})};
  const Rendering open = render(scene);
  scene.objects.push_back({"ball", Sphere{{0, 0, 2}, 0.99}, 0, false});
  EXPECT_EQ(render(scene).whole.pixels, open.whole.pixels);
  std::get<Sphere>(scene.objects.back().shape).center.z = 0.5;  // the control: below the light
  std::get<Sphere>(scene.objects.back().shape).radius = 0.2;
  EXPECT_NE(render(scene).whole.pixels, open.whole.pixels);
}

TEST(Render, LeavesAmbientLightInFullShadow) {
  Scene scene = floor_from_above();
  scene.ambient = Color(0.2, 0.4, 0.6);
  scene.lights = {sun({0, 0, -1})};
  scene.lights[0].ambient = Color(0.1);
  scene.objects.push_back({"lid", Box{{-9, -9, 1}, {9, 9, 2}}, 0, false});
  for (const auto& pixel : render(scene).whole.pixels)
    ASSERT_EQ(pixel, Color(0.2, 0.4, 0.6) + Color(0.1));
}

TEST(Render, DropsShadowsWhereTheSceneDoes) {
  Scene scene = floor_from_above();
  scene.lights = {sun({0, 0, -1})};
  scene.objects.push_back({"lid", Box{{-9, -9, 1}, {9, 9, 2}}, 0, false});
  EXPECT_EQ(peak(render(scene).whole), 0.0);
  scene.shadows = false;
  EXPECT_DOUBLE_EQ(peak(render(scene).whole), 0.8);
}

TEST(Render, TreatsAOneByOneAreaAsAPointBitByBit) {
  Scene scene = busy_scene();
  AreaLight area;
  area.point = {{1, -1, 3}, {2, 0.5, 0.25}};
  scene.lights = {bulb({1, -1, 3}, {2, 0.5, 0.25})};
  const Rendering point = render(scene);
  scene.lights = {make_light(area)};
  EXPECT_EQ(render(scene).whole.pixels, point.whole.pixels);
}

TEST(Render, DoesNotDependOnTheNumberOfThreads) {
  const Scene scene = busy_scene();
  const Rendering one = render(scene, {Precision::Double, 1}),
                  two = render(scene, {Precision::Double, 2});
  for (std::size_t i = 0; i < one.layers.size(); ++i) {
    EXPECT_EQ(one.layers[i].picture.pixels, two.layers[i].picture.pixels);
    EXPECT_EQ(one.signatures[i].values, two.signatures[i].values);
  }
}

TEST(Render, AddsItsLayersUpToTheWholePicture) {
  for (const int samples : {1, 3}) {
    Scene scene = busy_scene();
    scene.samples = samples;
    const Rendering result = render(scene);
    EXPECT_EQ(result.layers.size(), 5u);
    EXPECT_LE(largest_difference(sum(result.layers), result.whole), 1e-13 * peak(result.whole));
  }
}

TEST(Render, IsTheSameBitByBitAtAnyPowerOfTwo) {
  const Scene scene = busy_scene();
  const Rendering expected = render(scene);
  for (const int k : {-40, -3, 7, 40}) {
    Scene scaled = scene;
    const double s = std::ldexp(1.0, k);
    scaled.camera.eye *= s, scaled.camera.target *= s, scaled.camera.height *= s;
    std::get<Sphere>(scaled.objects[1].shape) = {Point(0.5, 0.4, 1.2) * s, 0.5 * s};
    std::get<Box>(scaled.objects[2].shape) = {Point(-1.5, -1, 0.1) * s, Point(-0.7, 0.2, 0.8) * s};
    const auto scale = [&](PointLight& light) { light.origin *= s, light.attenuation.range *= s; };
    scale(std::get<PointLight>(scaled.lights[1].shape));
    scale(std::get<SpotLight>(scaled.lights[2].shape).point);
    AreaLight& area = std::get<AreaLight>(scaled.lights[3].shape);
    scale(area.point);
    area.width *= s, area.height *= s;
    EXPECT_EQ(render(scaled).whole.pixels, expected.whole.pixels) << "2^" << k;
  }
}

TEST(Render, AgreesWithQuadPrecisionToFourteenDigits) {
  const Scene scene = busy_scene();
  const Picture quad = render(scene, {Precision::Quad}).whole;
  EXPECT_LE(largest_difference(render(scene).whole, quad), 2e-14);
  EXPECT_LE(largest_difference(render(scene, {Precision::LongDouble}).whole, quad), 2e-15);
  EXPECT_GT(largest_difference(render(scene, {Precision::Float}).whole, quad), 1e-9);
}

TEST(Render, MovesThePictureByTheShift) {
  Scene scene = busy_scene();
  const Picture straight = render(scene).whole,
                shifted = render(scene, {Precision::Double, 0, 1, 0}).whole;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x + 1 < scene.width; ++x) {
      ASSERT_NEAR(shifted.at(x, y).x, straight.at(x + 1, y).x, 1e-12);
    }
  }
}

TEST(Render, LeavesNoSpeckleOnASmoothSphereOfTriangles) {
  Scene scene = seen_from_above();
  Mesh tent{{{-2, -2, 0}, {2, -2, 0}, {0, 0, 1.5}, {2, 2, 0}, {-2, 2, 0}},
            {},
            {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}}};
  scene.objects.push_back({"tent", tent, 0, true});
  scene.lights = {sun({-0.1, -0.05, -1})};
  const Rendering with_shadows = render(scene);
  scene.shadows = false;
  EXPECT_EQ(render(scene).whole.pixels, with_shadows.whole.pixels);
}

TEST(SampleCode, AddsAmbientOncePerLightThatIsNotOccluded) {
  Scene scene = floor_from_above();
  scene.shading = Shading::SampleCode;
  scene.ambient = Color(0.1);
  scene.lights = {sun({0, 0, -1}), bulb({0, 0, 1e6})};
  EXPECT_NEAR(render(scene).whole.at(3, 3).x, 2 * (0.1 + 0.8), 1e-9);
  scene.objects.push_back({"lid", Box{{-9, -9, 1}, {9, 9, 2}}, 0, false});
  EXPECT_EQ(render(scene).whole.at(3, 3).x, 0.0);
}

TEST(SampleCode, AddsAmbientForALightOfIntensityZero) {
  Scene scene = floor_from_above();
  scene.shading = Shading::SampleCode;
  scene.ambient = Color(0.1);
  scene.lights = {sun({0, 0, -1}), bulb({0, 0, 2})};
  for (Light& light : scene.lights) light.intensity = 0;
  EXPECT_NEAR(render(scene).whole.at(3, 3).x, 2 * 0.1, 1e-15);
  scene.shading = Shading::Equation;
  EXPECT_NEAR(render(scene).whole.at(3, 3).x, 0.1, 1e-15);
}

TEST(SampleCode, TakesTheDiffuseColourForTheHighlight) {
  Scene scene = floor_from_above();
  scene.materials[0] = {"mirror", Color(0), Color(0), Color(1), 1};
  scene.lights = {sun({0, 0, -1})};
  scene.lights[0].diffuse = Color(1, 0, 0), scene.lights[0].specular = Color(0, 0, 1);
  EXPECT_EQ(render(scene).whole.at(3, 3), Color(0, 0, 1));
  scene.shading = Shading::SampleCode;
  EXPECT_EQ(render(scene).whole.at(3, 3), Color(1, 0, 0));
}

TEST(Signature, ChangesOnlyAtBoundaries) {
  Scene scene = floor_from_above(64);
  scene.objects.push_back({"ball", Sphere{{0.3, 0.1, 1.7}, 0.6}, 0, false});
  scene.lights = {sun(kSlanted)};
  const Rendering result = render(scene);
  std::vector<std::uint64_t> kinds = result.signatures[1].values;
  std::sort(kinds.begin(), kinds.end());
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  EXPECT_EQ(kinds.size(), 2u);  // lit floor and shadowed floor
}

TEST(Flags, TellLitFromHiddenFromTurnedAway) {
  Scene scene = floor_from_above(64);
  scene.objects.push_back({"ball", Sphere{{0, 0, 1.5}, 0.8}, 0, false});
  scene.lights = {sun({0, 0, -1}), sun({0, 0, 1})};
  const std::vector<std::vector<std::uint8_t>> flags = render(scene).flags;
  ASSERT_EQ(flags.size(), 3u);
  EXPECT_EQ(flags[0][32 * 64 + 32], 0);       // ambient
  EXPECT_EQ(flags[1][32 * 64 + 32], kUmbra);  // below the ball
  EXPECT_EQ(flags[1][0], kLit);
  EXPECT_EQ(flags[2][32 * 64 + 32], 0);  // the light shines from below
  scene.shadows = false;
  EXPECT_EQ(render(scene).flags[1][32 * 64 + 32], kLit);
}

TEST(Flags, TellAPenumbraByTheLampsInView) {
  Scene scene = floor_from_above(96);
  scene.objects.push_back({"ball", Sphere{{0, 0, 1.5}, 0.5}, 0, false});
  AreaLight panel;
  panel.point.origin = {0, 0, 4}, panel.normal = Vector{0, 0, -1};
  panel.width = panel.height = 0.6, panel.columns = panel.rows = 4;
  scene.lights = {make_light(panel)};
  const Rendering result = render(scene);
  int counts[8] = {};
  for (std::size_t i = 0; i < result.flags[1].size(); ++i) {
    const std::uint8_t flags = result.flags[1][i];
    ++counts[flags];
    if (flags == kUmbra) {
      ASSERT_EQ(result.whole.pixels[i], Color(0));
    }
    if (flags == kLit || flags == kPenumbra) {
      ASSERT_GT(result.whole.pixels[i].x, 0);
    }
  }
  EXPECT_GT(counts[kLit], 0);
  EXPECT_GT(counts[kPenumbra], 0);
  EXPECT_GT(counts[kUmbra], 0);
  EXPECT_EQ(counts[kLit] + counts[kPenumbra] + counts[kUmbra], 96 * 96);
}

TEST(Flags, MarkAHighlightAboveHalfItsPeak) {
  Scene scene = floor_from_above(64);
  scene.materials[0] = {"gloss", Color(0), Color(0), Color(1), 40};
  scene.lights = {bulb({0, 0, 3})};
  const Rendering result = render(scene);
  int marked = 0;
  for (std::size_t i = 0; i < result.flags[1].size(); ++i) {
    const bool highlight = (result.flags[1][i] & kHighlight) != 0;
    ASSERT_EQ(highlight, result.whole.pixels[i].x > 0.5) << i;  // there is no other term
    marked += highlight;
  }
  EXPECT_GT(marked, 10);
  scene.materials[0].specular = Color(0), scene.materials[0].diffuse = Color(1);
  const Rendering matte = render(scene);
  for (const std::uint8_t flags : matte.flags[1]) ASSERT_EQ(flags & kHighlight, 0);
}

TEST(Probe, ShowsWhatThePixelShows) {
  Scene scene = busy_scene();
  scene.samples = 2;
  const Rendering result = render(scene);
  const Probe around = probe(scene);
  for (int i = 0; i < 48; i += 5) {
    const std::vector<glm::dvec3> colors = around(i + 0.5, 20.5);
    for (std::size_t k = 0; k < colors.size(); ++k) {
      ASSERT_NEAR(colors[k].x, result.layers[k].picture.at(i, 20).x, 1e-12);
    }
  }
}

TEST(Probe, FollowsTheShift) {
  const Scene scene = busy_scene();
  const RenderOptions options{Precision::Double, 0, 0.3, -0.2};
  const Rendering result = render(scene, options);
  const Probe around = probe(scene, options);
  for (int i = 0; i < 48; i += 5) {
    ASSERT_NEAR(around(i + 0.5, 20.5)[1].x, result.layers[1].picture.at(i, 20).x, 1e-12);
  }
}

}  // namespace
}  // namespace litmus

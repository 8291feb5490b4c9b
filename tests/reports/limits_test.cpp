// limits_test.cpp: what the tracer's lights become in a limit, and how fast.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "reference/closed_form_figures.h"
#include "scene/load.h"
#include "tests/largest_difference.h"
#include "tracer/render.h"

namespace litmus {
namespace {

/// A canonical scene, its picture made small.
Scene small(const std::string& name, int side) {
  Scene scene = load_scene(find_scene(name));
  scene.width = scene.height = side;
  return scene;
}

/// The exact integral over the rectangle of R4 at every pixel's point of the floor.
Picture exact_integral(const Scene& scene) {
  const auto& area = std::get<AreaLight>(scene.lights[0].shape);
  const double H = area.point.origin.z, side = scene.camera.height / scene.height;
  Picture picture(scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const Exact px = (x + 0.5L - scene.width / 2.0L) * side,
                  py = (scene.height / 2.0L - y - 0.5L) * side;
      picture.at(x, y) = glm::dvec3(
          double(rectangle_mean_cosine({-area.width / 2 - px, area.width / 2 - px},
                                       {-area.height / 2 - py, area.height / 2 - py}, H)));
    }
  return picture;
}

Picture with_grid(Scene scene, int n, Placement placement) {
  auto& area = std::get<AreaLight>(scene.lights[0].shape);
  area.columns = area.rows = n, area.placement = placement;
  return render(scene).layers[1].picture;
}

TEST(AreaGrid, ConvergesWithTheSquareFromCentresAndLinearlyFromCorners) {
  const Scene scene = small("r4", 12);
  const Picture exact = exact_integral(scene);
  for (const auto& [placement, ratio] :
       {std::pair{Placement::Centres, 4.0}, std::pair{Placement::Corners, 2.0}}) {
    const double coarse = largest_difference(with_grid(scene, 16, placement), exact),
                 fine = largest_difference(with_grid(scene, 32, placement), exact);
    EXPECT_NEAR(coarse / fine, ratio, 0.15);
  }
}

TEST(AreaGrid, MeetsTheIntegralByRichardsonsExtrapolation) {
  const Scene scene = small("r4", 12);
  const Picture exact = exact_integral(scene);
  const auto error = [&](int n) {
    Picture better = with_grid(scene, 2 * n, Placement::Centres);
    const Picture coarse = with_grid(scene, n, Placement::Centres);
    for (std::size_t i = 0; i < better.pixels.size(); ++i)
      better.pixels[i] = (4.0 * better.pixels[i] - coarse.pixels[i]) / 3.0;
    return largest_difference(better, exact);
  };
  EXPECT_NEAR(error(8) / error(16), 16, 1);
  EXPECT_LE(error(16), 1e-7);
}

TEST(PointLight, BecomesTheSunWithTheInverseOfItsDistance) {
  Scene scene = small("p9", 24);
  scene.objects.resize(1);  // the open floor
  const Point far = std::get<PointLight>(scene.lights[0].shape).origin;
  scene.lights.resize(1);
  const auto at = [&](double distance) {
    std::get<PointLight>(scene.lights[0].shape).origin = far / glm::length(far) * distance;
    return render(scene).layers[1].picture;
  };
  Scene sunny = scene;
  sunny.lights[0].shape = DirectionalLight{-far};
  const Picture sun = render(sunny).layers[1].picture;
  for (const double distance : {1e3, 1e4, 1e5})
    EXPECT_NEAR(largest_difference(at(distance), sun) / largest_difference(at(10 * distance), sun),
                10, 0.2)
        << distance;
}

TEST(Range, WeakensNothingInTheLimit) {
  Scene scene = small("p12", 24);
  scene.lights.erase(scene.lights.begin());  // that of the smallest range
  const auto with_range = [&](double range) {
    for (Light& light : scene.lights) std::get<PointLight>(light.shape).attenuation.range = range;
    return render(scene).whole;
  };
  for (Light& light : scene.lights) std::get<PointLight>(light.shape).attenuation.linear = 1;
  const Picture endless = with_range(1e30);
  for (const double range : {1e3, 1e6, 1e9})
    EXPECT_NEAR(largest_difference(with_range(range), endless) /
                    largest_difference(with_range(10 * range), endless),
                10, 0.2)
        << range;
  EXPECT_EQ(largest_difference(with_range(1e20), endless), 0);
}

TEST(SpotLight, IsAPointLightBitByBitInTheLimit) {
  Scene scene = small("s6", 48);
  const Picture wide = render(scene).whole;
  const PointLight point = std::get<SpotLight>(scene.lights[0].shape).point;
  std::get<SpotLight>(scene.lights[0].shape).exponent = 10;
  EXPECT_GT(largest_difference(render(scene).whole, wide), 1e-9);  // not yet there
  scene.lights[0].shape = point;
  EXPECT_EQ(largest_difference(render(scene).whole, wide), 0);
}

TEST(AreaLight, BecomesAPointLightWithTheSquareOfItsSize) {
  Scene scene = small("r8", 24);
  scene.objects.resize(1);
  auto& area = std::get<AreaLight>(scene.lights[0].shape);
  Scene point_scene = scene;
  point_scene.lights[0].shape = area.point;
  const Picture point = render(point_scene).whole;
  const auto of_size = [&](double size) {
    area.width = area.height = size;
    return largest_difference(render(scene).whole, point);
  };
  EXPECT_NEAR(of_size(0.1) / of_size(0.01), 100, 2);
  EXPECT_LE(of_size(0.001), 1e-6);
}

}  // namespace
}  // namespace litmus

// seen_points_test.cpp: the points are where the camera looks, by closed form.
#include "exporters/seen_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace litmus {
namespace {

/// Seen from (0, 0, 5) straight down, 4 units wide.
Scene from_above() {
  Scene scene;
  scene.width = scene.height = 64;
  scene.camera = {Projection::Orthographic, {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.7, 4};
  scene.materials.push_back({});
  return scene;
}

TEST(SeenPoints, CoverAFloorEvenly) {
  Scene scene = from_above();
  scene.objects.push_back({"floor", Plane{}, 0, true});
  const auto points = seen_points(scene);
  ASSERT_EQ(points.size(), 24u * 18u);
  Point mean(0);
  for (const Point& p : points) {
    EXPECT_EQ(p.z, 0);
    EXPECT_LT(std::abs(p.x), 2);
    mean += p / double(points.size());
  }
  EXPECT_NEAR(glm::length(mean), 0, 1e-12);
}

TEST(SeenPoints, AreOnTheNearestSurface) {
  Scene scene = from_above();
  scene.objects.push_back({"floor", Plane{}, 0, true});
  scene.objects.push_back({"crate", Box{{-1, -1, 0}, {1, 1, 1}}, 0, true});
  scene.objects.push_back({"ball", Sphere{{0, 0, 1}, 0.5}, 0, true});
  scene.objects.push_back({"sail", Triangle{{1.2, -2, 2}, {2, -2, 2}, {2, 2, 2}}, 0, true});
  scene.objects.push_back({"roof", Plane{{0, 0, 4}, {0, 0, 1}}, 0, false});
  int on_floor = 0, on_crate = 0, on_ball = 0, on_sail = 0;
  for (const Point& p : seen_points(scene)) {
    const auto at_height = [&](double z) { return std::abs(p.z - z) < 1e-12; };
    on_floor += at_height(0), on_crate += at_height(1), on_sail += at_height(2);
    on_ball += p.z > 1.01 && std::abs(glm::distance(p, Point(0, 0, 1)) - 0.5) < 1e-12;
  }
  EXPECT_EQ(on_floor + on_crate + on_ball + on_sail, 24 * 18);
  for (const int count : {on_floor, on_crate, on_ball, on_sail}) EXPECT_GT(count, 0);
}

TEST(SeenPoints, LieOnTheShellAroundAnEyeInside) {
  Scene scene;
  scene.camera.eye = {0, 0, 0.1}, scene.camera.target = {1, 0, 0.1};
  scene.materials.push_back({});
  scene.objects.push_back({"shell", Sphere{{0, 0, 0}, 2}, 0, true});
  ASSERT_FALSE(seen_points(scene).empty());
  for (const Point& p : seen_points(scene)) EXPECT_NEAR(glm::length(p), 2, 1e-12);
}

TEST(SeenPoints, AreNoneInAnEmptyScene) { EXPECT_TRUE(seen_points(from_above()).empty()); }

}  // namespace
}  // namespace litmus

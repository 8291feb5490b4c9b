// blender_geometry_test.cpp: how much of a plane is exported, and where the eye stands.
#include "exporters/blender_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace litmus {
namespace {

/// A floor seen from above: the picture shows x in -3..3, y in -2..2.
Scene top_view() {
  Scene scene;
  scene.width = 60;
  scene.height = 40;
  scene.camera = {Projection::Orthographic, {0, 0, 50}, {0, 0, 0}, {0, 1, 0}, 0.7, 4};
  scene.materials.push_back({});
  scene.objects.push_back({"floor", Plane{}, 0, true});
  return scene;
}

struct Reach {
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
};
Reach reach(const std::array<Point, 4>& rectangle) {
  Reach r;
  for (const Point& p : rectangle) {
    r.x0 = std::min(r.x0, p.x), r.x1 = std::max(r.x1, p.x);
    r.y0 = std::min(r.y0, p.y), r.y1 = std::max(r.y1, p.y);
  }
  return r;
}

TEST(BlenderPlane, IsAsLargeAsThePicture) {
  const auto rectangles = plane_rectangles(top_view(), Plane{});
  ASSERT_EQ(rectangles.size(), 1u);
  const Reach r = reach(rectangles[0]);
  // Pixel centres reach to 2.95 and 1.95; a hundredth of the size is added.
  EXPECT_NEAR(r.x1, 2.95 + 0.059, 1e-12);
  EXPECT_NEAR(r.y0, -1.95 - 0.059, 1e-12);
}

TEST(BlenderPlane, IsNothingWhereItIsNotSeen) {
  EXPECT_TRUE(plane_rectangles(top_view(), Plane{{0, 0, 60}, {0, 0, 1}}).empty());
}

TEST(BlenderPlane, ReachesToWhereItStandsBetweenALampAndWhatIsSeen) {
  Scene scene = top_view();
  scene.lights.push_back({.name = "under", .shape = PointLight{{20, 0, -1}, {}}});
  scene.objects.push_back({"ball", Sphere{{0, 0, 5}, 1}, 0, true});
  EXPECT_GT(reach(plane_rectangles(scene, Plane{})[0]).x1, 20);
  scene.shadows = false;
  EXPECT_LT(reach(plane_rectangles(scene, Plane{})[0]).x1, 4);
  scene.shadows = true;
  std::get<PointLight>(scene.lights[0].shape).origin.z = 7;
  EXPECT_LT(reach(plane_rectangles(scene, Plane{})[0]).x1, 4) << "a lamp on the seen side";
}

TEST(BlenderPlane, FollowsTheSunsRaysFromWhatIsSeen) {
  Scene scene = top_view();
  scene.objects.push_back({"ball", Sphere{{0, 0, 5}, 1}, 0, true});
  // Light that travels up meets the ball's top (1, 0, 6) after it left the floor at x = 1 + 2 * 6.
  scene.lights.push_back({.name = "below", .shape = DirectionalLight{{-2, 0, 1}}});
  EXPECT_GE(reach(plane_rectangles(scene, Plane{})[0]).x1, 13);
}

TEST(BlenderPlane, TowardsTheHorizonItIsNested) {
  Scene scene = top_view();
  scene.camera = {Projection::Perspective, {0, -8, 1}, {0, 0, 1}, {0, 0, 1}, 0.7, 1};
  const auto rectangles = plane_rectangles(scene, Plane{});
  ASSERT_GT(rectangles.size(), 1u);
  for (std::size_t i = 1; i < rectangles.size(); ++i) {
    const Reach inner = reach(rectangles[i - 1]), outer = reach(rectangles[i]);
    EXPECT_LE(outer.x0, inner.x0);
    EXPECT_GE(outer.x1, inner.x1);
    EXPECT_LE(outer.y0, inner.y0);
    EXPECT_GE(outer.y1, inner.y1);
  }
}

TEST(BlenderPlane, LiesInThePlane) {
  Scene scene = top_view();
  const Plane tilted{{0, 0, 1}, {0.3, -0.2, 2}};
  for (const auto& rectangle : plane_rectangles(scene, tilted)) {
    for (const Point& p : rectangle) {
      EXPECT_NEAR(glm::dot(p - tilted.point, tilted.normal), 0, 1e-13);
    }
  }
}

TEST(BlenderEye, KnowsWhenItIsInsideASphere) {
  Camera camera{Projection::Perspective, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 0.7, 1};
  EXPECT_TRUE(holds_eye(camera, 1, Sphere{{0, 0, 0}, 1.5}));
  EXPECT_FALSE(holds_eye(camera, 1, Sphere{{0, 0, 0}, 0.9}));
  camera.projection = Projection::Orthographic;
  camera.height = 4;
  EXPECT_TRUE(holds_eye(camera, 1, Sphere{{1.5, 0, 1}, 0.2}));
  EXPECT_FALSE(holds_eye(camera, 1, Sphere{{1.5, 0, 0}, 0.2}));
}

TEST(BlenderEye, AnOrthographicEyeComesNear) {
  Scene scene = top_view();
  EXPECT_EQ(near_eye(scene), Point(0, 0, 1));
  scene.objects.push_back({"ball", Sphere{{0, 0, 5}, 1}, 0, true});
  EXPECT_EQ(near_eye(scene), Point(0, 0, 7));
  scene.objects.back().camera_visible = false;
  EXPECT_EQ(near_eye(scene), Point(0, 0, 1));
}

TEST(BlenderEye, StaysWhereItIsAmongTheObjects) {
  Scene scene = top_view();
  scene.objects.push_back({"ball", Sphere{{0, 0, 50}, 1}, 0, true});
  EXPECT_EQ(near_eye(scene), scene.camera.eye);
  scene = top_view();
  scene.camera.projection = Projection::Perspective;
  EXPECT_EQ(near_eye(scene), scene.camera.eye);
}

}  // namespace
}  // namespace litmus

// envelope_test.cpp: a scene is moved to where reference renderers are accurate, and nothing else.
#include "exporters/envelope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/refusal.h"

namespace litmus {
namespace {

Scene ball_on_floor(double size, const Point& at) {
  Scene scene;
  scene.camera.eye = at + Point(4, -6, 3.5) * size;
  scene.camera.target = at;
  scene.materials.push_back({"white"});
  scene.objects.push_back({"floor", Plane{at, {0, 0, 1}}});
  scene.objects.push_back({"ball", Sphere{at + Point(0, 0, size), size}});
  SpotLight spot;
  spot.point = {at + Point(0, 0, 4) * size, {2 * size, 1, 1}};
  scene.lights.push_back({"spot", spot});
  AreaLight area;
  area.point = {at + Point(1, 1, 3) * size, {size, 1, 0}};
  area.width = area.height = size;
  scene.lights.push_back({"area", area});
  return scene;
}

double extent(const Scene& scene) { return std::get<Sphere>(scene.objects[1].shape).radius; }

TEST(Envelope, LeavesAnOrdinarySceneAlone) {
  EXPECT_TRUE(envelope_of(ball_on_floor(1, Point(0))).identity());
}

TEST(Envelope, RescalesByAPowerOfTwo) {
  for (const double size : {1e-4, 1e6}) {
    const Scene scene = ball_on_floor(size, Point(0));
    const Envelope envelope = envelope_of(scene);
    int exponent = 0;
    EXPECT_EQ(std::frexp(envelope.scale, &exponent), 0.5) << size;
    const Scene moved = into_envelope(scene);
    EXPECT_GT(extent(moved), 0.5) << size;
    EXPECT_LT(extent(moved), 16) << size;
  }
}

TEST(Envelope, RecentresWhatIsFarAway) {
  const Scene moved = into_envelope(ball_on_floor(1, Point(1e5, 0, 0)));
  EXPECT_LT(std::abs(std::get<Sphere>(moved.objects[1].shape).center.x), 20);
  EXPECT_LT(std::abs(moved.camera.eye.x), 40);
}

TEST(Envelope, ScalesEveryLengthAlike) {
  const Scene scene = ball_on_floor(1e-4, Point(0));
  const double scale = envelope_of(scene).scale;
  const Scene moved = into_envelope(scene);
  EXPECT_EQ(std::get<SpotLight>(moved.lights[0].shape).point.attenuation.range, 2e-4 * scale);
  const AreaLight& area = std::get<AreaLight>(moved.lights[1].shape);
  EXPECT_EQ(area.width, 1e-4 * scale);
  EXPECT_EQ(area.height, 1e-4 * scale);
  EXPECT_EQ(moved.camera.height, scale);
  EXPECT_EQ(moved.camera.fov, scene.camera.fov);
}

TEST(Envelope, ResolvesAnAreaNormalBeforeItMoves) {
  const Scene moved = into_envelope(ball_on_floor(1, Point(1e5, 0, 0)));
  const AreaLight& area = std::get<AreaLight>(moved.lights[1].shape);
  ASSERT_TRUE(area.normal);
  EXPECT_EQ(*area.normal, -Point(1e5 + 1, 1, 3));
}

TEST(Envelope, RefusesAnAreaLightWithoutNormalAtTheOrigin) {
  Scene scene = ball_on_floor(1, Point(0));
  std::get<AreaLight>(scene.lights[1].shape).point.origin = Point(0);
  EXPECT_THROW(into_envelope(scene), Refusal);
}

TEST(Envelope, IsNotStretchedByAFarLight) {
  Scene scene = ball_on_floor(1, Point(0));
  std::get<SpotLight>(scene.lights[0].shape).point.origin = {0, 0, 1e6};
  EXPECT_TRUE(envelope_of(scene).identity());
}

TEST(Envelope, LeavesASceneThatIsTaggedUnmoved) {
  Scene scene = ball_on_floor(1e6, Point(0));
  ASSERT_FALSE(envelope_of(scene).identity());
  scene.tags = {"unmoved"};
  EXPECT_TRUE(envelope_of(scene).identity());
}

}  // namespace
}  // namespace litmus

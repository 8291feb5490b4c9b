// visibility_test.cpp: what stands in the way, and what does not.
#include "tracer/visibility.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/tracer/scenes.h"
#include "tracer/closest.h"

namespace litmus {
namespace {

using V = Vec<double>;

Lamp<double> lamp_at(const V& origin) {
  Lamp<double> lamp;
  lamp.origin = origin;
  return lamp;
}

bool dark(const Plan<double>& plan, const V& from, const V& toward, const V& lamp) {
  const Hit<double> hit = closest_hit(plan, {from, toward - from});
  EXPECT_NE(hit.kind, Kind::None);
  return occluded(plan, hit, incident(lamp_at(lamp), hit.point));
}

Plan<double> plan_of(decltype(Object::shape) shape) {
  Scene scene = seen_from_above();
  scene.objects.push_back({"thing", std::move(shape), 0, true});
  return lower<double>(scene);
}

TEST(Occluded, NeverSelfShadowsALitSphere) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  const V center{100, -40, 1e4};
  const Plan<double> plan = plan_of(Sphere{{100, -40, 1e4}, 3});
  int lit = 0;
  for (int i = 0; i < 20000; ++i) {
    const V eye = center + 10.0 * normalize(V{normal(random), normal(random), normal(random)});
    const V lamp = center + 50.0 * normalize(V{normal(random), normal(random), normal(random)});
    const Hit<double> hit = closest_hit(plan, {eye, center - eye});
    const Incident<double> light = incident(lamp_at(lamp), hit.point);
    if (!(dot(light.direction, hit.geometric) > 0)) continue;
    ++lit;
    ASSERT_FALSE(occluded(plan, hit, light));
  }
  EXPECT_GT(lit, 5000);
}

TEST(Occluded, IsTrueAcrossTheInsideOfASphere) {
  const Plan<double> plan = plan_of(Sphere{{0, 0, 0}, 1});
  EXPECT_FALSE(dark(plan, {0, 0, 0}, {0, 0, -1}, {0, 0, 0.9}));
  EXPECT_TRUE(dark(plan, {0, 0, 0}, {0, 0, -1}, {0, 0, 1.1}));
}

TEST(Occluded, IsTrueAcrossTheInsideOfABox) {
  const Plan<double> plan = plan_of(Box{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_FALSE(dark(plan, {0, 0, 0}, {0.2, 0.1, -1}, {0, 0, 0.9}));
  EXPECT_TRUE(dark(plan, {0, 0, 0}, {0.2, 0.1, -1}, {0, 0, 1.1}));
}

TEST(Occluded, IsFalseOffTheOutsideOfABox) {
  const Plan<double> plan = plan_of(Box{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_FALSE(dark(plan, {0, 0, 5}, {0.2, 0.1, 1}, {3, 3, 1.001}));
}

TEST(Occluded, IsFalseForALightOnTheWallBehindIt) {
  Scene scene = floor_from_above();
  scene.objects.push_back({"wall", Plane{{0, 0, 3}, {0, 0, -1}}, 0, true});
  const Plan<double> plan = lower<double>(scene);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-5, 5);
  for (int i = 0; i < 10000; ++i) {
    ASSERT_FALSE(dark(plan, {0, 0, 1}, {place(random), place(random), 0},
                      {place(random), place(random), 3}));
  }
}

TEST(Occluded, SeesAnOccluderCloseAboveTheSurface) {
  Scene scene = floor_from_above();
  scene.objects.push_back({"film", Plane{{0, 0, 1e-12}, {0, 0, 1}}, 0, false});
  const Plan<double> plan = lower<double>(scene);
  EXPECT_TRUE(dark(plan, {0, 0, 1}, {0.3, 0.2, 0}, {0, 0, 3}));
}

TEST(ClosestHit, PutsThePointOnTheSurfaceItself) {
  const Plan<double> plan = plan_of(Plane{{0, 0, 0.3}, {0, 0, 1}});
  EXPECT_EQ(closest_hit(plan, {{0.1, 0.2, 7}, V{0.3, 0.7, -1}}).point.z, 0.3);
}

TEST(ClosestHit, TurnsTheNormalTowardsTheEye) {
  const Plan<double> plan = plan_of(Plane{{0, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(closest_hit(plan, {{0, 0, -2}, {0, 0, 1}}).normal.z, -1);
  EXPECT_EQ(closest_hit(plan, {{0, 0, 2}, {0, 0, -1}}).normal.z, 1);
}

TEST(ClosestHit, GivesCoincidentSurfacesToTheFirstObject) {
  Scene scene = floor_from_above();
  scene.objects.push_back({"second", Plane{}, 0, true});
  scene.objects.push_back({"third", Box{{-1, -1, -1}, {1, 1, 0}}, 0, true});
  EXPECT_EQ(closest_hit(lower<double>(scene), {{0.3, 0.2, 7}, {0, 0, -1}}).object, 0);
}

TEST(ClosestHit, LooksThroughObjectsThatTheCameraDoesNotSee) {
  Scene scene = floor_from_above();
  scene.objects.push_back({"hidden", Sphere{{0, 0, 1}, 0.5}, 0, false});
  EXPECT_EQ(closest_hit(lower<double>(scene), {{0, 0, 7}, {0, 0, -1}}).object, 0);
}

}  // namespace
}  // namespace litmus

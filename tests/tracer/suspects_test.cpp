// suspects_test.cpp: what hides a lamp is among the suspects, and what is far aside is not.
#include "tracer/suspects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/tracer/scenes.h"
#include "tracer/closest.h"

namespace litmus {
namespace {

using V3 = Vec<double>;

struct Chance {
  std::mt19937_64 engine{3};
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
};

bool lists(const ShortList& list, int number) {
  return list.all ||
         std::count(list.numbers.begin(), list.numbers.begin() + list.count, number) > 0;
}

/// Balls, boxes and a wall about a floor, under one light.
Scene crowd(Chance& random, const Light& light) {
  Scene scene = floor_from_above(40);
  for (int i = 0; i < 6; ++i) {
    const Point at(random(-3, 3), random(-3, 3), random(0.5, 3));
    scene.objects.push_back({"ball", Sphere{at, random(0.05, 0.5)}, 0, true});
    const Vector size(random(0.05, 0.8), random(0.05, 0.8), random(0.05, 0.8));
    scene.objects.push_back(
        {"box", Box{at + Vector(1, 0, 0), at + Vector(1, 0, 0) + size}, 0, true});
  }
  scene.objects.push_back({"wall", Plane{{random(-3, 3), 0, 0}, {1, random(-1, 1), 0}}, 0, true});
  scene.lights = {light};
  return scene;
}

/// Hits on a patch of the floor.
std::vector<Hit<double>> patch(const Plan<double>& plan, Chance& random) {
  const double x = random(-2, 2), y = random(-2, 2), size = random(0.01, 0.5);
  std::vector<Hit<double>> hits;
  for (int i = 0; i < 30; ++i) {
    const V3 at{x + random(0, size), y + random(0, size), 0};
    Hit<double> hit = closest_hit(plan, {at + V3{0, 0, 1e-6}, {0, 0, -1}});
    if (hit.object == 0) hits.push_back(hit);
  }
  return hits;
}

struct Shadows {
  int hidden = 0, missed = 0, listed = 0, all = 0;
};

void compare_shadows(const Plan<double>& plan, Chance& random, Shadows& found) {
  RegionOf<double> points;
  const std::vector<Hit<double>> hits = patch(plan, random);
  for (const Hit<double>& hit : hits) points.add(hit);
  Suspects suspects;
  find_suspects(plan, plan.sources[0], points.region(), suspects);
  if (hits.empty()) return;
  for (std::size_t i = 0; i < plan.spheres.size(); ++i)
    found.listed += lists(suspects.spheres, int(i)), ++found.all;
  for (const Hit<double>& hit : hits) {
    for (const Lamp<double>& lamp : plan.sources[0].lamps) {
      const Incident<double> light = incident(lamp, hit.point);
      if (!(dot(light.direction, hit.geometric) > 0)) continue;
      const bool hidden = occluded(plan, hit, light);
      found.hidden += hidden;
      found.missed += hidden != occluded(plan, hit, light, true, suspects);
    }
  }
}

TEST(FindSuspects, ListsWhateverHidesALampFromAPointOfTheRegion) {
  Chance random;
  AreaLight panel;
  panel.point.origin = {0.3, -0.4, 4}, panel.normal = Vector{0, 0.1, -1};
  panel.width = 1.5, panel.height = 0.7, panel.columns = panel.rows = 3;
  for (const Light& light : {make_light(panel), make_light(PointLight{{0.5, 0.2, 3.5}, {}}, "bulb"),
                             sun({0.2, 0.3, -1})}) {
    Shadows found;
    for (int i = 0; i < 300; ++i)
      compare_shadows(lower<double>(crowd(random, light)), random, found);
    EXPECT_EQ(found.missed, 0) << light.name;
    EXPECT_GT(found.hidden, 1000) << light.name;
    EXPECT_LT(found.listed, found.all / 2) << light.name << ": culling that culls";
  }
}

TEST(FindSuspects, LeavesOutTheSolidThatIsSeenFromOutside) {
  Scene scene = floor_from_above(40);
  scene.objects = {{"ball", Sphere{{0, 0, 1}, 1}, 0, true}};
  scene.lights = {sun({0, 0, -1})};
  const Plan<double> plan = lower<double>(scene);
  const auto suspects_at = [&](const V3& eye, const V3& way) {
    RegionOf<double> points;
    points.add(closest_hit(plan, {eye, way}));
    Suspects suspects;
    find_suspects(plan, plan.sources[0], points.region(), suspects);
    return suspects;
  };
  EXPECT_TRUE(suspects_at({0, 0, 9}, {0.01, 0, -1}).empty());
  EXPECT_FALSE(suspects_at({0, 0, 1}, {0.01, 0, -1}).empty()) << "from within, its far side counts";
}

}  // namespace
}  // namespace litmus

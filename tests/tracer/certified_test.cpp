// certified_test.cpp: the certified sampler against closed forms and fine grids, each pixel within
// its bound.
#include "tracer/certified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "scene/load.h"
#include "tests/tracer/scenes.h"
#include "tracer/area_sampling.h"

namespace litmus {
namespace {

constexpr double kHeight = 3, kSide = 1;

Scene under_a_ceiling_panel(int size) {
  Scene scene = floor_from_above(size);
  AreaLight area;
  area.point.origin = {0, 0, kHeight};
  area.normal = Vector(0, 0, -1);
  area.width = area.height = kSide;
  scene.lights = {make_light(area, "panel")};
  return scene;
}

RenderOptions certified(int n) { return {.sampler = Sampler::Certified, .area_samples = n}; }

/// Integral of h / sqrt(x^2 + y^2 + h^2) over 0..x, 0..y.
double cosine_integral(double x, double y, double h) {
  return h * (x * std::asinh(y / std::hypot(x, h)) + y * std::asinh(x / std::hypot(y, h)) -
              h * std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h))));
}

/// Mean of l.n at a floor point over the panel's part x > from (scene units).
double lit_by_panel(const Point& p, double from) {
  const double x0 = std::clamp(from, -kSide / 2, kSide / 2) - p.x, x1 = kSide / 2 - p.x;
  const double y0 = -kSide / 2 - p.y, y1 = kSide / 2 - p.y;
  return (cosine_integral(x1, y1, kHeight) - cosine_integral(x0, y1, kHeight) -
          cosine_integral(x1, y0, kHeight) + cosine_integral(x0, y0, kHeight)) /
         (kSide * kSide);
}

struct Errors {
  double largest = 0, largest_bound = 0;
  int beyond = 0;  ///< pixels further off than their bound and `slack`
};

Errors compared(const Rendering& ours, const auto& truth, double slack) {
  Errors errors;
  for (int y = 0; y < ours.whole.height; ++y) {
    for (int x = 0; x < ours.whole.width; ++x) {
      const double error = std::fabs(ours.whole.at(x, y).x - truth(x, y));
      errors.largest = std::max(errors.largest, error);
      errors.largest_bound = std::max(errors.largest_bound, ours.bound.at(x, y).x);
      errors.beyond += error > ours.bound.at(x, y).x + slack;
    }
  }
  return errors;
}

TEST(Certified, IsTheClosedFormWhereNothingIsInTheWay) {
  const Scene scene = under_a_ceiling_panel(24);
  const auto truth = [&](int x, int y) { return 0.8 * lit_by_panel(floor_point(scene, x, y), -9); };
  const Errors coarse = compared(render(scene, certified(4)), truth, 1e-14);
  const Errors fine = compared(render(scene, certified(256)), truth, 1e-14);
  EXPECT_EQ(coarse.beyond + fine.beyond, 0);
  EXPECT_LT(fine.largest, 1e-7);
  EXPECT_LT(fine.largest_bound, 1e-4) << "the bound says nearly as much";
}

TEST(Certified, IsTheClosedFormInThePenumbraOfAStraightEdge) {
  Scene scene = under_a_ceiling_panel(48);
  const Box shelf{{-50, -50, 1}, {0.1, 50, 1.3}};
  scene.objects.push_back({"shelf", shelf, 0, false});
  const auto truth = [&](int x, int y) {
    const Point p = floor_point(scene, x, y);
    double from = -9;
    for (const double z : {shelf.min.z, shelf.max.z})
      from = std::max(from, p.x + (shelf.max.x - p.x) * kHeight / z);
    return 0.8 * lit_by_panel(p, from);
  };
  for (const int n : {1, 2, 4, 8, 16, 32, 64, 128}) {
    const Errors errors = compared(render(scene, certified(n)), truth, 1e-13);
    EXPECT_EQ(errors.beyond, 0) << n;
    EXPECT_LT(errors.largest, 0.01 / (n * n)) << n << ": it falls at least like n^-2";
  }
  const auto wrong = [&](int x, int y) { return truth(x, y) * 1.1; };
  EXPECT_GT(compared(render(scene, certified(32)), wrong, 1e-13).beyond, 100) << "the control";
}

/// A sphere of radius 0.05 that no corner sample of 16 a side sees from the middle of the floor.
Scene with_tiny_occluder() {
  Scene scene = under_a_ceiling_panel(5);
  scene.camera.height = 0.2;
  std::get<AreaLight>(scene.lights[0].shape).width = 4;
  std::get<AreaLight>(scene.lights[0].shape).height = 4;
  // Between the samples at x, y = -+2/15.
  scene.objects.push_back({"mote", Sphere{{0, 0, 2}, 0.05}, 0, false});
  return scene;
}

TEST(Certified, FindsAnOccluderThatHidesBetweenCornerSamplesAtEveryN) {
  const Scene scene = with_tiny_occluder();
  const Picture truth = render(scene, {.sampler = Sampler::Centres, .area_samples = 500}).whole;
  const auto exact = [&](int x, int y) { return truth.at(x, y).x; };
  Scene empty = scene;
  empty.objects.pop_back();
  const auto missed = [&](const RenderOptions& options) {
    return std::fabs(render(scene, options).whole.at(2, 2).x -
                     render(empty, options).whole.at(2, 2).x);
  };
  EXPECT_EQ(missed({.sampler = Sampler::Corners, .area_samples = 16}), 0) << "it hides well";
  for (int n = 1; n <= 64; n *= 2) {
    EXPECT_GT(missed(certified(n)), 4e-4) << n;
    const Errors errors = compared(render(scene, certified(n)), exact, 1e-5);
    EXPECT_EQ(errors.beyond, 0) << n;
    if (n >= 8) {
      EXPECT_LT(errors.largest, 1e-4) << n;
    }
  }
}

/// Spheres, a box and a smooth mesh, glossy and attenuated; small, for time.
Scene stage() {
  Scene scene = load_scene(find_scene("x4-area"));
  scene.width = 24, scene.height = 18;
  return scene;
}

TEST(Certified, KeepsItsBoundOnAWholeSceneAndConverges) {
  const Scene scene = stage();
  const Picture truth = render(scene, {.sampler = Sampler::Centres, .area_samples = 192}).whole;
  const double own_error = 3e-4;  // of that grid, which falls like n^(-3/2)
  double last = 1;
  for (const int n : {2, 4, 8, 16, 32}) {
    const Rendering ours = render(scene, certified(n));
    const Errors errors = compared(
        ours, [&](int x, int y) { return truth.at(x, y).x; }, own_error);
    EXPECT_EQ(errors.beyond, 0) << n;
    EXPECT_LT(errors.largest, std::max(last / 3, own_error)) << n;
    last = errors.largest;
  }
}

/// A few objects anywhere between a floor and a panel, around and behind it too.
Scene random_stage(std::mt19937_64& engine) {
  const auto random = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto point = [&](double low, double high) {
    return Point{random(-2, 2), random(-2, 2), random(low, high)};
  };
  Scene scene = floor_from_above(10);
  scene.materials[0].specular = Color(0.5), scene.materials[0].shininess = random(1, 60);
  for (int i = 0; i < 3; ++i)
    scene.objects.push_back(
        {"ball", Sphere{point(0, 3), random(0.05, 0.8)}, 0, random(0, 1) < 0.5});
  const Point corner = point(0, 2);
  scene.objects.push_back(
      {"box", Box{corner, corner + Point{random(0.1, 1.5), random(0.1, 1), random(0.1, 2)}}, 0,
       true});
  Mesh mesh;
  for (int i = 0; i < 5; ++i) mesh.vertices.push_back(point(0.2, 2.5));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 2, 3}, {2, 3, 4}};
  scene.objects.push_back({"mesh", mesh, 0, random(0, 1) < 0.5});
  AreaLight area;
  area.point.origin = point(1.5, 4);
  if (random(0, 1) < 0.5) area.normal = Vector(0, 0, -1);
  area.width = random(0.1, 2), area.height = random(0.1, 2);
  scene.lights = {make_light(area, "panel")};
  return scene;
}

TEST(Certified, KeepsItsBoundAmongRandomObjects) {
  std::mt19937_64 engine(3);
  int partly = 0, control = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Scene scene = random_stage(engine);
    const Picture truth = render(scene, {.sampler = Sampler::Centres, .area_samples = 100}).whole;
    const auto exact = [&](int x, int y) { return truth.at(x, y).x; };
    // An edge along a row of the grid's samples may be off by half a row of 0.8 + 0.5.
    const double own_error = 1.3 / 200;
    for (const int n : {1, 2, 8}) {
      const Errors errors = compared(render(scene, certified(n)), exact, own_error);
      EXPECT_EQ(errors.beyond, 0) << trial << ", n = " << n;
      partly += n == 8 && errors.largest_bound > 1e-6;
    }
    scene.objects.erase(scene.objects.begin() + 1);
    control += compared(render(scene, certified(8)), exact, own_error).beyond;
  }
  EXPECT_GT(partly, 30);
  EXPECT_GT(control, 100) << "a ball less is beyond the bound";
}

TEST(Certified, SplitsIntoThirdsFirstForNumbersInBetween) {
  const Scene scene = stage();
  const auto error = [&, truth = render(scene, certified(64)).whole](int n) {
    double squares = 0;
    const Picture picture = render(scene, certified(n)).whole;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
      squares += std::pow(picture.pixels[i].x - truth.pixels[i].x, 2);
    return squares;
  };
  EXPECT_LT(error(6), error(4));
  EXPECT_EQ(error(5), error(6)) << "the next number that there is";
}

TEST(Certified, TracesRaysThatGrowSlowerThanN) {
  const Scene scene = stage();
  const auto rays = [&](int n) {
    const Rendering one = render(scene, certified(n));
    return double(one.area_rays + one.area_evaluations);
  };
  EXPECT_LT(rays(64) / rays(16), 4) << "n grew by 4, the grid's rays by 16";
}

}  // namespace
}  // namespace litmus

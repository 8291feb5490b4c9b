// autotune_test.cpp: what the tuner promises holds, and nothing that keeps the error is much
// cheaper.
#include "tracer/autotune.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/load.h"
#include "tests/tracer/scenes.h"
#include "tracer/area_sampling.h"
#include "tracer/pixel_lattice.h"

namespace litmus {
namespace {

constexpr double kBudgets[] = {1e-2, 1e-3, 1e-4};

Scene soft_shadow() {
  Scene scene = floor_from_above(24);
  scene.objects.push_back({"ball", Sphere{{0.1, 0.2, 1.2}, 0.6}, 0, true});
  AreaLight area;
  area.point.origin = {0.3, 0.5, 3};
  area.columns = area.rows = 4;
  scene.lights = {make_light(area, "panel")};
  return scene;
}

/// Every edge, and every edge of the shadow, lies along the pixels' sides and at a multiple of
/// 0.005: samples at such a distance miss none.
Scene block_and_shadow(int size) {
  Scene scene = floor_from_above(size);
  scene.objects.push_back({"block", Box{{-1, -1, 0.1}, {0.53, 0.77, 0.5}}, 0, true});
  scene.lights = {sun({-0.6, -0.35, -1})};
  scene.samples = 2;
  return scene;
}
int exact_samples(const Scene& scene) { return 2 * 1200 / scene.width; }

double error_against(const Scene& scene, const Picture& picture, const TuneSettings& truth) {
  return error_of(pixel_errors(picture, render(scene, truth, 0).whole), ErrorMetric::Max);
}

TEST(Tune, KeepsItsPromiseUnderAnAreaLight) {
  const Scene scene = soft_shadow();
  for (const double budget : kBudgets) {
    const Tuned tuned = tune(scene, {.max_error = budget});
    ASSERT_TRUE(tuned.met) << budget;
    EXPECT_LE(tuned.error, budget);
    // A truth by another sampler, and far finer.
    EXPECT_LE(error_against(scene, tuned.rendering.whole, {Sampler::Certified, 256}), tuned.error);
  }
  const Picture grid = render(scene, {Sampler::Centres, 96}, 0).whole;
  const Tuned tuned = tune(scene, {.max_error = 1e-2});
  EXPECT_LE(error_of(pixel_errors(tuned.rendering.whole, grid), ErrorMetric::Max), 1e-2);
}

TEST(Tune, KeepsItsPromiseOnEveryCanonicalScene) {
  int area_scenes = 0;
  for (Scene& scene : load_canonical_scenes().scenes) {
    scene.height = std::max(1, 12 * scene.height / scene.width), scene.width = 12;
    const bool area = integrates_area_lights(scene);
    area_scenes += area;
    ASSERT_FALSE(area && scene.samples > 1) << scene.name << " needs a truth of both";
    const TuneSettings truth{area ? Sampler::Certified : Sampler::Scene, area ? 256 : 0};
    const Picture exact =
        scene.samples > 1 ? lattice_mean(scene, 120, 0) : render(scene, truth, 0).whole;
    for (const double budget : kBudgets) {
      const Tuned tuned = tune(scene, {.max_error = budget, .threads = 1});
      EXPECT_EQ(tuned.met, tuned.error <= budget) << scene.name;
      EXPECT_TRUE(tuned.met || scene.samples > 1) << scene.name << " within " << budget;
      EXPECT_LE(error_of(pixel_errors(tuned.rendering.whole, exact), ErrorMetric::Max), tuned.error)
          << scene.name << " within " << budget << ": " << words(tuned.settings);
    }
  }
  EXPECT_GE(area_scenes, 5);
}

TEST(Tune, ChoosesNothingThatAnotherSettingBeatsByFar) {
  const Scene scene = soft_shadow();
  const Tuned tuned = tune(scene, {.max_error = 1e-2, .threads = 1});
  for (const Tried& other : tuned.tried) {
    if (other.error <= 1e-2) {
      EXPECT_GE(other.seconds, tuned.seconds) << words(other.settings);
    }
  }
  EXPECT_GT(tuned.tried.size(), 5u);
}

TEST(Tune, ClimbsTheGridInEachPrecision) {
  const Tuned tuned = tune(soft_shadow(), {.max_error = 1e-2, .threads = 1});
  for (const Precision precision : {Precision::Double, Precision::Float}) {
    EXPECT_GT(std::ranges::count_if(tuned.tried,
                                    [&](const Tried& one) {
                                      return one.settings.sampler == Sampler::Centres &&
                                             one.settings.precision == precision;
                                    }),
              2)
        << precision_name(precision);
  }
}

TEST(Tune, FiltersPixelsAsFarAsItMust) {
  const Scene scene = block_and_shadow(16);
  const Tuned tuned = tune(scene, {.max_error = 0.15});
  ASSERT_TRUE(tuned.met);
  EXPECT_GT(tuned.settings.pixel_samples, 1);
  EXPECT_LE(error_against(scene, tuned.rendering.whole, {Sampler::Scene, 0, exact_samples(scene)}),
            tuned.error);
}

TEST(Tune, JudgesByALatticeWhereTheFinestGridIsTooCoarse) {
  const Scene scene = block_and_shadow(8);
  const Tuned tuned = tune(scene, {.max_error = 3e-3});
  ASSERT_TRUE(tuned.met) << "two grids of 128 and 256 samples along a pixel differ by more";
  EXPECT_LE(error_against(scene, tuned.rendering.whole, {Sampler::Scene, 0, exact_samples(scene)}),
            tuned.error);
}

TEST(Tune, SaysSoIfTheErrorCannotBeKept) {
  const Scene scene = block_and_shadow(16);
  const Tuned tuned = tune(scene, {.max_error = 1e-6});
  EXPECT_FALSE(tuned.met);
  EXPECT_GT(tuned.error, 1e-6);
  EXPECT_EQ(tuned.rendering.whole.pixels.size(), 256u) << "the best picture is still there";
}

TEST(Tune, HasOnlyThePrecisionWhereTheModelIsExact) {
  Scene scene = floor_from_above(16);
  scene.lights = {bulb({0.5, 0.3, 2}, {2, 0.5, 0.5})};
  for (const double budget : kBudgets) EXPECT_TRUE(tune(scene, {.max_error = budget}).met);
  const Tuned strict = tune(scene, {.max_error = 1e-8});
  EXPECT_EQ(strict.settings.precision, Precision::Double) << "float is 1e-7 off";
  for (const Tried& tried : strict.tried) EXPECT_EQ(tried.settings.area_samples, 0);
}

TEST(ErrorOf, IsTheWorstTheNinetyNinthAndTheRootMeanSquare) {
  std::vector<double> errors(200, 0.0);
  errors[3] = 0.5, errors[7] = 0.25, errors[11] = 0.125;
  EXPECT_EQ(error_of(errors, ErrorMetric::Max), 0.5);
  EXPECT_EQ(error_of(errors, ErrorMetric::P99), 0.125) << "198 of 200 keep it";
  EXPECT_NEAR(error_of(errors, ErrorMetric::Rms), std::sqrt((0.25 + 0.0625 + 0.015625) / 200),
              1e-15);
}

}  // namespace
}  // namespace litmus

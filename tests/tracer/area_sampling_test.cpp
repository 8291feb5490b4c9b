// area_sampling_test.cpp: where samples lie, and what cannot be sampled.
#include "tracer/area_sampling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/refusal.h"
#include "tests/tracer/scenes.h"

namespace litmus {
namespace {

constexpr Sampler kPointSamplers[] = {Sampler::Centres, Sampler::Corners, Sampler::Gauss,
                                      Sampler::Jittered, Sampler::R2};

Scene with_panel() {
  Scene scene = floor_from_above(16);
  scene.objects.push_back({"ball", Sphere{{0.3, 0.2, 1.2}, 0.5}, 0, true});
  AreaLight area;
  area.point.origin = {0.3, 0.5, 3};
  area.width = 1.5;
  area.columns = area.rows = 3;
  scene.lights = {make_light(area, "panel")};
  return scene;
}

TEST(LightSamples, LieOnTheRectangleAndShareItsWholeWeight) {
  for (const Sampler sampler : kPointSamplers) {
    for (const int n : {1, 2, 5, 16}) {
      const auto samples = light_samples(sampler, n, 7);
      EXPECT_EQ(samples.size(), std::size_t(n * n));
      double total = 0, mean_u = 0;
      for (const LightSample& sample : samples) {
        EXPECT_LE(std::fabs(sample.u), 0.5) << sampler_name(sampler);
        EXPECT_LE(std::fabs(sample.v), 0.5) << sampler_name(sampler);
        total += sample.weight, mean_u += sample.weight * sample.u;
      }
      EXPECT_NEAR(total, 1, 1e-13) << sampler_name(sampler);
      if (n == 16) {
        EXPECT_NEAR(mean_u, 0, 0.02) << sampler_name(sampler);
      }
    }
  }
}

TEST(LightSamples, DependOnThePixelOnlyWhereTheyAreScattered) {
  for (const Sampler sampler : kPointSamplers) {
    const auto one = light_samples(sampler, 4, 1), again = light_samples(sampler, 4, 1),
               other = light_samples(sampler, 4, 2);
    const bool scattered = sampler == Sampler::Jittered || sampler == Sampler::R2;
    EXPECT_EQ(one[5].u, again[5].u);
    EXPECT_EQ(one[5].u != other[5].u, scattered) << sampler_name(sampler);
  }
}

TEST(RenderWithSampler, ReplacesTheGridOfTheScene) {
  Scene scene = with_panel();
  const Picture asked = render(scene, {.sampler = Sampler::Corners, .area_samples = 5}).whole;
  AreaLight& area = std::get<AreaLight>(scene.lights[0].shape);
  area.columns = area.rows = 5;
  area.placement = Placement::Corners;
  EXPECT_EQ(asked.pixels, render(scene).whole.pixels);
}

TEST(RenderWithSampler, ComesToTheSameLightWithEverySampler) {
  const Scene scene = with_panel();
  const Picture grid = render(scene, {.sampler = Sampler::Centres, .area_samples = 48}).whole;
  for (const Sampler sampler :
       {Sampler::Gauss, Sampler::Jittered, Sampler::R2, Sampler::Certified}) {
    const Picture other = render(scene, {.sampler = sampler, .area_samples = 48}).whole;
    double mean = 0;
    for (std::size_t i = 0; i < grid.pixels.size(); ++i)
      mean += std::fabs(other.pixels[i].x - grid.pixels[i].x) / double(grid.pixels.size());
    EXPECT_LT(mean, 3e-4) << sampler_name(sampler);
  }
}

TEST(RenderWithSampler, DoesNotDependOnThreads) {
  const Scene scene = with_panel();
  for (const Sampler sampler : {Sampler::Jittered, Sampler::Certified}) {
    const RenderOptions one{.threads = 1, .sampler = sampler, .area_samples = 4};
    const RenderOptions many{.threads = 0, .sampler = sampler, .area_samples = 4};
    EXPECT_EQ(render(scene, one).whole.pixels, render(scene, many).whole.pixels);
  }
}

TEST(RenderWithSampler, RefusesWhatItCannotDo) {
  Scene scene = with_panel();
  EXPECT_THROW(render(scene, {.precision = Precision::Quad, .sampler = Sampler::Certified}),
               Refusal);
  scene.shading = Shading::SampleCode;
  EXPECT_THROW(render(scene, {.sampler = Sampler::R2}), Refusal);
  EXPECT_NO_THROW(render(scene, {.sampler = Sampler::Centres, .area_samples = 2}));
}

}  // namespace
}  // namespace litmus

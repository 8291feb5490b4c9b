// bounded_test.cpp: relations between pictures that hold up to a stated rounding error.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/relations/moved_scene.h"
#include "tracer/render.h"

namespace litmus {
namespace {

const std::vector<Scene>& bounded_scenes() {
  static const std::vector<Scene> all = small_canonical_scenes(24);
  return all;
}

/// The largest difference over the pixels that both pictures decide alike, relative to the
/// brightest pixel, and how many they do not decide alike.
struct Distance {
  double largest = 0;
  int flipped = 0;
};

Distance distance(const Rendering& a, const Rendering& b) {
  Distance result;
  double brightest = 1e-300;
  for (const glm::dvec3& p : a.whole.pixels) brightest = std::max({brightest, p.x, p.y, p.z});
  for (std::size_t i = 0; i < a.whole.pixels.size(); ++i) {
    bool alike = true;
    for (std::size_t k = 0; k < a.signatures.size(); ++k)
      alike = alike && a.signatures[k].values[i] == b.signatures[k].values[i];
    if (!alike) {
      ++result.flipped;
      continue;
    }
    for (int c = 0; c < 3; ++c)
      result.largest = std::max(result.largest,
                                std::fabs(a.whole.pixels[i][c] - b.whole.pixels[i][c]) / brightest);
  }
  return result;
}

// the error of a few hundred roundings; exponents of shininess multiply it.
TEST(BoundedRelations, ScalingByThreeMovesTheLastDigitsOnly) {
  for (const Scene& scene : bounded_scenes()) {
    Motion three = scaling(0);
    three.by = 3;
    const Distance d = distance(render(scene), render(moved(scene, three)));
    EXPECT_LE(d.largest, 1e-12) << scene.name;
    EXPECT_EQ(d.flipped, 0) << scene.name;
  }
}

// coordinates near 1000 have lost ten bits.
TEST(BoundedRelations, TranslationByAThousandCostsTenBits) {
  for (const Scene& scene : bounded_scenes()) {
    const Distance d = distance(render(scene), render(moved(scene, translation(0x1p10))));
    EXPECT_LE(d.largest, 1e-9) << scene.name;
    // At this size the edges of the chart's tiles pass through 32 pixel centres: a tie, which
    // flips.
    EXPECT_LE(d.flipped, scene.name.starts_with("w2-") ? 32 : 0) << scene.name;
  }
}

//
TEST(BoundedRelations, AQuarterTurnMovesTheLastDigitsOnly) {
  for (const Scene& scene : bounded_scenes()) {
    Scene turned = moved(scene, quarter_turn());
    // A vertical panel has its axes from the x axis, which does not turn along.
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      auto* area = std::get_if<AreaLight>(&turned.lights[i].shape);
      if (area && !area->right && area->normal->x == 0 && area->normal->y == 0)
        area->right = Vector(0, 1, 0);
    }
    const Distance d = distance(render(scene), render(turned));
    EXPECT_LE(d.largest, 1e-12) << scene.name;
    EXPECT_EQ(d.flipped, 0) << scene.name;
  }
}

// A pixel's lights added in another order, or each rendered alone.
TEST(BoundedRelations, LightsAddUp) {
  for (const Scene& scene : bounded_scenes()) {
    const Rendering all = render(scene);
    Picture sum(scene.width, scene.height);
    for (std::size_t i = 0; i <= scene.lights.size(); ++i) {
      Scene alone = scene;
      alone.lights.clear();
      if (i < scene.lights.size()) {
        alone.lights.push_back(scene.lights[i]);
        alone.lights[0].ambient = Color(0);
        if (scene.shading == Shading::Equation) alone.ambient = Color(0);
      } else {
        for (const Light& light : scene.lights) alone.ambient += light.intensity * light.ambient;
        if (scene.shading == Shading::SampleCode) continue;
      }
      const Picture one = render(alone).whole;
      for (std::size_t p = 0; p < sum.pixels.size(); ++p) sum.pixels[p] += one.pixels[p];
    }
    for (std::size_t p = 0; p < sum.pixels.size(); ++p) {
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(sum.pixels[p][c], all.whole.pixels[p][c], 1e-14 * (1 + all.whole.pixels[p][c]))
            << scene.name;
    }
  }
}

bool has_box(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& o) { return std::holds_alternative<Box>(o.shape); });
}

TEST(BoundedRelations, AnyTurnMovesTheLastDigitsOnly) {
  int turned = 0;
  for (const Scene& scene : bounded_scenes()) {
    if (has_box(scene)) continue;  // boxes stay along the axes
    Scene other = moved(scene, rotation(0.7));
    for (Light& light : other.lights) {
      auto* area = std::get_if<AreaLight>(&light.shape);
      if (area && !area->right && std::hypot(area->normal->x, area->normal->y) == 0)
        area->right = Vector(std::cos(0.7), std::sin(0.7), 0);
    }
    const Distance d = distance(render(scene), render(other));
    EXPECT_LE(d.largest, 1e-11) << scene.name;
    EXPECT_EQ(d.flipped, 0) << scene.name;
    ++turned;
  }
  EXPECT_GT(turned, 10);
}

// 29 bits between float and double, seen through the error of each.
TEST(BoundedRelations, FloatIsAsFarFromQuadAsItsDigitsSay) {
  double in_float = 0, in_double = 0;
  for (const Scene& scene : bounded_scenes()) {
    if (scene.objects.size() > 8) continue;
    Scene tiny = scene;
    tiny.width = tiny.height = 8;
    const Rendering quad = render(tiny, {Precision::Quad});
    in_float = std::max(in_float, distance(quad, render(tiny, {Precision::Float})).largest);
    in_double = std::max(in_double, distance(quad, render(tiny)).largest);
  }
  EXPECT_GT(std::log2(in_float / in_double), 25);
  EXPECT_LT(std::log2(in_float / in_double), 33);
}

}  // namespace
}  // namespace litmus

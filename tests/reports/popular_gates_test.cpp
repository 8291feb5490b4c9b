// popular_gates_test.cpp: what the gates of other projects let pass, side by side with litmus's
// own.
//
// Prints a table: reports_tests --gtest_filter='PopularGates.*'
//
// The gates, from the sources of their projects:
//   Blender       tests/python/modules/render_report.py: fails if more than 1 % of the pixels
//   differ
//                 by more than 0.016; on sRGB code values there, here on linear values too
//   model-viewer  packages/render-fidelity-tools: fails over -22 dB, the mean of pixelmatch's
//   squared
//                 YIQ distance over its largest value 35215 (Kotsarenko and Ramos 2010), 8-bit sRGB
//   Mitsuba       tests/test_renders.py: per pixel and channel a z-test at 1 % after Sidak,
//   variances
//                 at least 1e-4; passes where 99.75 % of the tests pass; 2e6 samples a picture
// The z-test and litmus's test for noisy pictures see a path-traced candidate: a sample's standard
// deviation is the pixel's value.
#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <iostream>
#include <numbers>
#include <random>
#include <set>

#include "compare/difference.h"
#include "compare/regions.h"
#include "compare/statistics.h"
#include "compare/tolerances.h"
#include "compare/verdict.h"
#include "scene/load.h"
#include "tracer/render.h"

namespace litmus {
namespace {

constexpr int kSize = 256;

/// One light of each type over glossy objects, every exponent 64, no light with an ambient part.
Scene stage() {
  Scene scene = load_scene(find_scene("x5"));
  scene.width = scene.height = kSize;
  for (Material& material : scene.materials) material.shininess = 64;
  for (Light& light : scene.lights) light.ambient = Color(0);
  return scene;
}

// ---- The gates of others -----------------------------------------------------------------------

double encoded(double v) {
  v = std::clamp(v, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

Picture code_values(const Picture& picture) {
  Picture result = picture;
  for (glm::dvec3& pixel : result.pixels)
    for (int c = 0; c < 3; ++c) pixel[c] = std::round(255 * encoded(pixel[c])) / 255;
  return result;
}

bool blender_fails(const Picture& ours, const Picture& theirs) {
  std::size_t over = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    const glm::dvec3 d = glm::abs(ours.pixels[i] - theirs.pixels[i]);
    over += std::max({d.x, d.y, d.z}) > 0.016;
  }
  return double(over) > 0.01 * double(ours.pixels.size());
}

double yiq_decibels(const Picture& ours, const Picture& theirs) {
  double sum = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    const glm::dvec3 d = 255.0 * (ours.pixels[i] - theirs.pixels[i]);
    const double y = 0.29889531 * d.x + 0.58662247 * d.y + 0.11448223 * d.z;
    const double in_phase = 0.59597799 * d.x - 0.2741761 * d.y - 0.32180189 * d.z;
    const double quadrature = 0.21147017 * d.x - 0.52261711 * d.y + 0.31114694 * d.z;
    sum += 0.5053 * y * y + 0.299 * in_phase * in_phase + 0.1957 * quadrature * quadrature;
  }
  return 10 * std::log10(sum / double(ours.pixels.size()) / 35215);
}

constexpr double kSamples = 2e6 / (kSize * kSize);  // a pixel

double sample_variance(double value) { return std::max(value * value, 1e-4); }

/// The picture as a path tracer with so many samples a pixel would give it.
Picture noisy(const Picture& picture, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Picture result = picture;
  for (glm::dvec3& pixel : result.pixels)
    for (int c = 0; c < 3; ++c)
      pixel[c] += std::sqrt(sample_variance(pixel[c]) / kSamples) * normal(random);
  return result;
}

bool mitsuba_fails(const Picture& ours, const Picture& theirs) {
  std::mt19937_64 random(1);
  const Picture rendered = noisy(ours, random);
  const double tests = 3.0 * double(ours.pixels.size());
  const double alpha = -std::expm1(std::log1p(-0.01) / tests);
  const double limit = gsl_cdf_ugaussian_Qinv(alpha / 2);
  double passed = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double expected = theirs.pixels[i][c];
      passed += std::abs(rendered.pixels[i][c] - expected) *
                    std::sqrt(kSamples / sample_variance(expected)) <
                limit;
    }
  return passed < 0.9975 * tests;
}

// ---- litmus ------------------------------------------------------------------------------------

/// The light types whose layer is out of tolerance inside, as the study compares them.
std::set<std::string> named_by_litmus(const Rendering& ours, const Rendering& theirs) {
  const Tolerance tolerance = find_tolerance("blender", Region::Interior);
  std::set<std::string> types;
  for (std::size_t k = 0; k < ours.layers.size(); ++k) {
    const Difference d =
        difference(ours.layers[k].picture, theirs.layers[k].picture, edge_mask(ours.signatures[k]),
                   Region::Interior, tolerance.max_abs);
    if (!judge(d, tolerance).pass) types.insert(ours.layers[k].light_type);
  }
  return types;
}

Picture grey(Picture picture) {
  for (glm::dvec3& v : picture.pixels) v = glm::dvec3(0.2126 * v.x + 0.7152 * v.y + 0.0722 * v.z);
  return picture;
}

bool litmus_samples_fail(const Picture& ours, const Picture& theirs) {
  std::mt19937_64 random(2);
  std::vector<Picture> a, b;
  for (int seed = 0; seed < kEnoughSeeds; ++seed) {
    a.push_back(grey(noisy(ours, random)));
    b.push_back(grey(noisy(theirs, random)));
  }
  SampleOptions options;
  options.shuffles = 399;
  return compare_samples(a, b, options).p <= kAlpha;
}

// ---- The defects -------------------------------------------------------------------------------

Light& light_of(Scene& scene, std::string_view type) {
  return *std::find_if(scene.lights.begin(), scene.lights.end(),
                       [&](const Light& light) { return light_type(light) == type; });
}

Rendering brighter(std::string_view type) {
  Scene scene = stage();
  light_of(scene, type).intensity *= 1.01;
  return render(scene);
}

Rendering sharper() {
  Scene scene = stage();
  for (Material& material : scene.materials) material.shininess = 66;
  return render(scene);
}

Rendering wider() {
  Scene scene = stage();
  std::get<SpotLight>(light_of(scene, "spot").shape).cutoff += 0.5 * std::numbers::pi / 180;
  return render(scene);
}

Rendering shifted() {
  RenderOptions options;
  options.shift_x = 0.5;
  return render(stage(), options);
}

/// The layers changed by `change`, added up again.
template <class Change>
Rendering changed(Rendering rendering, Change change) {
  for (Layer& layer : rendering.layers) change(layer);
  rendering.whole = sum(rendering.layers);
  return rendering;
}

Rendering with_ambient(const Rendering& right) {
  return changed(right, [](Layer& layer) {
    if (layer.light_type == "ambient")
      for (glm::dvec3& pixel : layer.picture.pixels) pixel += 0.015;
  });
}

Rendering with_blemish(const Rendering& right) {
  return changed(right, [](Layer& layer) {
    if (layer.light_type != "area") return;
    for (int y = 200; y < 212; ++y)
      for (int x = 120; x < 132; ++x) layer.picture.at(x, y) += 0.3;
  });
}

Rendering with_gamma(const Rendering& right) {
  return changed(right, [](Layer& layer) {
    for (glm::dvec3& pixel : layer.picture.pixels)
      pixel = glm::pow(glm::max(pixel, 0.0), glm::dvec3(1 / 2.2));
  });
}

struct Defect {
  std::string name;
  Rendering rendering;
  std::set<std::string> types;  ///< the lights that it is in
  std::string caught;           ///< by which of the five popular columns and litmus's noisy test
};

std::string row_of(const Defect& defect, const Rendering& right, std::string& caught,
                   std::set<std::string>& named) {
  const Picture &ours = defect.rendering.whole, &theirs = right.whole;
  const double decibels = yiq_decibels(code_values(ours), code_values(theirs));
  const bool found[] = {blender_fails(ours, theirs),
                        blender_fails(code_values(ours), code_values(theirs)), decibels > -22,
                        mitsuba_fails(ours, theirs), litmus_samples_fail(ours, theirs)};
  named = named_by_litmus(defect.rendering, right);
  caught.clear();
  for (const bool each : found) caught += each ? 'x' : '-';
  const bool wrong = !defect.types.empty();
  const auto word = [&](bool each) { return each ? "found" : wrong ? "MISSED" : "passes"; };
  return fmt::format("{:<24} {:<9} {:<9} {:<6} {:>5.1f} dB  {:<8} {:<10} {}\n", defect.name,
                     word(found[0]), word(found[1]), word(found[2]), decibels, word(found[3]),
                     word(found[4]),
                     named.empty() ? std::string(word(false))
                                   : "found: " + fmt::format("{}", fmt::join(named, ", ")));
}

TEST(PopularGates, MissWhatLitmusFindsAndNames) {
  const Rendering right = render(stage());
  const std::set<std::string> all{"directional", "point", "spot", "area"};
  std::set<std::string> and_ambient = all;
  and_ambient.insert("ambient");
  const Defect defects[] = {
      {"none", right, {}, "-----"},
      {"ambient +0.015", with_ambient(right), {"ambient"}, "-x-xx"},
      {"exponent 66 for 64", sharper(), all, "-----"},
      {"sun +1 %", brighter("directional"), {"directional"}, "----x"},
      {"point +1 %", brighter("point"), {"point"}, "-----"},
      {"spot +1 %", brighter("spot"), {"spot"}, "----x"},
      {"area +1 %", brighter("area"), {"area"}, "----x"},
      {"cutoff +0.5 degrees", wider(), {"spot"}, "xx--x"},
      {"12 x 12 blemish", with_blemish(right), {"area"}, "----x"},
      {"half-pixel shift", shifted(), all, "xx-xx"},
      {"gamma 2.2 for linear", with_gamma(right), and_ambient, "xxxxx"},
  };
  std::string table = fmt::format("{:<24} {:<9} {:<9} {:<16} {:<8} {:<10} {}\n", "", "Blender",
                                  "Blender", "model-viewer", "Mitsuba", "litmus", "litmus, light");
  table += fmt::format("{:<24} {:<9} {:<9} {:<16} {:<8} {:<10} {}\n", "defect", "linear", "sRGB",
                       "-22 dB", "z-test", "--samples", "by light");
  for (const Defect& defect : defects) {
    std::string caught;
    std::set<std::string> named;
    table += row_of(defect, right, caught, named);
    EXPECT_EQ(named, defect.types) << defect.name;
    EXPECT_EQ(caught, defect.caught) << defect.name;
  }
  std::cout << table;
}

}  // namespace
}  // namespace litmus

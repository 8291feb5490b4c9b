// explain_test.cpp: an explanation says what the picture shows, and why.
#include "tracer/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <random>
#include <set>

#include "scene/bands.h"
#include "scene/load.h"
#include "scene/refusal.h"
#include "tests/tracer/scenes.h"
#include "tracer/render.h"

namespace litmus {
namespace {

constexpr double kSumTolerance = 1e-12;  // of a sum of a few dozen numbers up to 1, in double

double largest(const glm::dvec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Slide 5 from the numbers of an explanation alone.
glm::dvec3 added_up(const Explanation& pixel) {
  glm::dvec3 total = pixel.material.ambient * pixel.ambient;
  for (const LightExplanation& light : pixel.lights) {
    double d = 0, s = 0;
    for (const LampExplanation& lamp : light.lamps) {
      if (lamp.gate != Gate::Open) continue;
      d += lamp.visibility * lamp.linear * lamp.quadratic * lamp.decay * lamp.l_dot_n;
      s += lamp.visibility * lamp.linear * lamp.quadratic * lamp.decay * lamp.power;
    }
    total += pixel.material.diffuse * light.light_diffuse * (d * light.weight) +
             pixel.material.specular * light.light_specular * (s * light.weight);
  }
  return total;
}

struct Error {
  double whole = 0, layers = 0, equation = 0;
  int unequal_products = 0;  ///< lamps whose factors do not give the kernel's product exactly
};

/// The largest errors over seeded random pixels of a scene.
Error largest_error(const Scene& explained, const Rendering& rendering, int pixels) {
  std::mt19937 random(20);
  std::uniform_int_distribution<int> across(0, explained.width - 1), down(0, explained.height - 1);
  const Explainer explain_pixel = explainer(explained);
  Error error;
  for (int i = 0; i < pixels; ++i) {
    const Explanation pixel = explain_pixel(across(random), down(random));
    const auto shown = [&](const Picture& picture) { return picture.at(pixel.x, pixel.y); };
    error.whole = std::max(error.whole, largest(pixel.picture - shown(rendering.whole)));
    for (std::size_t k = 0; k < pixel.layers.size(); ++k) {
      error.layers =
          std::max(error.layers, largest(pixel.layers[k] - shown(rendering.layers[k].picture)));
    }
    error.equation = std::max(error.equation, largest(added_up(pixel) - pixel.whole));
    for (const LightExplanation& light : pixel.lights) {
      error.unequal_products +=
          int(std::count_if(light.lamps.begin(), light.lamps.end(), [](const auto& lamp) {
            return lamp.attenuation * lamp.decay != lamp.intensity;
          }));
    }
  }
  return error;
}

TEST(Explain, SumsToThePictureOnAThousandPixelsOfEveryCanonicalScene) {
  const std::vector<Scene> all = load_canonical_scenes().scenes;
  ASSERT_GE(all.size(), 30u);
  for (const Scene& whole : all) {
    for (const Scene& scene : whole.spectra ? band_scenes(whole) : std::vector{whole}) {
      const Error error = largest_error(scene, render(scene), 1000);
      EXPECT_LE(error.whole, kSumTolerance) << scene.name;
      EXPECT_LE(error.layers, kSumTolerance) << scene.name;
      if (scene.shading == Shading::Equation) {
        EXPECT_LE(error.equation, kSumTolerance) << scene.name;
      }
      EXPECT_EQ(error.unequal_products, 0) << scene.name;
    }
  }
}

TEST(Explain, NoticesAPictureOfAnotherScene) {
  const Scene scene = load_scene(find_scene("x5"));
  Scene other = scene;
  other.lights[1].intensity *= 1 + 1e-9;
  const Error error = largest_error(scene, render(other), 1000);
  EXPECT_GT(error.whole, kSumTolerance);
  EXPECT_GT(error.layers, kSumTolerance);
}

TEST(Explain, GivesTheNumbersOfSlides11And16) {
  Scene scene = floor_from_above(3);  // the middle pixel shows (0, 0, 0)
  scene.materials[0] = {"gloss", Color(1), Color(0.5), Color(0.25), 10};
  scene.lights = {make_light(SpotLight{{{3, 0, 4}, {2, 0.5, 0.25}}, {-3, 0, -2}, 1, 3}, "spot")};
  scene.lights[0].intensity = 2;
  const Explanation pixel = explain(scene, 1, 1);
  const LampExplanation& lamp = pixel.lights.at(0).lamps.at(0);
  EXPECT_DOUBLE_EQ(lamp.distance, 5);
  EXPECT_DOUBLE_EQ(lamp.x, 2.5);
  EXPECT_DOUBLE_EQ(lamp.linear, 2 / (2 + 0.5 * 5));
  EXPECT_DOUBLE_EQ(lamp.quadratic, 4 / (4 + 0.25 * 25));
  const double alpha = std::acos((9 + 8) / (5 * std::sqrt(13)));
  EXPECT_NEAR(lamp.alpha, alpha, 1e-15);
  EXPECT_NEAR(lamp.decay, 1 - std::pow(alpha, 3), 1e-15);
  EXPECT_DOUBLE_EQ(lamp.l_dot_n, 0.8);
  EXPECT_NEAR(lamp.h_dot_n, 1.8 / std::sqrt(0.6 * 0.6 + 1.8 * 1.8), 1e-15);
  EXPECT_NEAR(lamp.power, std::pow(lamp.h_dot_n, 10), 1e-15);
  EXPECT_NEAR(pixel.picture.x,
              2 * lamp.linear * lamp.quadratic * lamp.decay * (0.5 * 0.8 + 0.25 * lamp.power),
              1e-15);
  EXPECT_EQ(lamp.gate, Gate::Open);
}

TEST(Explain, SaysWhatIsSeen) {
  Scene scene = floor_from_above(3);
  scene.objects.push_back({"ball", Sphere{{0, 0, 1}, 0.5}, 0, true});
  const Explanation pixel = explain(scene, 1, 1);
  EXPECT_TRUE(pixel.hit);
  EXPECT_EQ(pixel.object, 1);
  EXPECT_EQ(pixel.material.name, "matte");
  EXPECT_DOUBLE_EQ(pixel.t, 8.5);
  EXPECT_EQ(pixel.point, glm::dvec3(0, 0, 1.5));
  EXPECT_EQ(pixel.normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(pixel.e, glm::dvec3(0, 0, 1));
}

TEST(Explain, NamesTheObjectThatIsInTheWay) {
  Scene scene = floor_from_above(3);
  scene.objects.push_back({"lid", Box{{-1, -1, 2}, {1, 1, 2.1}}, 0, false});
  scene.lights = {sun({0, 0, -1}), bulb({0, 0, 1})};
  const Explanation pixel = explain(scene, 1, 1);
  const LampExplanation &far = pixel.lights[0].lamps[0], &near = pixel.lights[1].lamps[0];
  EXPECT_EQ(far.blocker, 1);
  EXPECT_EQ(far.visibility, 0);
  EXPECT_EQ(far.gate, Gate::Blocked);
  EXPECT_EQ(far.diffuse, 0);
  EXPECT_EQ(near.blocker, -1);
  EXPECT_EQ(near.visibility, 1);
}

TEST(Explain, NamesASpheresOwnFarSideAsTheBlocker) {
  Scene scene = seen_from_above(3);
  scene.objects.push_back({"ball", Sphere{{0, 0, 0}, 1}, 0, true});
  scene.lights = {sun({0, 0, 1})};
  const LampExplanation lamp = explain(scene, 1, 1).lights[0].lamps[0];
  EXPECT_EQ(lamp.gate, Gate::Behind);
  EXPECT_EQ(lamp.blocker, 0);
}

TEST(Explain, FindsNoBlockerInASceneWithoutShadows) {
  Scene scene = floor_from_above(3);
  scene.objects.push_back({"lid", Box{{-1, -1, 2}, {1, 1, 2.1}}, 0, false});
  scene.lights = {sun({0, 0, -1})};
  scene.shadows = false;
  EXPECT_EQ(explain(scene, 1, 1).lights[0].lamps[0].gate, Gate::Open);
}

TEST(Explain, TellsALightBehindFromOnePastTheCutoffAndFromOneThatIsUsedUp) {
  Scene scene = floor_from_above(3);
  const auto spot = [](const Vector& direction, double exponent) {
    return make_light(SpotLight{{{0, 0, 3}, {}}, direction, 0.2, exponent}, "spot");
  };
  scene.lights = {bulb({0, 0, -1}), spot({1, 0, -1}, 1), spot({0, 0, -1}, 0)};
  const Explanation pixel = explain(scene, 1, 1);
  EXPECT_EQ(pixel.lights[0].lamps[0].gate, Gate::Behind);
  EXPECT_EQ(pixel.lights[1].lamps[0].gate, Gate::OutsideCone);
  EXPECT_EQ(pixel.lights[2].lamps[0].gate, Gate::NoLight);
}

TEST(Explain, ShowsEachSampleOfAnAreaLight) {
  Scene scene = floor_from_above(3);
  AreaLight area;
  area.point.origin = {0, 0, 2};
  area.columns = 2, area.rows = 1;
  scene.lights = {make_light(area, "panel")};
  const LightExplanation light = explain(scene, 1, 1).lights[0];
  ASSERT_EQ(light.lamps.size(), 2u);
  EXPECT_DOUBLE_EQ(mean(light, &LampExplanation::distance), std::sqrt(4 + 0.25 * 0.25));
  EXPECT_DOUBLE_EQ(light.diffuse, (light.lamps[0].diffuse + light.lamps[1].diffuse) / 2);
}

TEST(Explain, ExplainsTheCentreAndShowsTheMeanOfSeveralSamples) {
  Scene scene = floor_from_above(2);
  scene.lights = {bulb({0.4, 0.3, 1})};
  scene.samples = 4;
  const Explanation pixel = explain(scene, 1, 0);
  EXPECT_EQ(pixel.samples, 4);
  EXPECT_EQ(pixel.point, glm::dvec3(1.5, 1.5, 0));
  EXPECT_EQ(pixel.picture, render(scene).whole.at(1, 0));
  EXPECT_GT(largest(pixel.picture - pixel.whole), 1e-3);
}

TEST(Explain, AddsUpTheSampleCodesReading) {
  Scene scene = load_scene(find_scene("x5"));
  scene.shading = Shading::SampleCode;
  const Rendering rendering = render(scene);
  EXPECT_LE(largest_error(scene, rendering, 1000).whole, kSumTolerance);
  const Explanation pixel = explain(scene, 120, 90);
  ASSERT_TRUE(pixel.hit);
  EXPECT_EQ(pixel.ambient_color, glm::dvec3(0));
  glm::dvec3 total{0};
  for (const LightExplanation& light : pixel.lights) {
    EXPECT_EQ(light.light_specular, light.light_diffuse);
    total += light.ambient_color + light.diffuse_color + light.specular_color;
  }
  EXPECT_LE(largest(total - rendering.whole.at(120, 90)), kSumTolerance);
}

TEST(Explain, SeesNothingInTheBackground) {
  Scene scene = seen_from_above(3);
  scene.lights = {bulb({0, 0, 1})};
  const Explanation pixel = explain(scene, 0, 0);
  EXPECT_FALSE(pixel.hit);
  EXPECT_EQ(pixel.picture, glm::dvec3(0));
  EXPECT_EQ(pixel.layers.size(), 2u);
}

TEST(Explain, RefusesAPixelOutsideAndNamesTheRange) {
  Scene scene = floor_from_above(8);
  scene.height = 5;
  for (const auto& [x, y] : {std::pair{8, 0}, {0, 5}, {-1, 0}, {0, -1}}) {
    try {
      explain(scene, x, y);
      FAIL() << x << ", " << y;
    } catch (const Refusal& refusal) {
      EXPECT_THAT(refusal.what(), testing::HasSubstr("x from 0 to 7 and y from 0 to 4"));
    }
  }
}

// ---- Pictures of terms -----------------------------------------------------------------------

const TermPicture* find(const std::vector<TermPicture>& pictures, std::string_view light,
                        std::string_view term) {
  for (const TermPicture& picture : pictures) {
    if (picture.light == light && picture.term == term) return &picture;
  }
  return nullptr;
}

/// The picture from terms and materials, as the header says.
Picture recombined(const Scene& scene, const std::vector<TermPicture>& pictures) {
  Picture result(scene.width, scene.height);
  const std::vector<int> objects = objects_seen(scene);
  Color ambient = scene.ambient;
  for (const Light& light : scene.lights) ambient += light.intensity * light.ambient;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i] < 0) continue;
    const Material& material =
        scene.materials[std::size_t(scene.objects[std::size_t(objects[i])].material)];
    result.pixels[i] = material.ambient * ambient;
    for (const Light& light : scene.lights) {
      const TermPicture* diffuse = find(pictures, light.name, "diffuse");
      const TermPicture* specular = find(pictures, light.name, "specular");
      const auto at = [&](const TermPicture* p) { return p ? double(p->values[i]) : 0; };
      result.pixels[i] += light.intensity * (material.diffuse * light.diffuse * at(diffuse) +
                                             material.specular * light.specular * at(specular));
    }
  }
  return result;
}

TEST(TermPictures, RecombineToThePicture) {
  constexpr double kHalfStep = 6e-8;  // of a float below 1; every term is rounded to one
  for (const char* name : {"x5", "c2", "a1", "r2", "p4", "n1"}) {
    const Scene scene = load_scene(find_scene(name));
    const Picture whole = render(scene).whole, again = recombined(scene, term_pictures(scene));
    const double rounded = 2 * double(scene.lights.size());  // diffuse and specular
    double worst = 0;
    for (std::size_t i = 0; i < whole.pixels.size(); ++i)
      worst = std::max(worst, largest(whole.pixels[i] - again.pixels[i]));
    EXPECT_LE(worst, rounded * kHalfStep + kSumTolerance) << name;
  }
}

TEST(TermPictures, GiveDiffuseAsTheProductOfItsFactors) {
  const Scene scene = load_scene(find_scene("s5"));
  const auto pictures = term_pictures(scene);
  const std::string light = scene.lights[0].name;
  const auto at = [&](std::string_view term, std::size_t i) {
    const TermPicture* picture = find(pictures, light, term);
    return picture ? double(picture->values[i]) : 1;
  };
  int lit = 0;
  for (std::size_t i = 0; i < pictures[0].values.size(); ++i) {
    const double product = at("visibility", i) * at("l", i) * at("q", i) * at("decay", i) *
                           std::max(at("l.n", i), 0.0);
    ASSERT_NEAR(at("diffuse", i), product, 1e-6);  // six numbers, each rounded to a float
    lit += product > 0;
  }
  EXPECT_GT(lit, 100);
}

TEST(TermPictures, HoldOnlyWhatEachLightHas) {
  Scene scene = floor_from_above(4);
  scene.lights = {sun({0, 0, -1}), bulb({0, 0, 1}, {1, 0.5, 0}),
                  make_light(SpotLight{{{0, 0, 3}, {}}, {0, 0, -1}, 0.5, 1}, "spot")};
  const auto names = [&] {
    std::set<std::string> all;
    for (const TermPicture& picture : term_pictures(scene)) {
      EXPECT_EQ(picture.values.size(), 16u);
      all.insert(picture.light + ":" + std::string(picture.term));
    }
    return all;
  };
  EXPECT_EQ(names(), (std::set<std::string>{"sun:l.n", "sun:visibility", "sun:diffuse", "lamp:d",
                                            "lamp:l", "lamp:l.n", "lamp:visibility", "lamp:diffuse",
                                            "spot:d", "spot:alpha", "spot:decay", "spot:l.n",
                                            "spot:visibility", "spot:diffuse"}));
  scene.materials[0].specular = Color(0.5);
  scene.shadows = false;
  scene.lights.resize(1);
  EXPECT_EQ(names(), (std::set<std::string>{"sun:l.n", "sun:h.n", "sun:power", "sun:diffuse",
                                            "sun:specular"}));
}

TEST(StopPictures, AgreeWithTheExplanationOfEachPixel) {
  for (const char* name : {"x5", "r3", "s10"}) {
    const Scene scene = load_scene(find_scene(name));
    const std::vector<StopPicture> pictures = stop_pictures(scene);
    const Explainer explain_at = explainer(scene);
    std::set<Gate> seen;
    int blocked = 0;
    for (int i = 0; i < scene.width * scene.height; i += 37) {
      const Explanation pixel = explain_at(i % scene.width, i / scene.width);
      for (std::size_t k = 0; k < pixel.lights.size(); ++k) {
        const std::vector<LampExplanation>& lamps = pixel.lights[k].lamps;
        const auto is_blocked = [](const auto& lamp) { return lamp.gate == Gate::Blocked; };
        const auto first = std::find_if(lamps.begin(), lamps.end(), is_blocked);
        const Gate gate = pictures[k].gates[std::size_t(i)];
        ASSERT_EQ(pictures[k].blockers[std::size_t(i)], first == lamps.end() ? -1 : first->blocker);
        blocked += first != lamps.end();
        seen.insert(gate);
        if (gate == Gate::Open) continue;
        for (const LampExplanation& lamp : lamps) ASSERT_EQ(lamp.gate, gate);
      }
    }
    EXPECT_GT(blocked, 0) << name;
    EXPECT_TRUE(seen.contains(Gate::Blocked)) << name;
  }
}

TEST(TermPictures, AreZeroWhereNothingIsSeen) {
  Scene scene = seen_from_above(9);
  scene.objects.push_back({"ball", Sphere{{0, 0, 0}, 1}, 0, true});
  scene.lights = {bulb({0, 0, 3})};
  const auto pictures = term_pictures(scene);
  EXPECT_EQ(find(pictures, "lamp", "d")->values[0], 0);
  EXPECT_EQ(find(pictures, "lamp", "d")->values[4 * 9 + 4], 2);
  EXPECT_EQ(objects_seen(scene)[0], -1);
  EXPECT_EQ(objects_seen(scene)[4 * 9 + 4], 0);
}

}  // namespace
}  // namespace litmus

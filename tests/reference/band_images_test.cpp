// band_images_test.cpp: references of spectral scenes, three bands a picture.
#include "reference/band_images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "reference/stored_images.h"
#include "scene/load.h"
#include "scene/observer.h"
#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

/// Two lights, four bands: two pictures.
Scene spectral_scene(const std::string& name = "two") {
  Scene scene;
  scene.name = name;
  scene.width = scene.height = 2;
  scene.materials.push_back({"matte"});
  scene.objects.push_back({"ball", Sphere{}, 0, true});
  scene.lights = {{"sun", DirectionalLight{}}, {"lamp", PointLight{{0, 0, 3}, {}}}};
  const std::vector<double> ones(4, 1), none(4);
  scene.spectra = Spectra{4,
                          none,
                          {{ones, {.1, .2, .3, .4}, none}},
                          {{none, ones, ones}, {none, {4, 3, 2, 1}, ones}},
                          std::vector<glm::dvec3>(4, glm::dvec3(1, 0.5, 0.25))};
  return scene;
}

/// A renderer whose every pixel of a light is the material's diffuse colour times the light's.
Driver product_driver(std::vector<std::string>* rendered = nullptr) {
  return {.name = "product",
          .title = "Product",
          .package = "",
          .revision = 1,
          .find =
              [] {
                return Installation{"/bin/true", "1.0"};
              },
          .source = [](const Scene& scene) { return fingerprint(scene); },
          .render =
              [rendered](const Installation&, std::span<const Scene> scenes,
                         const ReferenceOptions&, const ResultSink& sink) {
                for (const Scene& scene : scenes) {
                  if (rendered) rendered->push_back(scene.name);
                  ReferenceResult result;
                  result.scene = scene.name, result.seconds = 1;
                  Picture black(scene.width, scene.height);
                  result.layers.push_back({"ambient", "ambient", black});
                  for (const Light& light : scene.lights) {
                    Picture flat = black;
                    for (glm::dvec3& p : flat.pixels)
                      p = scene.materials[0].diffuse * light.diffuse;
                    result.layers.push_back({light.name, std::string(light_type(light)), flat});
                  }
                  sink(std::move(result));
                }
              }};
}

ObtainOptions live(const ScratchFolder& folder) {
  ObtainOptions options;
  options.sources = Sources::Live;
  options.reference.work = folder.path();
  return options;
}

TEST(ExpectedLayers, OfASpectralSceneAreThoseOfEachPictureUnderNamesOfTheirOwn) {
  const Layers layers = expected_layers(spectral_scene());
  ASSERT_EQ(layers.size(), 6u);
  EXPECT_EQ(layers[0].light, "ambient 380-680 nm");
  EXPECT_EQ(layers[2].light, "lamp 380-680 nm");
  EXPECT_EQ(layers[5].light, "lamp 680-780 nm");
  EXPECT_EQ(layers[5].light_type, "point");
  std::set<std::string> names;
  for (const Layer& layer : layers) names.insert(layer.light);
  EXPECT_EQ(names.size(), layers.size());
}

TEST(SpectralReference, IsRenderedThreeBandsAtATime) {
  const ScratchFolder folder;
  const Scene scenes[] = {spectral_scene("one"), spectral_scene("two")};
  std::vector<std::string> rendered;
  const auto results = obtain(scenes, product_driver(&rendered), live(folder));
  EXPECT_EQ(rendered, (std::vector<std::string>{"one-00", "one-01", "two-00", "two-01"}));
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[1].scene, "two");
  EXPECT_EQ(results[1].source, "live");
  EXPECT_EQ(results[1].seconds, 2);
  EXPECT_EQ(misfit(scenes[1], results[1].layers), "");
  const std::vector<Layers> bands = band_layers(scenes[1], results[1].layers);
  ASSERT_EQ(bands.size(), 2u);
  const glm::dvec3 lamp = bands[0][2].picture.at(1, 1);
  EXPECT_NEAR(lamp.r, .1 * 4, 1e-7);
  EXPECT_NEAR(lamp.g, .2 * 3, 1e-7);
  EXPECT_NEAR(lamp.b, .3 * 2, 1e-7);
  EXPECT_NEAR(bands[1][2].picture.at(1, 1).r, .4 * 1, 1e-7);
  EXPECT_EQ(bands[1][2].picture.at(1, 1).g, 0);
}

TEST(SpectralReference, FailsAsAWholeWhereOnePictureFails) {
  const ScratchFolder folder;
  Driver driver = product_driver();
  const auto render = driver.render;
  driver.render = [render](const Installation& installed, std::span<const Scene> scenes,
                           const ReferenceOptions& options, const ResultSink& sink) {
    render(installed, scenes, options, [&](ReferenceResult result) {
      if (result.scene == "two-01") result.failure = "out of paint", result.layers.clear();
      sink(std::move(result));
    });
  };
  const Scene scene = spectral_scene();
  const ObtainedReference result = obtain({&scene, 1}, driver, live(folder)).front();
  EXPECT_EQ(result.failure, "out of paint");
  EXPECT_EQ(result.source, "");
  EXPECT_TRUE(result.layers.empty());
}

TEST(SpectralReference, IsStoredAndReadBackAsOneImage) {
  const ScratchFolder folder;
  const Scene scene = spectral_scene();
  const ObtainedReference made = obtain({&scene, 1}, product_driver(), live(folder)).front();
  save_stored(scene, "product", {made.layers, made.version, "", 1}, folder.path());
  const StoredLookup found = load_stored(scene, "product", folder.path());
  ASSERT_TRUE(found.images.has_value()) << found.reason;
  for (std::size_t k = 0; k < made.layers.size(); ++k)
    EXPECT_EQ(found.images->layers[k].picture.pixels, made.layers[k].picture.pixels);
  Scene other = scene;
  other.spectra->lights[0].diffuse[2] = 0.5;
  EXPECT_THAT(load_stored(other, "product", folder.path()).reason, HasSubstr("another version"));
}

TEST(ColorsOf, AreWhatTheObserverSees) {
  const ScratchFolder folder;
  const Scene scene = spectral_scene();
  const ObtainedReference made = obtain({&scene, 1}, product_driver(), live(folder)).front();
  const Layers colors = colors_of(scene, made.layers);
  ASSERT_EQ(colors.size(), 3u);
  // All bands look alike to this observer: .1*4 + .2*3 + .3*2 + .4*1 of each.
  const glm::dvec3 expected = linear_srgb(2.0 * glm::dvec3(1, 0.5, 0.25));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(colors[2].picture.at(0, 0)[c], expected[c], 1e-6);
  EXPECT_THROW(band_layers(scene, colors), std::invalid_argument);
}

}  // namespace
}  // namespace litmus

// bands_test.cpp: a spectral scene as RGB scenes of three bands, and the colours made of them.
#include "scene/bands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/observer.h"
#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::ElementsAre;

/// kScratchScene with a spectrum for its material and one for its lamp.
std::string spectral_text(const std::string& bands) {
  std::string text = replaced(kScratchScene, "diffuse = 0.8", "diffuse = \"paint\"");
  text = replaced(text, "color = [1, 0.9, 0.8]", "color = \"A\"");
  return replaced(text, "[image]",
                  bands + "\n[spectra]\npaint = { samples = [[400, 0.2], [700, 0.8]] }\n[image]");
}

Scene spectral_scene(const std::string& bands = "bands = 4") {
  const ScratchFolder folder;
  return load_scene(folder.write("scene.toml", spectral_text(bands)));
}

TEST(BandScenes, HoldThreeNeighbouringBandsEach) {
  const Scene scene = spectral_scene();
  const std::vector<Scene> threes = band_scenes(scene);
  ASSERT_EQ(threes.size(), 2u);
  const std::vector<double>& paint = scene.spectra->materials[0].diffuse;
  EXPECT_EQ(threes[0].materials[0].diffuse, Color(paint[0], paint[1], paint[2]));
  EXPECT_EQ(threes[1].materials[0].diffuse, Color(paint[3], 0, 0));
  EXPECT_EQ(threes[0].ambient, Color(0.1));
  EXPECT_EQ(threes[1].ambient, Color(0.1, 0, 0));
  EXPECT_EQ(threes[0].lights[0].specular, three_bands(band_means(illuminant_a(), 4), 0));
  EXPECT_FALSE(threes[0].spectra.has_value());
  EXPECT_EQ(threes[0].name, "scene-00");
  EXPECT_EQ(threes[0].lights[0].intensity, scene.lights[0].intensity);
}

TEST(BandRange, SaysWhatThePictureCovers) {
  const Spectra spectra = *spectral_scene("").spectra;
  EXPECT_EQ(spectra.bands, 40);
  EXPECT_EQ(band_pictures(spectra), 14);
  EXPECT_EQ(band_range(spectra, 0), "380-410 nm");
  EXPECT_EQ(band_range(spectra, 13), "770-780 nm");
}

TEST(SrgbLayers, AreTheSumOverBandsOfWhatTheObserverSees) {
  const Spectra spectra = *spectral_scene().spectra;
  Picture first(1, 1), second(1, 1);
  first.at(0, 0) = {1, 2, 3}, second.at(0, 0) = {4, 0, 0};
  const std::vector<Layers> pictures{{{"ambient", "ambient", first}},
                                     {{"ambient", "ambient", second}}};
  const glm::dvec3 expected = linear_srgb(spectra.xyz[0] + 2.0 * spectra.xyz[1] +
                                          3.0 * spectra.xyz[2] + 4.0 * spectra.xyz[3]);
  const glm::dvec3 color = srgb_layers(spectra, pictures)[0].picture.at(0, 0);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], expected[c], 1e-14);
  EXPECT_THROW(srgb_layers(spectra, std::span(pictures).first(1)), std::invalid_argument);
}

}  // namespace
}  // namespace litmus

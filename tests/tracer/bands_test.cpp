// bands_test.cpp: one tracing for all wavelengths gives what a rendering of each band gives.
#include "tracer/bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <tuple>

#include "scene/bands.h"
#include "scene/load.h"
#include "scene/observer.h"
#include "tests/largest_difference.h"
#include "tests/tracer/scenes.h"

namespace litmus {
namespace {

/// Bands that differ from each other, from scene to scene and from colour to colour.
std::vector<double> uneven(int bands, double seed) {
  std::vector<double> values;
  for (int b = 0; b < bands; ++b) values.push_back(0.5 + 0.45 * std::sin(seed + 1.7 * b));
  return values;
}

/// The scene with spectra for all that its RGB colours are not 0 for.
Scene with_bands(Scene scene, int bands = 7) {
  Spectra& spectra = scene.spectra.emplace();
  spectra.bands = bands;
  spectra.xyz = band_xyz(gaussian_observer(), constant_spectrum(1), bands);
  double seed = 0;
  const auto paint = [&](const Color& color) {
    return color == Color(0) ? std::vector<double>(std::size_t(bands)) : uneven(bands, seed += 1.3);
  };
  spectra.ambient = paint(scene.ambient);
  for (const Material& m : scene.materials)
    spectra.materials.push_back({paint(m.ambient), paint(m.diffuse), paint(m.specular)});
  for (const Light& light : scene.lights)
    spectra.lights.push_back({paint(light.ambient), paint(light.diffuse), paint(light.specular)});
  return scene;
}

/// A canonical scene, small.
Scene canonical(const std::string& name, int width = 40) {
  Scene scene = load_scene(find_scene(name));
  scene.height = std::max(1, scene.height * width / scene.width);
  scene.width = width;
  return scene;
}

void expect_each_band(const Scene& scene) {
  const BandRendering all = render_bands(scene, {}, KeepBands::Layers);
  const std::vector<Scene> threes = band_scenes(scene);
  ASSERT_EQ(all.pictures.size(), threes.size());
  for (std::size_t p = 0; p < threes.size(); ++p) {
    const Rendering alone = render(threes[p]);
    ASSERT_EQ(all.pictures[p].size(), alone.layers.size());
    for (std::size_t k = 0; k < alone.layers.size(); ++k) {
      EXPECT_EQ(all.pictures[p][k].light, alone.layers[k].light);
      EXPECT_LE(largest_difference(all.pictures[p][k].picture, alone.layers[k].picture),
                1e-15 * 8)  // colours up to 4, a few roundings
          << threes[p].name << ", " << alone.layers[k].light;
    }
  }
}

TEST(Bands, AreWhatARenderingOfEachGives) {
  for (const char* name : {"x5", "a1", "c2", "d3", "n1"}) {
    SCOPED_TRACE(name);
    expect_each_band(with_bands(canonical(name, 24)));
  }
}

TEST(Bands, AreMeansOverTheSamplesOfAPixel) {
  Scene scene = with_bands(canonical("x5", 24));
  scene.samples = 3;
  expect_each_band(scene);
}

TEST(Bands, AreThoseOfTheSampleCodeToo) {
  Scene scene = with_bands(canonical("x5", 24));
  scene.ambient = Color(0.2);
  scene.spectra->ambient = uneven(7, 9);
  scene.shading = Shading::SampleCode;
  expect_each_band(scene);
}

TEST(Bands, MakeTheLayersAndTheWholeInSrgb) {
  const Scene scene = with_bands(canonical("x5"));
  const BandRendering all = render_bands(scene, {}, KeepBands::Layers);
  const Layers colors = srgb_layers(*scene.spectra, all.pictures);
  for (std::size_t k = 0; k < colors.size(); ++k)
    EXPECT_LT(largest_difference(colors[k].picture, all.rendering.layers[k].picture), 1e-14);
  EXPECT_LT(largest_difference(sum(colors), all.rendering.whole), 1e-14);
  EXPECT_EQ(largest_difference(render(scene).whole, all.rendering.whole), 0);
}

/// The rows of bands of a picture, one behind the other.
std::vector<float> rows_of(const Scene& scene, BandRendering* rendering = nullptr) {
  std::vector<float> values;
  int next = 0;
  BandRendering result = render_band_rows(scene, {}, [&](int first, std::span<const float> rows) {
    EXPECT_EQ(first, next);
    next += int(rows.size()) / (scene.width * (3 + scene.spectra->bands));
    values.insert(values.end(), rows.begin(), rows.end());
  });
  EXPECT_EQ(next, scene.height);
  if (rendering) *rendering = std::move(result);
  return values;
}

TEST(BandRows, AreThePictureAndItsBandsInSinglePrecision) {
  for (const int samples : {1, 2}) {
    Scene scene = with_bands(canonical("x5", 50));  // more rows than are handed over at a time
    scene.samples = samples;
    const BandRendering all = render_bands(scene, {}, KeepBands::Layers);
    BandRendering whole;
    const std::vector<float> values = rows_of(scene, &whole);
    EXPECT_EQ(largest_difference(whole.rendering.whole, all.rendering.whole), 0);
    EXPECT_EQ(whole.products, all.products);
    const std::size_t channels = std::size_t(3 + scene.spectra->bands);
    ASSERT_EQ(values.size(), all.rendering.whole.pixels.size() * channels);
    std::vector<Picture> bands;
    for (const Layers& three : all.pictures) bands.push_back(sum(three));
    for (std::size_t i = 0; i < all.rendering.whole.pixels.size(); ++i)
      for (std::size_t c = 0; c < channels; ++c) {
        const glm::dvec3& three =
            c < 3 ? all.rendering.whole.pixels[i] : bands[c / 3 - 1].pixels[i];
        ASSERT_NEAR(values[i * channels + c], three[int(c % 3)], 1e-6) << i << ", " << c;
      }
  }
}

TEST(BandRows, AreNotOfASceneWithoutSpectra) {
  EXPECT_THROW(render_band_rows(canonical("x5", 24), {}, [](int, auto) {}), std::invalid_argument);
}

TEST(Bands, HaveTheSignaturesAndFlagsOfTheScene) {
  Scene rgb = canonical("x5");
  const Rendering one = render(rgb), bands = render(with_bands(rgb));
  ASSERT_EQ(bands.signatures.size(), one.signatures.size());
  for (std::size_t k = 0; k < one.signatures.size(); ++k)
    EXPECT_EQ(bands.signatures[k].values, one.signatures[k].values);
  EXPECT_EQ(bands.flags, one.flags);
  rgb.samples = 2;
  EXPECT_EQ(render(with_bands(rgb)).flags, render(rgb).flags);
}

TEST(Bands, LeaveOutWhatTheOptionsDo) {
  const Scene scene = with_bands(canonical("x5"));
  RenderOptions bare;
  bare.layers = bare.edges = false;
  const Rendering whole = render(scene, bare);
  EXPECT_TRUE(whole.layers.empty() && whole.signatures.empty() && whole.flags.empty());
  EXPECT_EQ(whole.whole.pixels, render(scene).whole.pixels);
  bare.effects = all_effects();
  EXPECT_EQ(render(scene, bare).whole.pixels, whole.whole.pixels);
  RenderOptions dark;
  dark.effects = all_effects();
  dark.effects->ambient = false;
  const Rendering without = render(scene, dark), with = render(scene);
  EXPECT_EQ(largest_difference(without.layers[0].picture, Picture(scene.width, scene.height)), 0);
  EXPECT_GT(largest_difference(without.whole, with.whole), 0.001);
  EXPECT_EQ(without.layers[1].picture.pixels, with.layers[1].picture.pixels);
}

TEST(Bands, DoNotDependOnThreads) {
  const Scene scene = with_bands(canonical("x5"));
  EXPECT_EQ(largest_difference(render(scene, {Precision::Double, 1}).whole,
                               render(scene, {Precision::Double, 3}).whole),
            0);
}

TEST(Bands, ShiftWithTheCamera) {
  Scene scene = with_bands(canonical("x5", 24));
  RenderOptions moved;
  moved.shift_x = 0.25, moved.shift_y = -0.5;
  const BandRendering all = render_bands(scene, moved, KeepBands::Layers);
  const Rendering alone = render(band_scenes(scene)[1], moved);
  EXPECT_LT(largest_difference(sum(all.pictures[1]), alone.whole), 1e-14);
}

TEST(BandProbe, ShowsThePixelsOfThePicture) {
  const Scene scene = with_bands(canonical("x5", 24));
  const Rendering picture = render(scene);
  const std::vector<glm::dvec3> colors = probe(scene)(12.5, 10.5);
  ASSERT_EQ(colors.size(), picture.layers.size());
  for (std::size_t k = 0; k < colors.size(); ++k)
    EXPECT_LT(glm::length(colors[k] - picture.layers[k].picture.at(12, 10)), 1e-13);
}

// ---- Work ------------------------------------------------------------------------------------

TEST(SpectralWork, IsNoneForASceneWithoutSpectra) {
  for (Scene& scene : load_canonical_scenes().scenes) {
    const auto is_large = [](const Object& object) {
      const Mesh* mesh = std::get_if<Mesh>(&object.shape);
      return mesh &&
             mesh->triangles.size() > 1000;  // takes seconds to make ready, and tells no more
    };
    if (scene.spectra || std::any_of(scene.objects.begin(), scene.objects.end(), is_large))
      continue;
    scene.height = std::max(1, scene.height * 16 / scene.width), scene.width = 16;
    const BandRendering result = render_bands(scene, {}, KeepBands::Layers);
    EXPECT_EQ(result.products, 0) << scene.name;
    EXPECT_TRUE(result.pictures.empty()) << scene.name;
    EXPECT_EQ(largest_difference(result.rendering.whole, render(scene).whole), 0) << scene.name;
  }
}

TEST(SpectralWork, IsAProductPerTermAndBandThatIsKept) {
  Scene scene = floor_from_above(4);
  scene.lights = {sun({0, 0, -1})};
  scene.ambient = Color(1);
  const auto products = [&](KeepBands keep) {
    return render_bands(with_bands(scene, 42), {}, keep).products;
  };
  // 16 pixels: the picture's three products for the ambient layer and the light's, and per band the
  // ambient term and the diffuse one.
  EXPECT_EQ(products(KeepBands::None), 16 * 2 * 3);
  EXPECT_EQ(products(KeepBands::Layers), 16 * (2 * 3 + 2 * 42));
  scene.materials[0].specular = Color(1);
  EXPECT_EQ(products(KeepBands::Layers), 16 * (2 * 3 + 3 * 42));
  scene.lights[0].shape = DirectionalLight{{0, 0, 1}};  // from below
  EXPECT_EQ(products(KeepBands::Layers), 16 * (2 * 3 + 42));
}

// ---- The canonical scenes ----------------------------------------------------------------------

/// W2 is refused without the CIE's tables; the others then have other colours.
#define NEEDS_COLORD()                       \
  if (colord_file("ref/CIE-TCS.sp").empty()) \
  GTEST_SKIP() << kColordPackage << " is not installed: the scene's colours are not checked"

const Picture& layer(const Rendering& rendering, const std::string& light) {
  for (const Layer& one : rendering.layers)
    if (one.light == light) return one.picture;
  throw std::logic_error("no layer " + light);
}

TEST(W1Bands, AreIndependentOfEachOther) {
  Scene scene = load_scene(find_scene("w1"));
  const BandRendering before = render_bands(scene, {}, KeepBands::Layers);
  for (double* band : {&scene.spectra->lights[0].diffuse[1], &scene.spectra->lights[0].specular[1]})
    *band *= 2;
  const BandRendering after = render_bands(scene, {}, KeepBands::Layers);
  const Picture a = sum(before.pictures[0]), b = sum(after.pictures[0]);
  double changed = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    EXPECT_EQ(a.pixels[i].r, b.pixels[i].r);
    EXPECT_EQ(a.pixels[i].b, b.pixels[i].b);
    changed = std::max(changed, b.pixels[i].g - a.pixels[i].g);
  }
  EXPECT_GT(changed, 0.1);
}

/// Each tile under each light, as an integral over the wavelength in steps of 1 nm.
TEST(W2Chart, AtFortyBandsIsWithin15TenThousandthsOfTheIntegral) {
  NEEDS_COLORD();
  const Rendering rendering = render(load_scene(find_scene("w2")));
  const Observer observer = cie_1931_observer();
  const Spectrum white = illuminant("D65").spectrum;
  const std::vector<NamedSpectrum> tiles = read_spectra_file(colord_file("ref/CIE-TCS.sp"));
  // The light's name, its spectrum, and intensity times l.n on the tiles.
  const std::tuple<const char*, const char*, double> kLights[] = {
      {"daylight", "D65", 1}, {"lamp", "A", 0.5 * 0.8}, {"equal energy", "E", 0.25 * 0.8}};
  double worst = 0;
  for (const auto& [light, name, brightness] : kLights) {
    const Spectrum power = illuminant(name).spectrum;
    for (std::size_t tile = 0; tile < 8; ++tile) {
      glm::dvec3 sum(0);
      double luminance = 0;
      for (double nm = 380.5; nm < 780; ++nm) {
        const glm::dvec3 seen(value_at(observer.x, nm), value_at(observer.y, nm),
                              value_at(observer.z, nm));
        sum += seen * value_at(power, nm) * value_at(tiles[tile].spectrum, nm);
        luminance += seen.y * value_at(white, nm);
      }
      const glm::dvec3 expected = linear_srgb(sum / luminance);
      const int x = 6 + 12 * int(tile % 4), y = 6 + 12 * int(tile / 4);
      const glm::dvec3 shown = layer(rendering, light).at(x, y) / brightness;
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(shown[c] - expected[c]));
    }
  }
  EXPECT_LT(worst, 1.5e-3);
  EXPECT_GT(worst, 1e-5) << "bands are no integral";
  RecordProperty("largest", std::to_string(worst));
}

TEST(W3Sodium, HasOneChromaticityWhereverItShines) {
  const Rendering rendering = render(load_scene(find_scene("w3")));
  const glm::dvec3 first = rendering.whole.at(32, 44);
  ASSERT_GT(first.r, 0.01);
  int lit = 0;
  for (const glm::dvec3& pixel : rendering.whole.pixels) {
    if (pixel == glm::dvec3(0)) continue;
    ++lit;
    EXPECT_NEAR(pixel.g / pixel.r, first.g / first.r, 1e-13);
    EXPECT_NEAR(pixel.b / pixel.r, first.b / first.r, 1e-13);
  }
  EXPECT_GT(lit, 1000);
}

TEST(W4Metamers, AreEqualInDaylightAndDifferUnderALamp) {
  NEEDS_COLORD();
  const Rendering rendering = render(load_scene(find_scene("w4")));
  const auto apart = [&](const char* light) {
    const Picture& picture = layer(rendering, light);
    return glm::length(picture.at(12, 12) - picture.at(36, 12));
  };
  EXPECT_LT(apart("daylight"), 1e-7);
  EXPECT_GT(apart("lamp"), 0.03);
  EXPECT_GT(layer(rendering, "daylight").at(12, 12).g, 0.3);
}

}  // namespace
}  // namespace litmus

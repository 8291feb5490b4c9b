// band_rows_test.cpp: a row of a spectral scene is that of its worst three bands.
#include "reports/band_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compare/regions.h"

namespace litmus {
namespace {

/// A lit floor in six bands, two pictures of three, seen by both sides alike.
struct BandRows : testing::Test {
  Scene scene;
  BandSide ours;
  std::vector<Layers> theirs;
  CaseLayer layer;

  void SetUp() override {
    scene.width = scene.height = 8;
    scene.camera = {Projection::Orthographic, {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.7, 4};
    scene.materials.push_back({"matte"});
    scene.objects.push_back({"floor", Plane{}, 0, true});
    scene.lights.push_back({"sun", DirectionalLight{}});
    const std::vector<double> ones(6, 1), none(6);
    scene.spectra = Spectra{6,
                            none,
                            {{ones, {.1, .2, .3, .4, .5, .6}, none}},
                            {{none, ones, ones}},
                            std::vector<glm::dvec3>(6, glm::dvec3(1))};
    BandRendering rendering = render_bands(scene, {}, KeepBands::Layers);
    const Rendering& colors = rendering.rendering;
    layer = {"sun", "directional",  colors.layers[1].picture, edge_mask(colors.signatures[1]), {},
             {},    colors.flags[1]};
    ours = *band_side(scene, {}, rendering);
    theirs = ours.pictures;
  }
  Comparison row(const std::string& region, std::size_t index = 1) {
    for (Comparison& one : compare_bands(layer, index, ours, theirs, "povray"))
      if (one.region == region) return one;
    throw std::logic_error("no row of " + region);
  }
};

TEST_F(BandRows, PassWhereEveryBandAgrees) {
  for (const char* region : {"interior", "lit", "edge", "all"}) {
    EXPECT_EQ(row(region).verdict, "pass") << region;
    EXPECT_EQ(row(region).max_abs, 0) << region;
  }
}

TEST_F(BandRows, AreThoseOfTheWorstBands) {
  theirs[0][1].picture.at(2, 2).g += 1e-7;
  theirs[1][1].picture.at(5, 3).b += 3e-7;
  const Comparison interior = row("interior");
  EXPECT_EQ(interior.verdict, "pass");
  EXPECT_NEAR(interior.max_abs, 3e-7, 1e-15);
  EXPECT_EQ(interior.bands, "580-780 nm");
  EXPECT_EQ(interior.max_at, (std::array{5, 3}));
}

TEST_F(BandRows, FailWhereOneBandDoesThoughItsColourHides) {
  // Too much in one band and too little in the next: the observer of this test sees nothing.
  theirs[0][1].picture.at(2, 2).r += 1e-3;
  theirs[0][1].picture.at(2, 2).g -= 1e-3;
  for (const char* region : {"interior", "lit", "all"}) {
    EXPECT_EQ(row(region).verdict, "fail") << region;
    EXPECT_EQ(row(region).bands, "380-580 nm") << region;
  }
}

TEST_F(BandRows, OfTheWholeAddTheLayersUp) {
  layer.light = layer.light_type = "all";
  theirs[1][0].picture.at(4, 4).r += 1e-3;  // ambient, which is 0 for us
  EXPECT_EQ(row("all", 2).verdict, "fail");
  EXPECT_NEAR(row("interior", 2).max_abs, 1e-3, 1e-12);
}

TEST_F(BandRows, AreNotForASceneWithoutSpectra) {
  scene.spectra.reset();
  BandRendering rendering = render_bands(scene, {}, KeepBands::Layers);
  EXPECT_FALSE(band_side(scene, {}, rendering).has_value());
}

}  // namespace
}  // namespace litmus

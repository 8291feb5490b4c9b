// pixel_lattice_test.cpp: edges along the pixels' sides are met finely.
#include "tracer/pixel_lattice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracer/scenes.h"
#include "tracer/render.h"

namespace litmus {
namespace {

constexpr int kGridSamples = 4;

/// One pixel of side 6: the sun's light on all that lies left of x = edge, or below y = edge.
Scene half_seen(double edge, bool along_x) {
  Scene scene = seen_from_above(1);
  const Point end = along_x ? Point{edge, 9, 0} : Point{9, edge, 0};
  scene.objects.push_back({"slab", Box{{-9, -9, -1}, end}, 0, true});
  scene.lights = {sun({0, 0, -1})};
  return scene;
}

/// How far the share that is seen is off, in pixels.
double share_error(const Picture& picture, double edge) {
  constexpr double kSlab = 0.8;  // the material's diffuse colour
  return std::abs(picture.pixels[0].x / kSlab - (edge + 3) / 6);
}

TEST(LatticeMean, MeetsAnEdgeAlongEitherSideAsAGridOfSixteenTimesTheSamples) {
  double grid_worst = 0;
  for (double edge = -2.9; edge < 2.9; edge += 0.0371) {
    for (const bool along_x : {true, false}) {
      Scene scene = half_seen(edge, along_x);
      EXPECT_LE(share_error(lattice_mean(scene, kGridSamples, 1), edge),
                0.5 / (kLatticeGrids * kGridSamples) + 1e-12)
          << edge;
      scene.samples = kGridSamples;
      grid_worst = std::max(grid_worst, share_error(render(scene, {}).whole, edge));
    }
  }
  EXPECT_GT(grid_worst, 0.1) << "of the grid alone, 0.125 at most";
}

TEST(LatticeMean, IsThePictureItselfWhereNothingChangesWithinAPixel) {
  Scene scene = floor_from_above(4);
  scene.lights = {sun({0.3, 0.2, -1})};
  const Picture one = render(scene, {}).whole, mean = lattice_mean(scene, kGridSamples, 1);
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
    EXPECT_NEAR(mean.pixels[i].x, one.pixels[i].x, 1e-15);
}

}  // namespace
}  // namespace litmus

// pixel_lattice.cpp: grids of samples moved between each other.
#include "tracer/pixel_lattice.h"

#include "tracer/render.h"

namespace litmus {
namespace {

constexpr int kStride = 3;  // rows per column: prime to kLatticeGrids

}  // namespace

Picture lattice_mean(const Scene& scene, int n, int threads) {
  Scene changed = scene;
  changed.samples = n;
  // Of a pixel, from the grid's usual place, to both sides alike.
  const auto shift = [&](int k) { return ((k % kLatticeGrids + 0.5) / kLatticeGrids - 0.5) / n; };
  RenderOptions options{.threads = threads};
  options.layers = options.edges = false;
  Picture mean(scene.width, scene.height);
  for (int k = 0; k < kLatticeGrids; ++k) {
    options.shift_x = shift(k), options.shift_y = shift(kStride * k);
    const Picture one = render(changed, options).whole;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
      mean.pixels[i] += one.pixels[i] / double(kLatticeGrids);
  }
  return mean;
}

}  // namespace litmus

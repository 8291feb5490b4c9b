// contraction.h: terms of light times the colours of each wavelength band, rows at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/picture.h"
#include "tracer/band_answers.h"
#include "tracer/render.h"

namespace litmus {

/// Neighbouring terms other than 0 of a layer, and the colours per band that they multiply.
struct Stretch {
  std::size_t layer, x;
  std::size_t begin, end;  ///< in RowProducts::terms
  const ThreeBands* colors;
};

/// All that makes the bands of a row of pixels.
struct RowProducts {
  std::vector<double> terms;  ///< each the part of its pixel that its sample is
  std::vector<Stretch> stretches;
};

struct Contraction {
  const Scene& scene;
  /// Of every sample: the terms of each light (D in red, S in green, lamps in view in blue), and as
  /// the first layer the index of the object seen + 1, in red.
  const Rendering& geometry;
  const std::vector<BandAnswer>& answers;  ///< band_answers()
};

/// Writes the colours of row `y` of pixels, and appends what makes its bands to `products` unless
/// that is null. `colors` may be the geometry, since each layer's row is read before it is written.
/// Returns how many products the colours took.
std::int64_t contract_row(const Contraction& with, int y, Rendering& colors, RowProducts* products);

/// Adds three bands of the row, all layers together, to its pixels.
void multiply_row(const RowProducts& row, std::size_t picture, std::span<glm::dvec3> pixels);

/// Picture `picture` of three bands: each of `layers`, named and still without pixels. Row by row,
/// so that a pixel is written while it is near.
void multiply_bands(const std::vector<RowProducts>& rows, std::size_t picture, int width,
                    Layers& layers);

}  // namespace litmus

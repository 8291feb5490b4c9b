// shift_search.h: the shift between two pictures, by a search over whole pixels and Gauss-Newton
// steps.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/shift_equations.h"
#include "scene/picture.h"

namespace litmus {

inline constexpr std::size_t kFewestPixels = 64;  ///< that a shift can be told from

/// Where ours lies on theirs: theirs(p) is ours(centre + scale (p - centre) + shift).
struct Warp {
  double dx = 0, dy = 0, scale = 1;
};

/// Everything about the pair of pictures that does not change from step to step.
struct PicturePair {
  const Picture& ours;
  const Picture& theirs;
  std::vector<std::uint8_t> smooth;
  int stride;
  double noise;
};

/// How far the steps came.
struct ShiftFit {
  Warp warp;
  ShiftEquations normal;
  std::vector<ShiftObservation> seen;
  bool converged = false;
  double mean_error() const { return normal.error() / normal.weight; }
};

/// From where the pictures are, and from the best whole pixel if that is another one.
ShiftFit best_fit(const PicturePair& pair);

/// Steps from a start in the first `count` of dx, dy and scale.
ShiftFit refine(const PicturePair& pair, const Warp& start, std::size_t count);

/// The mean squared difference of the fit's pixels as the pictures are, with the fit's weights.
double error_before(const PicturePair& pair, const ShiftFit& fit);

}  // namespace litmus

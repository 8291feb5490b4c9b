// shift_equations.h: least squares for a shift and a scale, gain and offset of each channel being
// whatever fits best.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace litmus {

/// The terms of one channel of one pixel: theirs, the derivatives of ours by dx, dy and scale, and
/// ours - theirs. A constant 1 comes before them.
inline constexpr std::size_t kShiftTerms = 6, kFirstOfShift = 2;
using ShiftTerms = std::array<double, kShiftTerms>;
using ShiftMatrix = std::array<ShiftTerms, kShiftTerms>;

struct ShiftObservation {
  std::size_t pixel;  ///< index in theirs
  std::array<ShiftTerms, 3> channels;
  double weight = 1;
};

/// What the pixels say, gain and offset of each channel being whatever fits best.
struct ShiftEquations {
  ShiftMatrix m{};  ///< rows and columns from kFirstOfShift on: dx, dy, scale, ours - theirs
  std::array<std::array<double, 2>, 3> shading{};  ///< per channel: offset, gain - 1
  double weight = 0;                               ///< of all pixels
  double error() const { return std::max(0.0, m[kShiftTerms - 1][kShiftTerms - 1]); }
};

/// Sums the pixels up, with their weights.
ShiftEquations shift_equations(std::span<const ShiftObservation> seen);

/// The step that the equations ask for, in the first `count` of dx, dy and scale; nothing where
/// they do not determine one.
std::optional<std::array<double, 3>> shift_step(const ShiftEquations& equations, std::size_t count);

/// The squared gradients in the weakest and the strongest direction.
std::array<double, 2> gradient_strengths(const ShiftEquations& equations);

/// Lessens the weight of pixels that gain, offset and warp leave far off, such as those on a crease
/// that no mask knows (Geman and McClure's weights). The scale is the median over the pixels that
/// say anything about a shift, at least a few times `noise`, one sigma of theirs.
void reweigh(std::vector<ShiftObservation>& seen, const ShiftEquations& equations, double noise);

/// No renderer's picture is better than its floats.
inline constexpr double kFloatNoise = 1e-7;

}  // namespace litmus

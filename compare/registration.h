// registration.h: whether two pictures of a scene lie on top of each other, before anyone speaks of
// shading.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scene/picture.h"

namespace litmus {

/// Above this shift in pixels two pictures are not of one camera. Half a pixel, the commonest
/// mistake (corners taken for centres), is 25 times as much; exporters that agree stay below 1e-4.
inline constexpr double kLargestShift = 0.02;

/// The part of the difference that a shift has to explain before it is called one. A lamp, a cone
/// or an exponent that is off also moves brightness about the picture, but not all of it alike.
inline constexpr double kExplainedByShift = 0.95;

/// How far apart two pictures are. Ours is theirs moved by (dx, dy), x to the right and y down, in
/// pixels: ours(x, y) = theirs(x - dx, y - dy). (Sample points that are moved to the right by
/// RenderOptions::shift_x = 0.5 therefore give dx = -0.5.)
struct Registration {
  bool determined = false;  ///< false: the pictures do not say, and the figures below are not used
  double dx = 0, dy = 0;    ///< pixels
  double uncertainty = 0;   ///< of the shift in its worst direction, pixels, one sigma
  double scale = 1;         ///< ours is theirs magnified about the centre; 1 where undetermined
  double explained = 0;     ///< part of the squared difference that the shift takes away, 0 to 1
  std::int64_t pixels = 0;  ///< that were used
  std::string why;          ///< why it is not determined, else empty
};

/// Estimates the shift by Gauss-Newton steps on ours, interpolated by cubics (Lucas and Kanade
/// 1981), after a search over whole pixels up to kLargestSearch. Each channel has a gain and an
/// offset of its own, so that a wrong brightness is not taken for a shift; `explained` is measured
/// on what they leave over. Pixels within two of an edge are left out (`edge` as by edge_mask; may
/// be empty where pictures are smooth): a picture of one sample a pixel does not move there, it
/// flips. So are pixels that are not finite. `noise` is the error (one sigma) that theirs may have
/// anyway, as by quantisation.
///
/// Not determined where the pictures are constant, change in one direction only, or in a way that a
/// gain and an offset do as well (a ramp), where no shift is found but all that changes are creases
/// between flat pieces (facets, which look the same wherever they are), and where sizes differ.
Registration registration(const Picture& ours, const Picture& theirs,
                          std::span<const std::uint8_t> edge = {}, double noise = 0);

/// The search covers shifts of this many pixels each way.
inline constexpr int kLargestSearch = 6;

/// The part of the squared difference, 0 to 1, that goes away when ours is rendered once more with
/// its sample points moved onto theirs, over the pixels where `where` is not 0. It is exact where
/// interpolation is not: at edges. Gain, offset and `noise` as in `registration`. 0 where ours
/// differs by no more than the noise. The pictures have one size.
double explained_by_moving(const Picture& ours, const Picture& moved, const Picture& theirs,
                           std::span<const std::uint8_t> where, double noise = 0);

/// "unregistered: shifted by (-0.5, 0) px ..." where the shift is determined, over kLargestShift
/// and explains the difference; else empty.
std::string unregistered(const Registration& registration);

}  // namespace litmus

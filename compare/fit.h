// fit.h: the unit detective: by which factor, offset or encoding two pictures of one light differ.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scene/picture.h"

namespace litmus {

/// How ours depends on theirs, over the lit pixels' channels.
struct ShadingFit {
  bool determined = false;       ///< false: too few pixels are lit
  double gain = 1, offset = 0;   ///< ours = gain * theirs + offset; offset 0 where theirs is flat
  double unexplained = 1;        ///< what the line leaves of the typical |ours - theirs|
  bool has_slope = false;        ///< theirs varies enough for a slope
  double slope = 1;              ///< of log ours over log theirs: 1 for any factor, else a gamma
  double level = 1;              ///< ours = level * theirs^slope
  double curve_unexplained = 1;  ///< what that leaves of the typical |ours - theirs|
  std::int64_t samples = 0;      ///< pixels x channels that were used
};

/// Fits ours ~ gain * theirs + offset and log ours ~ slope * log theirs + log level, both by the
/// median of slopes between pairs (Theil 1950, Sen 1968) and a few reweighted least squares
/// (Tukey's biweight), so that one sample in five may be anything. The gain of pictures that differ
/// by a factor comes out to 0.1 % with 5 % of the samples spoiled. Lit: theirs over kLitPart of its
/// largest value (the 99.9th percentile); not on an edge (`edge` as by edge_mask, may be empty);
/// finite. Deterministic. The pictures have one size.
ShadingFit fit_shading(const Picture& ours, const Picture& theirs,
                       std::span<const std::uint8_t> edge = {});

inline constexpr double kLitPart = 0.01;

/// One sentence that names what one factor, offset or encoding would explain, such as "ours is
/// 3.1416 times theirs: a factor of pi, as when irradiance is taken for radiance"; empty where none
/// explains nearly all of the difference, or where there is none.
///
/// Named factors, recognised to kFactorSlack: pi, 1/pi, 4 pi, 1/(4 pi) (W against W/sr), 2 and 1/2;
/// curves: sRGB-encoded either way, and a gamma of 2.2 or 1/2.2.
std::string explain_units(const Picture& ours, const Picture& theirs,
                          std::span<const std::uint8_t> edge = {});

inline constexpr double kFactorSlack = 0.005;

}  // namespace litmus

// encoding.h: what an image file's encoding does to linear light: the rounding of its codes, and
// what a comparison can therefore not see.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/picture.h"

namespace litmus {

/// How a candidate's images hold linear light. A value of the image is `exposure` times the light,
/// so light = value / exposure.
struct Encoding {
  int bits = 0;       ///< 8 or 16: a PNG, code / (2^bits - 1); 0: 32-bit floats (EXR or PFM)
  bool srgb = false;  ///< the code is the sRGB transfer function of the value (IEC 61966-2-1)
  double exposure = 1;
};

/// The encodings by name, exposure 1: "float", "png16-linear", "png8-linear", "png16-srgb",
/// "png8-srgb".
inline constexpr std::array<std::pair<std::string_view, Encoding>, 5> kEncodings{{
    {"float", {}},
    {"png16-linear", {16, false}},
    {"png8-linear", {8, false}},
    {"png16-srgb", {16, true}},
    {"png8-srgb", {8, true}},
}};

/// The name in that table.
std::string_view name_of(const Encoding& encoding);

/// sRGB code value in [0, 1] to linear light in [0, 1].
double srgb_decoded(double code);
double srgb_encoded(double linear);

/// A picture as read (code / maximum code, or floats) to linear light.
Picture to_light(const Picture& read, const Encoding& encoding);

/// The first pixel of a picture as read that is no multiple of the encoding's step, x and y: then
/// the file has more bits than the encoding says. Nothing for floats.
std::optional<std::array<int, 2>> finer_than(const Picture& read, const Encoding& encoding);

/// All light that rounds to the same code as `light` does, rounding to nearest. The code of white
/// stands for everything above it, too; that of black for everything below. A float stands for
/// itself alone: its rounding (6e-8 of its value) is part of the tolerance for single precision.
struct Cell {
  double low = 0, high = 0;
};
Cell cell_of(double light, const Encoding& encoding);

/// The largest distance from `light` that its code's rounding can hide, in linear light: half a
/// step of a linear encoding, half a step times the slope of the transfer function for sRGB (taken
/// at the far end of the cell). Clipping apart. 0 for floats.
double half_step(double light, const Encoding& encoding);

/// `theirs` moved towards `ours`, in each channel, as far as the rounding allows: where `ours`
/// rounds to the code that was written, the result is `ours` itself, else it is the nearest light
/// that rounds to that code. What is left of the difference is not rounding. `layers` are the
/// pictures whose sum `theirs` is (one, if it is no sum): each was rounded by itself. They have one
/// size with `ours`.
Picture nearest_that_rounds_to(const Picture& ours, const std::vector<const Picture*>& layers,
                               const Encoding& encoding);

/// How many pixels are at the code of white in some channel, where brighter light is not told
/// apart. 0 for floats.
long clipped_pixels(const Picture& light, const Encoding& encoding);

/// What this encoding cannot show, in words with figures worked out from it; empty for floats.
std::string blindness(const Encoding& encoding);

}  // namespace litmus

// packing.h: pictures as numbers, packed so that the page can unpack them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "scene/picture.h"

namespace litmus {

/// The bits of the half float (IEEE 754 binary16) nearest to the value; too large gives infinity.
std::uint16_t half_bits(double value);

/// The text in base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// The bytes as a zlib stream, in base64.
std::string deflated(std::string_view bytes);

/// How a word of a packed picture is guessed from those before it, in rows of the picture's width;
/// what is kept is the word itself ("none"), or how far it is from a guess. A guess beyond the
/// first row or column is the nearest word before.
enum class Guess {
  None,
  Line,   ///< left + (left - its left)
  Plane,  ///< left + above - (left of above)
};

std::string_view name_of(Guess guess);

/// The largest absolute value of any channel that is finite.
double largest_finite(const Picture& picture);

/// Half floats of value * 2^exponent, so that the largest of them uses half's whole range. `data`
/// is base64 of a zlib stream of bytes: the high bytes, then the low bytes of what is kept of the
/// words
///   r0 r1 r2 ... (g - r)0 (g - r)1 ... (b - g)0 ...      modulo 65536, pixel by pixel.
/// A distance d, from -32768 to 32767, is kept as 2d, or -2d - 1 where it is negative.
struct PackedPicture {
  int exponent = 0;
  Guess guess = Guess::None;  ///< whichever packs best
  std::string data;
};

/// Packs a picture. Values are first rounded to multiples of `step` (> 0), if one is given: noise
/// far below what anybody asks for does not pack.
PackedPicture packed(const Picture& picture, double step = 0);

/// What is left of the picture once it is packed and unpacked, without a step.
Picture as_unpacked(const Picture& picture);

}  // namespace litmus

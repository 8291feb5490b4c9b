// page_data.h: the pictures of a scene as numbers, packed so that the page can unpack them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "reports/study.h"

namespace litmus {

/// The bits of the half float (IEEE 754 binary16) nearest to the value; too large gives infinity.
std::uint16_t half_bits(double value);

/// The text in base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// The bytes as a zlib stream, in base64.
std::string deflated(std::string_view bytes);

/// Half floats of value * 2^exponent, so that the largest of them uses half's whole range. `data`
/// is base64 of a zlib stream of bytes: the high bytes, then the low bytes of the words
///   r0 r1 r2 ... (g - r)0 (g - r)1 ... (b - g)0 ...      modulo 65536, pixel by pixel,
/// each word less its predecessor if `delta` is set (whichever is shorter).
struct PackedPicture {
  int exponent = 0;
  bool delta = false;
  std::string data;
};

/// Packs a picture. Values are first rounded to multiples of `step` (> 0), if one is given: noise
/// far below what anybody asks for does not pack.
PackedPicture packed(const Picture& picture, double step = 0);

/// ours - theirs, and -theirs where ours is not finite: either way the page gets theirs back. The
/// pictures have one size.
Picture packed_difference(const Picture& ours, const Picture& theirs);

/// The text as one word for the shell, quoted where it has to be.
std::string shell_word(const std::string& text);

/// The shorter of a scene's name and its file as a word for the shell, quoted where it has to be.
std::string scene_word(const Case& one);

/// All pictures of a scene as JSON: ours for each layer, for each of its references the difference
/// (to 1/256 of what is allowed inside, 1/32 where no row fails, or as exact as half floats are),
/// what is allowed, the edges, and what the light does (kLit and so on). reports/web/data.js reads
/// it.
std::string pictures_json(const Study& study, const Case& one);

}  // namespace litmus

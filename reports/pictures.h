// pictures.h: the small pictures of a report, as text that a page can hold.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scene/picture.h"

namespace litmus {

/// "data:image/png;base64,...".
std::string data_uri(std::string_view png);

/// The picture as people see it: sRGB, exposure 1; magenta where it is not finite.
std::string picture_uri(const Picture& picture);

/// The same, averaged down so that no side is over `side` pixels; never enlarged.
std::string thumbnail_uri(const Picture& picture, int side);

/// ours - theirs of the channel that differs most, as a share of what is allowed at that pixel
/// (`interior` or, where `edge` is 1, `border`): blue where ours is darker, red where it is
/// brighter, white at 0. Colours go with the square root of the share; a pixel over its tolerance
/// is in the darker colour beyond the scale, and one that is not finite is magenta. The pictures
/// have one size.
std::string difference_uri(const Picture& ours, const Picture& theirs,
                           std::span<const std::uint8_t> edge, double interior, double border);

/// The scale as a CSS gradient, even in the root: shares -1, -1/4, 0, 1/4, 1 at 0, 25, 50, 75, 100
/// %.
std::string difference_gradient();

/// The colours beyond the scale as CSS colours.
std::string over_color(bool brighter);

}  // namespace litmus

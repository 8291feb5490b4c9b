// pictures.h: the small pictures of a report, as text that a page can hold.
#pragma once

#include <string>
#include <string_view>

#include "scene/picture.h"

namespace litmus {

/// "data:image/png;base64,...".
std::string data_uri(std::string_view png);

/// The picture as people see it: sRGB, exposure 1; magenta where it is not finite.
std::string picture_uri(const Picture& picture);

/// The same, averaged down so that no side is over `side` pixels; never enlarged.
std::string thumbnail_uri(const Picture& picture, int side);

}  // namespace litmus

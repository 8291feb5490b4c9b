// pictures.h: pictures and numbers that the tests of compare/ share.
#pragma once

#include <limits>

#include "scene/picture.h"

namespace litmus {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Every channel of every pixel has one value.
inline Picture flat(int width, int height, double value) {
  Picture picture(width, height);
  for (glm::dvec3& pixel : picture.pixels) pixel = glm::dvec3(value);
  return picture;
}

}  // namespace litmus

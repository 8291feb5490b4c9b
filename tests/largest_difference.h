// largest_difference.h: how far two pictures are apart.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/picture.h"

namespace litmus {

/// Over all pixels and channels of two pictures of one size.
inline double largest_difference(const Picture& a, const Picture& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(a.pixels[i][c] - b.pixels[i][c]));
  return largest;
}

}  // namespace litmus

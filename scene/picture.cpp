// picture.cpp: what is asked of pixels and pictures everywhere.
#include "scene/picture.h"

#include <cassert>
#include <cmath>

namespace litmus {

bool is_finite(const glm::dvec3& pixel) {
  return std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z);
}

bool same_size(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height && a.width > 0;
}

Picture sum(const Layers& layers) {
  if (layers.empty()) return {};
  Picture total(layers.front().picture.width, layers.front().picture.height);
  for (const Layer& layer : layers) {
    assert(layer.picture.pixels.size() == total.pixels.size());
    for (std::size_t i = 0; i < total.pixels.size(); ++i)
      total.pixels[i] += layer.picture.pixels[i];
  }
  return total;
}

}  // namespace litmus

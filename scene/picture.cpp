// picture.cpp: adding layers up.
#include "scene/picture.h"

#include <cassert>

namespace litmus {

Picture sum(const Layers& layers) {
  if (layers.empty()) return {};
  Picture total(layers.front().picture.width, layers.front().picture.height);
  for (const Layer& layer : layers) {
    assert(layer.picture.pixels.size() == total.pixels.size());
    for (std::size_t i = 0; i < total.pixels.size(); ++i) total.pixels[i] += layer.picture.pixels[i];
  }
  return total;
}

}  // namespace litmus

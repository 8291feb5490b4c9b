// picture.h: images in memory, the one image type that all parts exchange.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace litmus {

/// A linear RGB image, row 0 at the top, not clamped.
struct Picture {
  int width = 0, height = 0;
  std::vector<glm::dvec3> pixels;  ///< width * height, row by row

  Picture() = default;
  Picture(int width, int height)
      : width(width), height(height), pixels(std::size_t(width) * std::size_t(height)) {}
  glm::dvec3& at(int x, int y) {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
  const glm::dvec3& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// Whether no channel is NaN or infinite.
bool is_finite(const glm::dvec3& pixel);

/// Whether both have pixels, and as many in a row and a column.
bool same_size(const Picture& a, const Picture& b);

/// What one light (or "ambient") adds to the picture.
struct Layer {
  std::string light;       ///< the light's name, or "ambient"
  std::string light_type;  ///< "directional", "point", "spot", "area" or "ambient"
  Picture picture;
};

/// "ambient" first, then each light in the scene's order. Their sum is the whole picture.
using Layers = std::vector<Layer>;

/// The whole picture: the layers added up in order. All layers have one size.
Picture sum(const Layers& layers);

/// What a light does to the samples of a pixel, as bits that are or-ed over its samples. Of the
/// lamps that would light a sample's surface, none is hidden (lit), some are (penumbra), or all are
/// (umbra); no bit where no lamp would. Highlight: (h.n)^ns of a lamp in view is above 1/2.
inline constexpr std::uint8_t kLit = 1, kPenumbra = 2, kUmbra = 4, kHighlight = 8;

/// A number per pixel that changes wherever a layer may be discontinuous: the object seen, what
/// each light sample sees of it, which side faces the sample, and whether it is inside the cone.
struct Signature {
  int width = 0, height = 0;
  std::vector<std::uint64_t> values;  ///< width * height, row by row
};

}  // namespace litmus

// closed_form.h: what is true of a picture by geometry, computed from formulas without any
// renderer: a third reference beside POV-Ray and Blender.
//
// A scene's [expect] table names the closed forms that hold in it. They share no code with the
// tracer (this library does not link it), nor with the exporters, and are computed in extended
// precision, so that their own rounding does not count.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

/// The name of this source in results, options and tolerances.
inline constexpr const char* kClosedForm = "closed-form";

/// A layer as it must be, where that is known: not where a boundary passes within kBoundaryBand
/// (closed_form_shadow.h), nor where the pixel sees something without a closed form.
struct ExpectedLayer {
  Picture picture;                  ///< 0 where it is not known
  std::vector<std::uint8_t> known;  ///< 1 where it is, width * height
};

/// Something that holds at each pixel of one layer, or does not: a boundary, or a set of values.
struct Claim {
  Oracle oracle;
  std::size_t layer = 0;  ///< 0 is ambient, i is the scene's light i - 1
  /// Whether the value of the layer at pixel (x, y) is as claimed; nothing where the claim is
  /// silent, or a boundary too near.
  std::function<std::optional<bool>(int x, int y, const glm::dvec3& value)> holds;
};

/// One number that can be measured in a layer.
struct Figure {
  Oracle oracle;
  std::size_t layer = 0;
  double exact = 0;
  double tolerance = 0;  ///< on |measured - exact|: what the size of a pixel or cell allows, proven
  std::string unit;      ///< "units^2", "pixels", ...
  std::function<double(const Picture&)> measure;
};

struct ClosedForm {
  /// Ambient, then each light, of a spectral scene in linear sRGB; empty if no oracle gives pixels.
  std::vector<ExpectedLayer> layers;
  /// Of a spectral scene the layers of each three bands (scene/bands.h).
  std::vector<std::vector<ExpectedLayer>> bands{};
  std::vector<Claim> claims;
  std::vector<Figure> figures;
};

/// All that the scene's [expect] table names, nothing without one. Throws Refusal that says what an
/// oracle needs and the scene lacks: an oracle is never left out in silence.
ClosedForm closed_form(const Scene& scene);

}  // namespace litmus

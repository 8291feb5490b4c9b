// render.h: renders a scene light by light.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

enum class Precision { Float, Double, LongDouble, Quad };

/// "float", "double", "long-double", "quad".
std::string_view precision_name(Precision precision);

struct RenderOptions {
  Precision precision = Precision::Double;
  int threads = 0;                  ///< 0: all; the picture does not depend on it
  double shift_x = 0, shift_y = 0;  ///< moves every sample point by this many pixels (right, down)
};

struct Rendering {
  Layers layers;  ///< ambient, then each light in the scene's order
  Picture whole;  ///< added up light by light at each sample, not from the layers
  std::vector<Signature> signatures;  ///< one per layer
  /// Per layer and pixel what its light does there: kLit and so on (scene/picture.h); 0 for
  /// ambient.
  std::vector<std::vector<std::uint8_t>> flags;
  double seconds = 0;  ///< wall clock of the pixels alone, without lowering the scene
};

/// Renders the scene. Identical for any number of threads, bit by bit.
Rendering render(const Scene& scene, const RenderOptions& options = {});

/// What each layer shows in a pixel whose centre is at (x, y), in double: x to the right, y down,
/// in pixels; (0.5, 0.5) is the first pixel of the picture.
using Probe = std::function<std::vector<glm::dvec3>(double x, double y)>;
/// `options` gives the shift; precision and threads do not count.
Probe probe(const Scene& scene, const RenderOptions& options = {});

}  // namespace litmus

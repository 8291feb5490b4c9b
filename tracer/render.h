// render.h: renders a scene light by light.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/picture.h"
#include "scene/scene.h"
#include "tracer/effects.h"

namespace litmus {

enum class Precision { Float, Double, LongDouble, Quad };

/// "float", "double", "long-double", "quad".
std::string_view precision_name(Precision precision);

/// Where the samples of area lights lie (area_sampling.h). Scene: as its author wrote them. Centres
/// and Corners: the model's two grids. Gauss (-Legendre), Jittered, R2: other points. Certified: no
/// points, but pieces that provably see or do not see the surface (certified.h), with a bound on
/// the error for each pixel.
enum class Sampler { Scene, Centres, Corners, Gauss, Jittered, R2, Certified };

/// How pixels are computed: in packets of one or two of the processor's vectors, or one by one.
/// Both give the same bits; only float and double have packets.
enum class Kernel { Auto, Scalar, Packet };

/// "auto", "scalar", "packet".
std::string_view kernel_name(Kernel kernel);

struct RenderOptions {
  Precision precision = Precision::Double;
  int threads = 0;                  ///< 0: all; the picture does not depend on it
  double shift_x = 0, shift_y = 0;  ///< moves every sample point by this many pixels (right, down)
  Sampler sampler = Sampler::Scene;
  int area_samples = 0;  ///< along each side of every area light; 0: the scene's own
  Kernel kernel = Kernel::Auto;
  std::string_view target = {};    ///< one of packet_kernels() (kernel.h); empty: the widest
  std::optional<Effects> effects;  ///< absent: what the scene calls for
  bool layers = true;              ///< each light's picture, apart from the whole
  bool edges = true;               ///< signatures and flags
  bool counts = false;
};

struct Rendering {
  Layers layers;  ///< ambient, then each light in the scene's order
  Picture whole;  ///< added up light by light at each sample, not from the layers
  std::vector<Signature> signatures;  ///< one per layer
  /// Per layer and pixel what its light does there: kLit and so on (scene/picture.h); 0 for
  /// ambient.
  std::vector<std::vector<std::uint8_t>> flags;
  /// Sampler::Certified: how far each pixel of `whole` can be off the light of the whole
  /// rectangles. Empty for the other samplers.
  Picture bound;
  /// Samplers off the grid: rays towards area lights, and evaluations of slide 5 for them.
  std::uint64_t area_rays = 0, area_evaluations = 0;
  Counts counts;            ///< 0 unless asked for
  std::string_view target;  ///< what the pixels were computed with: "scalar" or a packet kernel's
  double seconds = 0;       ///< wall clock of the pixels alone, without lowering the scene
};

/// Renders the scene, a spectral one in linear sRGB (bands.h). Identical for any number of threads,
/// any kernel and any effects that hold what the scene calls for, bit by bit. Throws Refusal for
/// samplers that cannot render it (area_sampling.h).
Rendering render(const Scene& scene, const RenderOptions& options = {});

/// What each layer shows in a pixel whose centre is at (x, y), in double: x to the right, y down,
/// in pixels; (0.5, 0.5) is the first pixel of the picture.
using Probe = std::function<std::vector<glm::dvec3>(double x, double y)>;
/// `options` gives the shift; precision and threads do not count.
Probe probe(const Scene& scene, const RenderOptions& options = {});

}  // namespace litmus

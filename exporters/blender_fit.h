// blender_fit.h: how near Blender's own lamps come to the lights of the model.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace litmus {

/// `gain` times the lamp is nearest to the light, in the mean of squares; what is left is `rms`, in
/// units of the light's intensity, over the points that it was fitted to. Distances in scene units.
struct LampFit {
  double gain = 1, rms = 0;
};

/// A lamp that falls off as gain / d^2 (an area lamp: times the cosine of emission) against the
/// attenuation, and cone, of the light at `points`. `light` is not directional. gain = 1 if the
/// lamp reaches no point.
LampFit fit_distance(const Light& light, const std::vector<Point>& points);

/// The blend in 0..1 of Blender's SPOT that, times a gain, is nearest to 1 - (alpha /
/// cutoff)^exponent over the solid angle of the cone, and what is left. Cycles: cos(alpha) times
/// smoothstep((cos(alpha) - cos(cutoff)) / (blend (1 - cos(cutoff)))) (kernel/light/common.h).
struct SpotFit {
  double blend = 0, rms = 0;
};
SpotFit fit_spot(double cutoff, double exponent);

/// Blender's SPOT at an angle to its axis.
double blender_spot(double alpha, double cutoff, double blend);

}  // namespace litmus

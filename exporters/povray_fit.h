// povray_fit.h: POV-Ray's own light formulas, fitted to those of the model.
#pragma once

#include "scene/scene.h"

namespace litmus::povray {

/// A spotlight: cos(a)^tightness * smoothstep(cos(falloff), cos(radius), cos(a)), angles in
/// degrees.
struct SpotFit {
  double radius = 0, falloff = 0, tightness = 0;
  double error = 0;  ///< largest difference from 1 - (a/cutoff)^exponent over all a
};

/// The fit with the least largest error. `cutoff` in radians; POV-Ray ends at 90 degrees, so a
/// wider cone misses what is beyond.
SpotFit fit_spot(double cutoff, double exponent);

/// A fading light: factor * 2/(1 + (d/distance)^power).
struct FadeFit {
  double factor = 1, distance = 1, power = 0;  ///< power 0: no fading
  double error = 0;                            ///< largest difference from l*q over 0 <= d <= reach
};

/// Exact where one of linear and quadratic is 0. `reach`: the largest distance that matters.
FadeFit fit_fade(const Attenuation& attenuation, double reach);

}  // namespace litmus::povray

// closed_form_pictures.h: the oracles that give whole layers, pixel by pixel.
#pragma once

#include <span>

#include "reference/closed_form.h"

namespace litmus {

/// Layers to be filled: one set in the colours of an RGB scene; of a spectral one a set for each
/// three bands.
struct Canvas {
  std::vector<Scene> colors;  ///< the scene in the colours of each set
  std::vector<std::vector<ExpectedLayer>> pictures;
};
Canvas canvas_of(const Scene& scene);

/// Each fills pixels of the layers that it knows. All throw Refusal if the scene lacks what they
/// need.

/// Floors, spheres and boxes: slide 5 at the point that closed_form_surfaces.h finds.
void expect_surfaces(const Scene& scene, std::span<const Oracle> oracles, Canvas& canvas);

/// The inside of a matte sphere around the eye with all lights at its centre: one constant per
/// layer.
void expect_shell(const Scene& scene, Canvas& canvas);

/// Every light's layer is 0 everywhere: nothing in view can be reached (a room without windows, a
/// light of intensity 0); the ambient layer too, where Ia is 0. That this is so is the scene's
/// claim; there is nothing to compute.
void expect_darkness(Canvas& canvas);

}  // namespace litmus

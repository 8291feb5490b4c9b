// closed_form_pictures.h: the oracles that give whole layers, pixel by pixel.
#pragma once

#include "reference/closed_form.h"

namespace litmus {

/// Each fills the pixels of the layers that it knows and that are not known yet. All throw Refusal
/// if the scene lacks what they need.

/// Every pixel that sees a plane: O4, kd Id I (l.n) times attenuation and decay, with the specular
/// term, and shadows by the implicit forms of closed_form_shadow.h.
void expect_floor(const Scene& scene, std::vector<ExpectedLayer>& layers);

/// Every pixel of a sphere in an orthographic picture, where the normal is (u, v, sqrt(1 - u^2 -
/// v^2)) in the camera's frame; and the background, where all that is seen are planes and spheres.
void expect_spheres(const Scene& scene, std::vector<ExpectedLayer>& layers);

/// The inside of a matte sphere around the eye with all lights at its centre: one constant per
/// layer.
void expect_shell(const Scene& scene, std::vector<ExpectedLayer>& layers);

/// Every light's layer is 0 everywhere: nothing in view can be reached (a room without windows, a
/// light of intensity 0); the ambient layer too, where Ia is 0. That this is so is the scene's
/// claim; there is nothing to compute.
void expect_darkness(const Scene& scene, std::vector<ExpectedLayer>& layers);

}  // namespace litmus

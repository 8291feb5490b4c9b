// closed_form_figures.h: the oracles that are one number per layer.
#pragma once

#include <array>

#include "reference/closed_form.h"
#include "reference/closed_form_light.h"

namespace litmus {

/// Each adds its figures, and throws Refusal if the scene lacks what it needs.

/// The pixels' area of a sun's shadow against the sum of pi r^2 / L.z over the casters, spheres
/// apart from each other that the camera straight above does not see. At most all cells that the
/// ellipses' edges cross are counted wrongly: their perimeter times sqrt(2) / 2 of a pixel's side
/// on either side.
void measure_shadow_area(const Scene& scene, std::vector<Figure>& figures);

/// How far, in pixels, the brightest pixel of each lamp's layer is from where the mirror image of
/// the lamp in the floor is seen. A matte floor would not peak there: kd must be 0.
void measure_highlight(const Scene& scene, std::vector<Figure>& figures);

/// The mean of an area light's layer over an open matte floor against that of the exact integral.
/// The midpoint rule with cells hx by hy is wrong by at most (hx^2 + hy^2) / (24 H^2) at the height
/// H: no second derivative of H/d is larger than 1/H^2. Needs no attenuation, a rectangle along the
/// axes and parallel to the floor, samples at centres, and a camera straight above.
void measure_rectangle_limit(const Scene& scene, std::vector<Figure>& figures);

/// The integral of (l.n) = H / d over a rectangle at height H, divided by its area: O7 with
/// F = x ln(y + R) + y ln(x + R) - H atan2(x y, H R), R = sqrt(x^2 + y^2 + H^2), taken at the four
/// corners, whose offsets from the point are x[0], x[1] by y[0], y[1].
Exact rectangle_mean_cosine(std::array<Exact, 2> x, std::array<Exact, 2> y, Exact height);

}  // namespace litmus

// boundary.h: why an edge pixel differs. Where a silhouette, a shadow's edge or a cone's edge
// passes closer to a pixel's centre than a renderer in single precision can place it, both answers
// are right.
#pragma once

#include <optional>
#include <string>

#include "tracer/render.h"

namespace litmus {

/// How far a single-precision renderer may misplace a boundary, in pixels. Its coordinates have 24
/// bits: at ten scene units that is 6e-7 units, some 1e-5 pixels of a picture a few units wide, and
/// a boundary met at a grazing angle of half a degree multiplies it by a hundred.
inline constexpr double kBoundaryPixels = 1e-3;

/// How far from the centre of pixel (x, y) our own picture shows `theirs` in layer `layer` (an
/// index into the layers, or their number for the sum), up to kBoundaryPixels; `slack` is the
/// difference that still counts as equal. Nothing if our picture does not show it there: then the
/// difference has another cause.
std::optional<double> boundary_distance(const Probe& probe, int x, int y, std::size_t layer,
                                        const glm::dvec3& theirs, double slack);

}  // namespace litmus

// pixel_lattice.h: pixels sampled on a lattice, where a grid meets their edges too coarsely.
#pragma once

#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

/// The grids that make a lattice.
inline constexpr int kLatticeGrids = 16;

/// The mean of kLatticeGrids pictures of n x n samples a pixel, each moved so that no two of all
/// samples lie in one column or row (a lattice of rank 1, Sloan and Joe 1994): an edge along the
/// pixels' sides is met as finely as by a grid of 16 n x 16 n, for 16 times the work of n x n.
/// scene.samples does not count. Throws what render() throws.
Picture lattice_mean(const Scene& scene, int n, int threads);

}  // namespace litmus

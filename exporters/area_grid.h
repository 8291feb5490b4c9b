// area_grid.h: where the point lights of an area light's grid are, derived from the slides alone.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace litmus {

/// The columns * rows sample positions of an area light in scene units (slides 19, 20), row by row:
/// sample (column i, row j) is number j * columns + i. Each carries 1 / (columns * rows) of the
/// intensity and the light's attenuation.
///
/// The frame: n = normalize(normal), absent: from the light to the origin of its scene, so give the
/// normal before a scene is moved; right = normalize(up x n) with up = (0,0,1), and (1,0,0) where n
/// is vertical; a given `right` loses its component along n; up' = n x right. Columns run along
/// right, rows along up'. Throws Refusal if there is no such frame, or columns or rows < 1.
///
/// Written without a look at the tracer, which has its own: a wrong grid cannot agree with itself.
std::vector<Point> area_samples(const AreaLight& light);

/// The unit vectors of that frame.
struct GridAxes {
  Vector right, up, normal;
};
GridAxes grid_axes(const AreaLight& light);

}  // namespace litmus

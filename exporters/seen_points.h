// seen_points.h: points all over what a picture shows, for fits that should serve the picture.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace litmus {

/// Where the rays through a grid of 24 x 18 points of the picture meet the first object that the
/// camera sees: surfaces count by the pixels that they take. Empty if nothing is seen. Triangles
/// are tried one by one (0.3 s for 82,000).
std::vector<Point> seen_points(const Scene& scene);

}  // namespace litmus

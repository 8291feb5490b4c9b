// mesh_rays.h: the rays that a picture of one mesh takes, one by one.
#pragma once

#include <vector>

#include "tracer/plan.h"

namespace litmus {

/// A ray in the precision of most peers. The direction is as long as the way to the lamp for a
/// shadow ray, of any length for a ray from the eye.
struct FloatRay {
  float origin[3], direction[3];
  float from = 0, to = std::numeric_limits<float>::infinity();  ///< in lengths of the direction
};

/// The rays of a picture, with how many of them meet the mesh by litmus' own count.
struct RaySet {
  std::vector<FloatRay> rays;
  int met = 0;
};

/// A ray through each pixel's centre, row by row.
RaySet primary_rays(const Plan<double>& plan);

/// From each point seen that faces the first lamp, to that lamp. They begin a little above the
/// surface, as a user of Embree would have it.
RaySet shadow_rays(const Plan<double>& plan);

/// Bytes a plan holds for its triangles: corners, normals, tree.
double mesh_bytes(const Plan<double>& plan);

}  // namespace litmus

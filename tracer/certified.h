// certified.h: the light of an area light at a point, integrated over its rectangle with a bound on
// the error.
#pragma once

#include <cstdint>

#include "tracer/shade.h"
#include "tracer/viewpoint.h"

namespace litmus {

/// Means of D and S over the rectangle, and how far they can be off.
struct PanelTerms {
  Terms<double> value, bound;
  std::uint8_t flags = 0;         ///< kLit, kPenumbra or kUmbra, kHighlight (scene/picture.h)
  std::uint64_t rays = 0;         ///< towards the light
  std::uint64_t evaluations = 0;  ///< of slide 5
  std::uint64_t pieces = 0;       ///< of the rectangle that were looked at
};

/// Splits the rectangle until what is in view of every piece is known well enough: nothing, because
/// one object provably covers it, all of it, or what the outlines of objects leave (shaft.h,
/// region.h). Between edges of meshes at which a shadow may end (silhouette.h) one ray tells. That
/// region is integrated by Gauss-Legendre quadrature of up to 4 points a side, as few as keep
/// quadrature_bounds() within 1/n^3. A piece where they do not, or whose outlines are uncertain by
/// more than 1/n^2, is split, at most down to 1/n of the rectangle's sides, n rounded up to 2^k or
/// 3 * 2^k. What is not known in the end (more than a few objects, one around the light or the
/// surface point) counts with a ray to its centre; its whole area times the largest terms on it goes
/// into the bound. So an occluder is found however small it is: no sample can miss it.
PanelTerms certified_terms(const Plan<double>& plan, const Occluders& occluders, const Panel& panel,
                           const Hit<double>& hit, const Vec<double>& eye,
                           const Terms<double>& weight, int n);

}  // namespace litmus

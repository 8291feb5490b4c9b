// certified.h: the light of an area light at a point, integrated over its rectangle with a bound on
// the error.
#pragma once

#include <cstdint>

#include "tracer/plan.h"
#include "tracer/shade.h"
#include "tracer/silhouette.h"
#include "tracer/visibility.h"

namespace litmus {

/// An area light as the rectangle that its samples stand for.
struct Panel {
  Lamp<double> lamp;             ///< any sample: its origin is moved
  Vec<double> center;            ///< scene units
  Vec<double> across, up;        ///< half the sides, along `right` and `up` (slide 20)
  bool meets_triangles = false;  ///< some triangle may pass through the rectangle
};

/// What the integration needs of a scene's objects besides its plan, made once.
struct Occluders {
  EdgeTree edges;
};

/// Means of D and S over the rectangle, and how far they can be off.
struct PanelTerms {
  Terms<double> value, bound;
  std::uint8_t flags = 0;         ///< kLit, kPenumbra or kUmbra, kHighlight (scene/picture.h)
  std::uint64_t rays = 0;         ///< towards the light, tested against all objects
  std::uint64_t evaluations = 0;  ///< of slide 5
  std::uint64_t pieces = 0;       ///< of the rectangle that were looked at
};

/// Splits the rectangle until every piece provably sees past all objects, or one of them provably
/// covers it (shaft.h, silhouette.h); at most down to 1/n of its sides, n rounded up to 2^k or
/// 3 * 2^k, and further only while a sphere looks smaller than the piece. Pieces in view are integrated
/// by Gauss-Legendre quadrature of 1, 2 or 3 points a side, as few as keep quadrature_bound()
/// within 1/20 n^(-3/2), and else split as well. What is undecided in the end counts with the part
/// of it that is in view, where one sphere, box or plane is in the way, or by a ray to its centre;
/// its whole area times the largest terms on it goes into the bound. So an occluder is found
/// however small it is: no sample can miss it.
PanelTerms certified_terms(const Plan<double>& plan, const Occluders& occluders, const Panel& panel,
                           const Hit<double>& hit, const Vec<double>& eye,
                           const Terms<double>& weight, int n);

}  // namespace litmus

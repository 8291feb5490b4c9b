// shaft.h: all lines of sight from a point to a piece of a rectangle, and what is in their way.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tracer/intersect.h"

namespace litmus {

/// A pyramid: every segment from an apex (at 0: all positions are relative to it) to a
/// parallelogram with the corners center -+ across -+ up.
struct Shaft {
  struct Axis {
    Vec<double> normal;  ///< unit, or zero where the pyramid is flat
    double low, high;    ///< of the pyramid along it
  };
  Vec<double> center, across, up;
  std::array<Vec<double>, 4> corners;  ///< around the parallelogram
  std::array<Axis, 5> axes;            ///< of the four sides and the base
  Vec<double> min, max;                ///< the pyramid's box, apex included
};
Shaft shaft_to(const Vec<double>& center, const Vec<double>& across, const Vec<double>& up);

/// Whether the whole base is seen from the apex past an object.
enum class Sight {
  Clear,      ///< no segment meets it
  Blocked,    ///< every segment meets it, before its end
  Undecided,  ///< neither is proven; so for a small enough piece only where its shadow ends
};

/// The object relative to the apex. Spheres and boxes are solid: a segment that leaves one that the
/// apex is in meets it. Proven up to the rounding of double precision (margins of 1e-12 of the
/// distances are undecided).
///
/// Clear by a separating plane: the pyramid's sides and base, and planes through the apex that
/// touch the object (a box's edges, a sphere towards the nearest corner), which together are exact
/// but for what the base cuts off. Blocked if the segments to the four corners all meet the object:
/// it is convex, so every segment between them does. (Let b_i = t_i c_i be points of the object on
/// the segments to the corners c_i, 0 < t_i < 1. The segment to c = sum w_i c_i meets their hull at
/// s c, 1 / s = sum w_i / t_i, so 0 < s < 1.)
Sight sight_past(const Shaft& shaft, const SphereSurface<double>& sphere);
Sight sight_past(const Shaft& shaft, const BoxSurface<double>& box);
Sight sight_past(const Shaft& shaft, const PlaneSurface<double>& plane);

/// Whether the segment from a to b may meet the pyramid; false only if it provably does not.
bool may_meet(const Shaft& shaft, const Vec<double>& a, const Vec<double>& b);
/// The same for a box.
bool may_meet(const Shaft& shaft, const BoxSurface<double>& box);

/// a + b u + c v > 0 on the base, where u and v run from -1 to 1 along across and up.
struct HalfPlane {
  double constant, along_u, along_v;
};

/// What an undecided object hides of the base is where all of these hold, if the object is in front
/// of the base and does not contain the apex; empty otherwise. Exact for boxes (their silhouette)
/// and planes; for a sphere the conic's tangent, which is off by O(size^2).
std::vector<HalfPlane> hidden_part(const Shaft& shaft, const SphereSurface<double>& sphere);
std::vector<HalfPlane> hidden_part(const Shaft& shaft, const BoxSurface<double>& box);
std::vector<HalfPlane> hidden_part(const Shaft& shaft, const PlaneSurface<double>& plane);

/// The base's part on one side of the plane through the apex and a segment.
HalfPlane beyond_edge(const Shaft& shaft, const Vec<double>& a, const Vec<double>& b);

/// The part of the base where not all half-planes hold: its share of the area, and its centroid.
struct VisiblePart {
  double share, u, v;
};
VisiblePart visible_part(std::span<const HalfPlane> hidden);

}  // namespace litmus

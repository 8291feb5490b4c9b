// shaft.h: all lines of sight from a point to a piece of a rectangle, and what is in their way.
#pragma once

#include <array>

#include "tracer/intersect.h"
#include "tracer/region.h"

namespace litmus {

/// A pyramid: every segment from an apex (at 0: all positions are relative to it) to a
/// parallelogram with the corners center -+ across -+ up.
struct Shaft {
  struct Axis {
    Vec<double> normal;  ///< of any length, zero where the pyramid is flat
    double length;       ///< of the normal
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

/// What an undecided object hides of the base, u and v running from -1 to 1 along across and up.
struct HiddenPart {
  ConvexSet set;         ///< without sides: not known
  double uncertain = 0;  ///< the share of the base about which it may be wrong
};

/// Known if the object is in front of the base and does not contain the apex. Exact for boxes
/// (their silhouette) and planes. A sphere's outline is a circle on the cone of its tangents: of
/// the arc across the base a polygon with sides of at most `widest` radians and the area of the
/// circle's sector; what may be wrong is what lies between the polygons inside and around the
/// circle.
HiddenPart hidden_part(const Shaft& shaft, const SphereSurface<double>& sphere, double widest);
HiddenPart hidden_part(const Shaft& shaft, const BoxSurface<double>& box);
HiddenPart hidden_part(const Shaft& shaft, const PlaneSurface<double>& plane);

/// The base's part on that side of the plane through the apex that `normal` points to.
HalfPlane above(const Shaft& shaft, const Vec<double>& normal);

/// A segment as it is seen on the base from the apex: where all three are 0 or more is one side of
/// its line between its ends.
struct SeenEdge {
  HalfPlane line, after_start, before_end;
};
SeenEdge seen_edge(const Shaft& shaft, const Vec<double>& a, const Vec<double>& b);
/// Whether it may cross the polygon.
bool may_cross(const Polygon& polygon, const SeenEdge& edge);

}  // namespace litmus

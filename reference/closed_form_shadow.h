// closed_form_shadow.h: whether an object holds the straight way between two points, as an implicit
// inequality for each shape.
#pragma once

#include "reference/closed_form_light.h"

namespace litmus {

/// An answer, or that the boundary is too near to tell.
enum class Way { Open, Blocked, Unsure };

/// How near a boundary may pass, as an angle or as a part of the way, before the answer is Unsure.
inline constexpr double kBoundaryBand = 1e-9;

/// The way from a point to a lamp or an eye; `sun` has no end, and `to` is its direction then.
struct Passage {
  ExactVec from{0}, to{0};
  bool sun = false;
};

/// Spheres by the cone of their tangents, ((X-S).A)^2 > cos^2 beta |X-S|^2 (for the sun their
/// cylinder), boxes by the part of the way within all three pairs of faces, planes by the sides of
/// both ends, triangles (and those of meshes) by the signs of three volumes. Where the way begins
/// or ends on the surface itself it is open.
Way passage_by(const Object& object, const Passage& passage);

/// Past all objects, without `skipped` (it may be null); of those the camera sees, if `seen_only`.
Way passage_through(const Scene& scene, const Passage& passage, const Object* skipped,
                    bool seen_only = false);

}  // namespace litmus

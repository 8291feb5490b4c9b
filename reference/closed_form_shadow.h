// closed_form_shadow.h: whether an object holds the straight way between two points, as an implicit
// inequality for each shape.
#pragma once

#include <optional>
#include <vector>

#include "reference/closed_form_facets.h"
#include "reference/closed_form_light.h"

namespace litmus {

/// An answer, or that the boundary is too near to tell.
enum class Way { Open, Blocked, Unsure };

/// How near a boundary may pass, as a part of a sphere's radius, of a box or of the way, before the
/// answer is Unsure.
inline constexpr double kBoundaryBand = 1e-9;

/// The way from a point to a lamp or an eye; `sun` has no end, and `to` is its direction then.
struct Passage {
  ExactVec from{0}, to{0};
  bool sun = false;
};

/// Spheres by the distance of their centre from the way (those of the cone of tangents are at the
/// radius), boxes by the part of the way within all three pairs of faces, planes by the sides of
/// both ends, triangles (and those of meshes) by the signs of three volumes. Where the way begins
/// or ends on the surface itself it is open. In extended precision.
Way passage_by(const Object& object, const Passage& passage);

/// All that may hold ways with one end, or in one direction: what is asked at every pixel is laid
/// out once.
struct Obstacles {
  struct One {
    const Object* object = nullptr;
    double reach = 0;  ///< double precision decides for ends whose coordinates are not larger
    std::optional<FacetMap> facets{};  ///< of a mesh
  };
  std::vector<One> each;
};

/// The objects of the scene, or of those the camera sees, in the way to `end`.
Obstacles obstacles(const Scene& scene, const PencilEnd& end, bool seen_only = false);

/// Past all of them but `skipped` (it may be null). The passage ends where the obstacles were laid
/// out for. Double precision answers where a boundary is farther than 1e-7, else passage_by.
Way passage_through(const Obstacles& obstacles, const Passage& passage, const Object* skipped);

}  // namespace litmus

// closed_form_facets.h: which triangles of a mesh a straight way can meet, looked up in a picture
// of the mesh from where all the ways end.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// Where all ways of a pencil end: a place, or a direction that they have in common.
struct PencilEnd {
  glm::dvec3 to{0};  ///< the place, or the unit vector along the ways
  bool parallel = false;
};

/// The triangles of a mesh by the cells of a square grid over their central (or parallel)
/// projection from the pencil's end: a way can meet only those whose projection reaches into the
/// cell of its own.
class FacetMap {
 public:
  FacetMap(const Mesh& mesh, const PencilEnd& end);

  /// Indices of the triangles that the way from this point to the end may meet, a superset.
  std::span<const std::int32_t> near(const glm::dvec3& from) const;

 private:
  glm::dvec2 project(const glm::dvec3& point, double& depth) const;
  /// The cells, first and last along one axis, that an interval of the projection reaches into.
  std::array<int, 2> cells(double from, double to, int axis) const;

  PencilEnd end_;
  glm::dvec3 right_{0}, up_{0}, forward_{0};
  int side_ = 1;        ///< cells along each side; 1 where the mesh surrounds the end
  bool whole_ = false;  ///< all triangles are always near
  glm::dvec2 low_{0}, cell_{1};
  std::vector<std::int32_t> starts_, indices_;
};

}  // namespace litmus

// silhouette.h: the edges of a scene's triangles, and which of them end a shadow.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/shaft.h"

namespace litmus {

/// An edge of one or two triangles.
struct MeshEdge {
  Vec<double> a, b;
  std::array<Vec<double>, 2> opposite;  ///< the third corners of its two triangles
  bool shared;                          ///< by exactly two triangles; else it always ends a shadow
  bool turned;                          ///< its first triangle runs from b to a
};

/// A tree of boxes over edges.
struct EdgeTree {
  struct Node {
    BoxSurface<double> box;
    std::uint32_t first = 0, count = 0;  ///< leaf: edges; else count is 0 and first the right child
    Vec<double> facing;  ///< the normals of all its triangles are within an angle of this one
    double cosine = -1;  ///< of that angle; below 0: too wide to be of use
  };
  std::vector<MeshEdge> edges;  ///< leaf by leaf
  std::vector<Node> nodes;      ///< the root first, a left child follows its parent
};

/// All edges of the triangles. Two triangles share an edge if both its corners are equal to the
/// last bit.
EdgeTree edge_tree(const std::vector<std::array<Vec<double>, 3>>& triangles);

/// The edges at which a shadow may end that meet the segments from `apex` to the shaft's base:
/// those whose two triangles lie on the same side of the plane through the edge and the apex, or
/// that have not two triangles. Where there is none (and no triangle meets the base itself), either
/// all of these segments meet a triangle or none does: where a segment sweeps over any other edge,
/// it goes over from one triangle to its neighbour.
/// Appends their indices.
void find_shadow_ends(const EdgeTree& tree, const Vec<double>& apex, const Shaft& shaft,
                      std::vector<std::uint32_t>& found);

}  // namespace litmus

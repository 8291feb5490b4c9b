// bvh.h: a tree of boxes over the triangles of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/intersect.h"

namespace litmus {

template <Real R>
struct BvhNode {
  Vec<R> min, max;
  std::uint32_t first =
      0;  ///< leaf: first entry of `order`; else: the right child (the left one follows)
  std::uint32_t count = 0;  ///< triangles of a leaf; 0 for an inner node
  std::uint32_t axis = 0;   ///< inner node: the axis it was split along
};

template <Real R>
struct Bvh {
  std::vector<BvhNode<R>> nodes;     ///< nodes[0] is the root; empty without triangles
  std::vector<std::uint32_t> order;  ///< triangle numbers, leaf by leaf
};

/// Builds the tree with the surface area heuristic over 16 bins (Wald 2007). Deterministic.
template <Real R>
Bvh<R> build_bvh(const std::vector<std::array<Vec<R>, 3>>& triangles);

/// Calls visit(triangle number) -> bool for each triangle whose box the ray meets within ray.limit,
/// nearer subtrees first; stops when visit returns true. The visitor may shorten ray.limit.
template <Real R, class Visit>
void traverse(const Bvh<R>& bvh, Ray<R>& ray, Visit&& visit) {
  if (bvh.nodes.empty()) return;
  const Vec<R> inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z};
  // Ize 2013 (Robust BVH Ray Traversal): without the factor a flat box is missed by rounding.
  const R widen = 1 + 2 * gamma_bound<R>(3);
  const auto meets = [&](const BvhNode<R>& node) {
    R enter = 0, leave = ray.limit;
    for (int axis = 0; axis < 3; ++axis) {
      R low = (node.min[axis] - ray.origin[axis]) * inverse[axis];
      R high = (node.max[axis] - ray.origin[axis]) * inverse[axis];
      if (inverse[axis] < 0) std::swap(low, high);
      high = high * widen;
      if (low > enter) enter = low;
      if (high < leave) leave = high;
    }
    return enter <= leave;
  };
  std::uint32_t stack[64];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const BvhNode<R>& node = bvh.nodes[index];
    if (!meets(node)) continue;
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (visit(bvh.order[i])) return;
      }
    } else {
      const bool backwards = ray.direction[node.axis] < 0;
      stack[depth++] = backwards ? index + 1 : node.first;
      stack[depth++] = backwards ? node.first : index + 1;
    }
  }
}

}  // namespace litmus

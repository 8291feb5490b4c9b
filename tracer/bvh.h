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

/// Up to eight boxes side by side, so that a ray is tested against all of them at once.
template <Real R>
struct WideNode {
  static constexpr int kWidth = 8;
  R min[3][kWidth], max[3][kWidth];  ///< by axis; an empty place has a box that nothing meets
  std::uint32_t first[kWidth];       ///< leaf: first entry of `order`; else: a wide node
  std::uint32_t count[kWidth];       ///< triangles of a leaf; 0 for a wide node
};

template <Real R>
struct Bvh {
  std::vector<BvhNode<R>> nodes;     ///< nodes[0] is the root; empty without triangles
  std::vector<std::uint32_t> order;  ///< triangle numbers, leaf by leaf
  std::vector<WideNode<R>> wide;     ///< the same tree with fewer levels: what rays traverse
};

/// Builds the tree with the surface area heuristic over 16 bins (Wald 2007). Deterministic.
template <Real R>
Bvh<R> build_bvh(const std::vector<std::array<Vec<R>, 3>>& triangles);

/// Where a ray enters the boxes of a wide node; infinite for those that it misses within its limit.
template <Real R>
void enter_boxes(const WideNode<R>& node, const Ray<R>& ray, const Vec<R>& inverse, R* enters) {
  // Ize 2013 (Robust BVH Ray Traversal): without the factor a flat box is missed by rounding.
  const R widen = 1 + 2 * gamma_bound<R>(3);
  R leaves[WideNode<R>::kWidth];
  for (int k = 0; k < WideNode<R>::kWidth; ++k) enters[k] = 0, leaves[k] = ray.limit;
  for (int axis = 0; axis < 3; ++axis) {
    const bool backwards = inverse[axis] < 0;
    const R* const near = backwards ? node.max[axis] : node.min[axis];
    const R* const far = backwards ? node.min[axis] : node.max[axis];
    const R origin = ray.origin[axis], slope = inverse[axis];
    // Ordered so that 0 * infinity changes nothing.
    for (int k = 0; k < WideNode<R>::kWidth; ++k) {
      const R low = (near[k] - origin) * slope, high = (far[k] - origin) * slope * widen;
      enters[k] = low > enters[k] ? low : enters[k];
      leaves[k] = high < leaves[k] ? high : leaves[k];
    }
  }
  for (int k = 0; k < WideNode<R>::kWidth; ++k) {
    enters[k] = enters[k] <= leaves[k] ? enters[k] : std::numeric_limits<R>::infinity();
  }
}

/// Calls visit(triangle number) -> bool for each triangle whose box the ray meets within ray.limit,
/// nearer subtrees first; stops when visit returns true. The visitor may shorten ray.limit.
template <Real R, class Visit>
void traverse(const Bvh<R>& bvh, Ray<R>& ray, Visit&& visit) {
  if (bvh.wide.empty()) return;
  constexpr int kWidth = WideNode<R>::kWidth;
  const Vec<R> inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z};
  struct Entry {
    R enter;
    std::uint32_t first, count;
  };
  Entry stack[64 * (kWidth - 1)];
  int depth = 0;
  stack[depth++] = {R(0), 0, 0};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.enter > ray.limit) continue;
    if (entry.count > 0) {
      for (std::uint32_t i = entry.first; i < entry.first + entry.count; ++i) {
        if (visit(bvh.order[i])) return;
      }
      continue;
    }
    const WideNode<R>& node = bvh.wide[entry.first];
    R enters[kWidth];
    enter_boxes(node, ray, inverse, enters);
    // The nearest comes to the top of the stack.
    const int bottom = depth;
    for (int k = 0; k < kWidth; ++k) {
      if (!(enters[k] < std::numeric_limits<R>::infinity())) continue;
      int place = depth++;
      for (; place > bottom && stack[place - 1].enter < enters[k]; --place) {
        stack[place] = stack[place - 1];
      }
      stack[place] = {enters[k], node.first[k], node.count[k]};
    }
  }
}

}  // namespace litmus

// bvh.h: a tree of boxes over the triangles of a scene, eight at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "tracer/huge_pages.h"
#include "tracer/intersect.h"

namespace litmus {

/// Boxes of a node and triangles of a block: a ray is tested against all of them at once.
inline constexpr int kWide = 8;

/// Up to eight boxes side by side.
template <Real R>
struct alignas(64) WideNode {
  R bounds[2][3][kWide];  ///< lower and upper by axis; nothing meets the box of an empty place
  struct Child {
    std::uint32_t first;  ///< leaf: its first block; else: a node
    std::uint32_t count;  ///< triangles of a leaf; 0 for a node
  } children[kWide];
};

/// Up to eight triangles side by side.
template <Real R>
struct alignas(64) TriangleBlock {
  R corners[3][3][kWide];  ///< by corner and axis; nothing meets the triangle of an empty place
  std::uint32_t numbers[kWide];  ///< in the list that the tree was built from
  std::uint32_t objects[kWide];  ///< that they belong to
};

template <Real R>
struct Bvh {
  HugeVector<WideNode<R>> nodes;  ///< nodes[0] is the root; empty without triangles
  HugeVector<TriangleBlock<R>> blocks;
  Vec<R> min, max;  ///< of all triangles
};

/// Builds the tree with the surface area heuristic over 16 bins (Wald 2007). Deterministic.
/// `objects` are those that the triangles belong to.
template <Real R>
Bvh<R> build_bvh(const std::vector<std::array<Vec<R>, 3>>& triangles,
                 const std::vector<int>& objects);

/// A ray as it is tested against boxes: one ray in all lanes against a box in each, or the reverse.
template <Value V>
struct SlabRay {
  V origin[3], slope[3], far_slope[3];  ///< slopes are 1 / direction

  explicit SlabRay(const Ray<V>& ray) : origin{ray.origin.x, ray.origin.y, ray.origin.z} {
    using R = Scalar<V>;
    // Ize 2013 (Robust BVH Ray Traversal): without the factor a flat box is missed by rounding.
    const R widen = 1 + 2 * gamma_bound<R>(3);
    for (int axis = 0; axis < 3; ++axis) {
      slope[axis] = R(1) / ray.direction[axis];
      far_slope[axis] = slope[axis] * widen;
    }
  }

  /// Narrows the stretch from `enter` to `leave` of the ray to that between two planes across an
  /// axis. Ordered so that 0 * infinity changes nothing.
  void narrow(int axis, const V& near, const V& far, V& enter, V& leave) const {
    enter = larger(V((near - origin[axis]) * slope[axis]), enter);
    leave = smaller(V((far - origin[axis]) * far_slope[axis]), leave);
  }
};

/// Which rays of a packet meet a box within their limit.
template <Value V>
Mask<V> meets_box(const Vec<Scalar<V>>& min, const Vec<Scalar<V>>& max, const Ray<V>& ray) {
  const SlabRay<V> slabs(ray);
  V enter = Scalar<V>(0), leave = ray.limit;
  for (int axis = 0; axis < 3; ++axis) {
    const Mask<V> backwards = slabs.slope[axis] < Scalar<V>(0);
    const V low = min[axis], high = max[axis];
    slabs.narrow(axis, select(backwards, high, low), select(backwards, low, high), enter, leave);
  }
  return enter <= leave;
}

/// Which boxes of a node, from the one at `first` on, a ray meets within its limit, as bits, and
/// where it enters them. `backwards` is 1 for each axis along which the ray runs down.
template <Value W, Real R>
unsigned meet_boxes(const WideNode<R>& node, int first, const SlabRay<W>& slabs,
                    const int (&backwards)[3], const R& limit, W& enter) {
  W leave = limit;
  enter = R(0);
  for (int axis = 0; axis < 3; ++axis) {
    const R* const near = node.bounds[backwards[axis]][axis];
    const R* const far = node.bounds[1 - backwards[axis]][axis];
    slabs.narrow(axis, load_lanes<W>(near + first), load_lanes<W>(far + first), enter, leave);
  }
  return lanes_of(enter <= leave);
}

/// In which order a ray comes to the triangles.
enum class Order { NearestFirst, Any };

/// Calls visit(block, how many triangles) -> bool for each block of triangles whose box the ray
/// meets within ray.limit; stops when visit returns true. The visitor may shorten ray.limit. W is
/// as many boxes as are tested at once.
template <Value W, Order kOrder, Real R, class Visit>
void traverse(const Bvh<R>& bvh, const Ray<R>& ray, Visit&& visit) {
  if (bvh.nodes.empty()) return;
  const SlabRay<W> slabs(Ray<W>{Vec<W>(ray.origin), Vec<W>(ray.direction)});
  int backwards[3];
  for (int axis = 0; axis < 3; ++axis) backwards[axis] = 1 / ray.direction[axis] < 0;
  using Child = typename WideNode<R>::Child;
  struct Entry {
    R enter;
    Child child;
  };
  Entry stack[64 * (kWide - 1)];
  int depth = 0;
  for (Child at{0, 0};;) {
    if (at.count > 0) {
      for (std::uint32_t k = 0; k * kWide < at.count; ++k) {
        const int count = int(std::min<std::uint32_t>(at.count - k * kWide, kWide));
        if (visit(bvh.blocks[at.first + k], count)) return;
      }
    } else {
      const WideNode<R>& node = bvh.nodes[at.first];
      const int bottom = depth;
      bool alone = false;
      for (int first = 0; first < kWide; first += kLanes<W>) {
        W enter;
        unsigned met = meet_boxes(node, first, slabs, backwards, ray.limit, enter);
        if (met == 0) continue;
        if (kLanes<W> == kWide && (met & (met - 1)) == 0) {
          // The common case needs no stack.
          at = node.children[std::countr_zero(met)], alone = true;
          break;
        }
        R enters[kLanes<W>];
        copy_lanes(enter, enters);
        for (; met != 0; met &= met - 1) {
          const int k = std::countr_zero(met);
          int place = depth++;
          if constexpr (kOrder == Order::NearestFirst) {
            // The nearest comes to the top of the stack.
            for (; place > bottom && stack[place - 1].enter < enters[k]; --place)
              stack[place] = stack[place - 1];
          }
          stack[place] = {enters[k], node.children[first + k]};
        }
      }
      if (alone) continue;
    }
    do {
      if (depth == 0) return;
      at = stack[--depth].child;
    } while (stack[depth].enter > ray.limit);
  }
}

/// One ray against the triangles of a block, as many as W has lanes, from the one at `first` on.
template <Value W>
struct BlockRay {
  using R = Scalar<W>;
  ShearedRay<R> sheared;
  Vec<W> origin;

  explicit BlockRay(const Ray<R>& ray)
      : sheared(ray.direction), origin(Vec<W>(sheared.turned(ray.origin))) {}

  Crossing<W> crossing(const TriangleBlock<R>& block, int first) const {
    Vec<W> corners[3];
    for (int k = 0; k < 3; ++k) {
      const auto& corner = block.corners[k];
      corners[k] = {load_lanes<W>(corner[sheared.kx] + first),
                    load_lanes<W>(corner[sheared.ky] + first),
                    load_lanes<W>(corner[sheared.kz] + first)};
    }
    return litmus::crossing(corners, origin, sheared);
  }
};

}  // namespace litmus

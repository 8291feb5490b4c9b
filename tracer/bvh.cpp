// bvh.cpp: building the tree of boxes.
#include "tracer/bvh.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace litmus {
namespace {

constexpr int kBins = 16;
constexpr std::size_t kLeafSize = kWide;
constexpr int kMaximumDepth = 60;  // the traversal's stack holds 64

/// Of a tree with two children a node.
template <Real R>
struct BinaryNode {
  Vec<R> min, max;
  std::uint32_t first =
      0;  ///< leaf: first entry of `order`; else: the right child (the left one follows)
  std::uint32_t count = 0;  ///< triangles of a leaf; 0 for an inner node
};

template <Real R>
struct Bounds {
  Vec<R> min{std::numeric_limits<R>::infinity(), std::numeric_limits<R>::infinity(),
             std::numeric_limits<R>::infinity()};
  Vec<R> max{-min.x, -min.y, -min.z};

  void add(const Vec<R>& lo, const Vec<R>& hi) {
    min = {std::min(min.x, lo.x), std::min(min.y, lo.y), std::min(min.z, lo.z)};
    max = {std::max(max.x, hi.x), std::max(max.y, hi.y), std::max(max.z, hi.z)};
  }
  void add(const Bounds& b) { add(b.min, b.max); }
  Vec<R> size() const { return max - min; }
  R half_area() const {
    const Vec<R> s = size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
};

template <Real R>
Bounds<R> bounds_of(const std::array<Vec<R>, 3>& triangle) {
  Bounds<R> box;
  for (const Vec<R>& corner : triangle) box.add(corner, corner);
  return box;
}

/// Boxes enclose in R; where to split them is a matter of cost, for which double is enough.
template <Real R>
struct Builder {
  using Cost = std::conditional_t<(sizeof(R) > sizeof(double)), double, R>;

  const std::vector<std::array<Vec<R>, 3>>& triangles;
  std::vector<BinaryNode<R>> nodes;  ///< nodes[0] is the root
  std::vector<std::uint32_t> order;  ///< triangle numbers, leaf by leaf
  std::vector<Bounds<Cost>> bounds;
  std::vector<Vec<Cost>> centers;

  explicit Builder(const std::vector<std::array<Vec<R>, 3>>& given)
      : triangles(given), order(given.size()) {
    std::iota(order.begin(), order.end(), 0u);
    for (const auto& triangle : triangles) {
      const Bounds<R> box = bounds_of(triangle);
      bounds.push_back({rounded(box.min), rounded(box.max)});
      centers.push_back(Cost(0.5) * bounds.back().min + Cost(0.5) * bounds.back().max);
    }
  }

  static Vec<Cost> rounded(const Vec<R>& v) { return {Cost(v.x), Cost(v.y), Cost(v.z)}; }

  int bin_of(std::uint32_t triangle, int axis, Cost low, Cost extent) const {
    const int bin = int((centers[triangle][axis] - low) / extent * Cost(kBins));
    return std::clamp(bin, 0, kBins - 1);
  }

  /// The last bin of the left part with the least expected cost, by surface area.
  int cheapest_split(std::size_t begin, std::size_t end, int axis, Cost low, Cost extent) const {
    Bounds<Cost> boxes[kBins];
    std::size_t counts[kBins] = {};
    for (std::size_t i = begin; i < end; ++i) {
      const int bin = bin_of(order[i], axis, low, extent);
      boxes[bin].add(bounds[order[i]]);
      ++counts[bin];
    }
    Cost right_cost[kBins] = {};
    Bounds<Cost> box;
    for (std::size_t bin = kBins - 1, count = 0; bin > 0; --bin) {
      box.add(boxes[bin]);
      count += counts[bin];
      right_cost[bin] = count == 0 ? Cost(0) : box.half_area() * Cost(double(count));
    }
    int best = 0;
    Cost best_cost = std::numeric_limits<Cost>::infinity();
    box = {};
    for (std::size_t bin = 0, count = 0; bin + 1 < kBins; ++bin) {
      box.add(boxes[bin]);
      count += counts[bin];
      if (count == 0 || count == end - begin) continue;
      const Cost cost = box.half_area() * Cost(double(count)) + right_cost[bin + 1];
      if (cost < best_cost) best_cost = cost, best = int(bin);
    }
    return best;
  }

  void build(std::size_t begin, std::size_t end, int depth) {
    const std::size_t index = nodes.size();
    nodes.emplace_back();
    Bounds<Cost> center_box;
    for (std::size_t i = begin; i < end; ++i) center_box.add(centers[order[i]], centers[order[i]]);

    // Split along the longest side of the box of centres, unless all centres coincide.
    const Vec<Cost> extent = center_box.size();
    const int axis =
        extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
    if (end - begin <= kLeafSize || !(extent[axis] > 0) || depth == kMaximumDepth) {
      Bounds<R> box;
      for (std::size_t i = begin; i < end; ++i) box.add(bounds_of(triangles[order[i]]));
      nodes[index] = {box.min, box.max, std::uint32_t(begin), std::uint32_t(end - begin)};
      return;
    }
    const int split = cheapest_split(begin, end, axis, center_box.min[axis], extent[axis]);
    const auto first = order.begin();
    const auto middle = std::stable_partition(first + long(begin), first + long(end), [&](auto t) {
      return bin_of(t, axis, center_box.min[axis], extent[axis]) <= split;
    });
    std::size_t mid = std::size_t(middle - first);
    if (mid == begin || mid == end) mid = begin + (end - begin) / 2;
    build(begin, mid, depth + 1);
    const std::size_t right = nodes.size();
    build(mid, end, depth + 1);
    Bounds<R> box{nodes[index + 1].min, nodes[index + 1].max};
    box.add(nodes[right].min, nodes[right].max);
    nodes[index] = {box.min, box.max, std::uint32_t(right), 0};
  }
};

/// Makes the wide tree of a binary one.
template <Real R>
struct Widener {
  const Builder<R>& binary;
  const std::vector<int>& objects;
  Bvh<R> bvh;

  R half_area(std::uint32_t node) const {
    return Bounds<R>{binary.nodes[node].min, binary.nodes[node].max}.half_area();
  }

  /// The nodes below an inner node that stand side by side in a wide one: the largest are opened
  /// until there are eight.
  std::vector<std::uint32_t> opened(std::uint32_t inner) const {
    std::vector<std::uint32_t> places{inner + 1, binary.nodes[inner].first};
    while (places.size() < std::size_t(kWide)) {
      auto largest = places.end();
      for (auto place = places.begin(); place != places.end(); ++place) {
        if (binary.nodes[*place].count > 0) continue;
        if (largest == places.end() || half_area(*place) > half_area(*largest)) largest = place;
      }
      if (largest == places.end()) break;
      const std::uint32_t node = *largest;
      *largest = node + 1;
      places.push_back(binary.nodes[node].first);
    }
    return places;
  }

  /// Appends the blocks of a leaf; returns the number of the first.
  std::uint32_t add_blocks(const BinaryNode<R>& leaf) {
    const std::uint32_t number = std::uint32_t(bvh.blocks.size());
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const int place = int(i % kWide);
      if (place == 0) bvh.blocks.emplace_back();
      TriangleBlock<R>& block = bvh.blocks.back();
      block.numbers[place] = binary.order[leaf.first + i];
      block.objects[place] = std::uint32_t(objects[block.numbers[place]]);
      for (int k = 0; k < 3; ++k) {
        const Vec<R>& corner = binary.triangles[block.numbers[place]][std::size_t(k)];
        for (int axis = 0; axis < 3; ++axis) block.corners[k][axis][place] = corner[axis];
      }
    }
    return number;
  }

  /// Appends the wide node of those places, and all below it; returns its number.
  std::uint32_t add_node(const std::vector<std::uint32_t>& places) {
    constexpr R kInfinity = std::numeric_limits<R>::infinity();
    const std::uint32_t number = std::uint32_t(bvh.nodes.size());
    bvh.nodes.emplace_back();
    WideNode<R> wide{};
    for (std::size_t k = 0; k < std::size_t(kWide); ++k) {
      const bool empty = k >= places.size();
      for (int axis = 0; axis < 3; ++axis) {
        wide.bounds[0][axis][k] = empty ? kInfinity : binary.nodes[places[k]].min[axis];
        wide.bounds[1][axis][k] = empty ? -kInfinity : binary.nodes[places[k]].max[axis];
      }
      if (empty) continue;
      const BinaryNode<R>& node = binary.nodes[places[k]];
      wide.children[k].count = node.count;
      wide.children[k].first = node.count > 0 ? add_blocks(node) : add_node(opened(places[k]));
    }
    bvh.nodes[number] = wide;
    return number;
  }
};

}  // namespace

template <Real R>
Bvh<R> build_bvh(const std::vector<std::array<Vec<R>, 3>>& triangles,
                 const std::vector<int>& objects) {
  if (triangles.empty()) return {};
  Builder<R> builder(triangles);
  builder.build(0, triangles.size(), 0);
  const BinaryNode<R>& root = builder.nodes[0];
  Widener<R> widener{builder, objects, {{}, {}, root.min, root.max}};
  widener.add_node(root.count > 0 ? std::vector<std::uint32_t>{0} : widener.opened(0));
  return std::move(widener.bvh);
}

template Bvh<float> build_bvh(const std::vector<std::array<Vec<float>, 3>>&,
                              const std::vector<int>&);
template Bvh<double> build_bvh(const std::vector<std::array<Vec<double>, 3>>&,
                               const std::vector<int>&);
template Bvh<long double> build_bvh(const std::vector<std::array<Vec<long double>, 3>>&,
                                    const std::vector<int>&);
template Bvh<Quad> build_bvh(const std::vector<std::array<Vec<Quad>, 3>>&, const std::vector<int>&);

}  // namespace litmus

// bvh.cpp: building the tree of boxes.
#include "tracer/bvh.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace litmus {
namespace {

constexpr int kBins = 16;
constexpr std::size_t kLeafSize = 4;
constexpr int kMaximumDepth = 60;  // the traversal's stack holds 64

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
struct Builder {
  Bvh<R> bvh;
  std::vector<Bounds<R>> bounds;
  std::vector<Vec<R>> centers;

  int bin_of(std::uint32_t triangle, int axis, R low, R extent) const {
    const int bin = int((centers[triangle][axis] - low) / extent * R(kBins));
    return std::clamp(bin, 0, kBins - 1);
  }

  /// The last bin of the left part with the least expected cost, by surface area.
  int cheapest_split(std::size_t begin, std::size_t end, int axis, R low, R extent) const {
    Bounds<R> boxes[kBins];
    std::size_t counts[kBins] = {};
    for (std::size_t i = begin; i < end; ++i) {
      const int bin = bin_of(bvh.order[i], axis, low, extent);
      boxes[bin].add(bounds[bvh.order[i]]);
      ++counts[bin];
    }
    R right_cost[kBins] = {};
    Bounds<R> box;
    for (std::size_t bin = kBins - 1, count = 0; bin > 0; --bin) {
      box.add(boxes[bin]);
      count += counts[bin];
      right_cost[bin] = count == 0 ? R(0) : box.half_area() * R(double(count));
    }
    int best = 0;
    R best_cost = std::numeric_limits<R>::infinity();
    box = {};
    for (std::size_t bin = 0, count = 0; bin + 1 < kBins; ++bin) {
      box.add(boxes[bin]);
      count += counts[bin];
      if (count == 0 || count == end - begin) continue;
      const R cost = box.half_area() * R(double(count)) + right_cost[bin + 1];
      if (cost < best_cost) best_cost = cost, best = int(bin);
    }
    return best;
  }

  void build(std::size_t begin, std::size_t end, int depth) {
    const std::size_t index = bvh.nodes.size();
    bvh.nodes.emplace_back();
    Bounds<R> box, center_box;
    for (std::size_t i = begin; i < end; ++i) {
      box.add(bounds[bvh.order[i]]);
      center_box.add(centers[bvh.order[i]], centers[bvh.order[i]]);
    }
    bvh.nodes[index].min = box.min, bvh.nodes[index].max = box.max;

    // Split along the longest side of the box of centres, unless all centres coincide.
    const Vec<R> extent = center_box.size();
    const int axis =
        extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
    if (end - begin <= kLeafSize || !(extent[axis] > 0) || depth == kMaximumDepth) {
      bvh.nodes[index].first = std::uint32_t(begin);
      bvh.nodes[index].count = std::uint32_t(end - begin);
      return;
    }
    const int split = cheapest_split(begin, end, axis, center_box.min[axis], extent[axis]);
    const auto first = bvh.order.begin();
    const auto middle = std::stable_partition(first + long(begin), first + long(end), [&](auto t) {
      return bin_of(t, axis, center_box.min[axis], extent[axis]) <= split;
    });
    std::size_t mid = std::size_t(middle - first);
    if (mid == begin || mid == end) mid = begin + (end - begin) / 2;
    build(begin, mid, depth + 1);
    bvh.nodes[index].axis = std::uint32_t(axis);
    bvh.nodes[index].first = std::uint32_t(bvh.nodes.size());
    build(mid, end, depth + 1);
  }
};

template <Real R>
R half_area(const BvhNode<R>& node) {
  return Bounds<R>{node.min, node.max}.half_area();
}

/// The nodes below an inner node that stand side by side in a wide one: the largest are opened
/// until there are eight.
template <Real R>
std::vector<std::uint32_t> opened(const Bvh<R>& bvh, std::uint32_t inner) {
  std::vector<std::uint32_t> places{inner + 1, bvh.nodes[inner].first};
  while (places.size() < std::size_t(WideNode<R>::kWidth)) {
    auto largest = places.end();
    for (auto place = places.begin(); place != places.end(); ++place) {
      if (bvh.nodes[*place].count > 0) continue;
      if (largest == places.end() || half_area(bvh.nodes[*place]) > half_area(bvh.nodes[*largest]))
        largest = place;
    }
    if (largest == places.end()) break;
    const std::uint32_t node = *largest;
    *largest = node + 1;
    places.push_back(bvh.nodes[node].first);
  }
  return places;
}

/// Appends the wide node of those places, and all below it; returns its number.
template <Real R>
std::uint32_t widen_tree(Bvh<R>& bvh, const std::vector<std::uint32_t>& places) {
  constexpr R kInfinity = std::numeric_limits<R>::infinity();
  const std::uint32_t number = std::uint32_t(bvh.wide.size());
  bvh.wide.emplace_back();
  WideNode<R> wide;
  for (std::size_t k = 0; k < std::size_t(WideNode<R>::kWidth); ++k) {
    const bool empty = k >= places.size();
    const BvhNode<R>& node = bvh.nodes[empty ? 0 : places[k]];
    for (int axis = 0; axis < 3; ++axis) {
      wide.min[axis][k] = empty ? kInfinity : node.min[axis];
      wide.max[axis][k] = empty ? -kInfinity : node.max[axis];
    }
    wide.first[k] = node.first, wide.count[k] = empty ? 0 : node.count;
    if (!empty && node.count == 0) wide.first[k] = widen_tree(bvh, opened(bvh, places[k]));
  }
  bvh.wide[number] = wide;
  return number;
}

}  // namespace

template <Real R>
Bvh<R> build_bvh(const std::vector<std::array<Vec<R>, 3>>& triangles) {
  Builder<R> builder;
  builder.bvh.order.resize(triangles.size());
  std::iota(builder.bvh.order.begin(), builder.bvh.order.end(), 0u);
  for (const auto& triangle : triangles) {
    Bounds<R> box;
    for (const Vec<R>& corner : triangle) box.add(corner, corner);
    builder.bounds.push_back(box);
    builder.centers.push_back(R(0.5) * box.min + R(0.5) * box.max);
  }
  if (triangles.empty()) return std::move(builder.bvh);
  builder.build(0, triangles.size(), 0);
  const bool leaf = builder.bvh.nodes[0].count > 0;
  widen_tree(builder.bvh, leaf ? std::vector<std::uint32_t>{0} : opened(builder.bvh, 0));
  return std::move(builder.bvh);
}

template Bvh<float> build_bvh(const std::vector<std::array<Vec<float>, 3>>&);
template Bvh<double> build_bvh(const std::vector<std::array<Vec<double>, 3>>&);
template Bvh<long double> build_bvh(const std::vector<std::array<Vec<long double>, 3>>&);
template Bvh<Quad> build_bvh(const std::vector<std::array<Vec<Quad>, 3>>&);

}  // namespace litmus

// silhouette.cpp: pairs of triangles by their common edge, and a tree over them.
#include "tracer/silhouette.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

namespace litmus {
namespace {

using V3 = Vec<double>;
using Key = std::array<double, 6>;

constexpr std::size_t kEdgesInLeaf = 4;
constexpr double kSilhouetteMargin = 1e-12;
constexpr double kFacingMargin = 1e-9;  // far above the rounding of a normal

bool before(const V3& a, const V3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

std::vector<MeshEdge> edges_of(const std::vector<std::array<V3, 3>>& triangles) {
  struct Found {
    MeshEdge edge;
    int triangles = 0;
  };
  std::map<Key, Found> found;
  for (const auto& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      V3 a = corners[i], b = corners[(i + 1) % 3];
      const bool turned = before(b, a);
      if (turned) std::swap(a, b);
      Found& one = found[{a.x, a.y, a.z, b.x, b.y, b.z}];
      one.edge.a = a, one.edge.b = b;
      if (one.triangles == 0) one.edge.turned = turned;
      if (one.triangles < 2) one.edge.opposite[std::size_t(one.triangles)] = corners[(i + 2) % 3];
      ++one.triangles;
    }
  }
  std::vector<MeshEdge> edges;
  for (auto& [key, one] : found) {
    one.edge.shared = one.triangles == 2;
    edges.push_back(one.edge);
  }
  return edges;
}

void grow(BoxSurface<double>& box, const V3& p) {
  box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
  box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
}

/// The normals of an edge's triangles, so that both face a point or both face away where the
/// surface goes on. As the first one is wound: all alike on a well-made mesh.
std::array<V3, 2> normals_of(const MeshEdge& edge) {
  const V3 along = edge.turned ? edge.a - edge.b : edge.b - edge.a;
  return {normalize(cross(along, edge.opposite[0] - edge.a)),
          normalize(cross(edge.opposite[1] - edge.a, along))};
}

void find_facing(EdgeTree::Node& node, std::span<const MeshEdge> edges) {
  V3 sum;
  std::vector<V3> normals;
  for (const MeshEdge& edge : edges) {
    if (!edge.shared) return;
    for (const V3& normal : normals_of(edge)) sum = sum + normal, normals.push_back(normal);
  }
  node.facing = normalize(sum);
  node.cosine = 1;
  for (const V3& normal : normals) node.cosine = std::min(node.cosine, dot(node.facing, normal));
}

/// Whether all triangles at a node's edges surely face the apex, or all of them face away.
bool face_one_way(const EdgeTree::Node& node, const V3& apex) {
  if (!(node.cosine > 0)) return false;
  const V3 to = 0.5 * node.box.min + 0.5 * node.box.max - apex, size = node.box.max - node.box.min;
  const double along = std::fabs(dot(node.facing, to)), squared = dot(to, to);
  const double across = std::sqrt(std::max(0.0, squared - along * along));
  const double sine = std::sqrt(1 - node.cosine * node.cosine);
  const double reach = 0.5 * std::sqrt(dot(size, size)) + kFacingMargin * std::sqrt(squared);
  return along * node.cosine - across * sine > reach;
}

/// Splits the edges at the median of their middles along the longest side.
void build(EdgeTree& tree, std::size_t begin, std::size_t end) {
  const std::size_t index = tree.nodes.size();
  tree.nodes.emplace_back();
  BoxSurface<double> box{tree.edges[begin].a, tree.edges[begin].a};
  for (std::size_t i = begin; i < end; ++i) grow(box, tree.edges[i].a), grow(box, tree.edges[i].b);
  tree.nodes[index].box = box;
  find_facing(tree.nodes[index], std::span(tree.edges).subspan(begin, end - begin));
  if (end - begin <= kEdgesInLeaf) {
    tree.nodes[index].first = std::uint32_t(begin),
    tree.nodes[index].count = std::uint32_t(end - begin);
    return;
  }
  const V3 size = box.max - box.min;
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return tree.edges.begin() + std::ptrdiff_t(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](const MeshEdge& p, const MeshEdge& q) {
    return p.a[axis] + p.b[axis] < q.a[axis] + q.b[axis];
  });
  build(tree, begin, middle);
  tree.nodes[index].first = std::uint32_t(tree.nodes.size());
  build(tree, middle, end);
}

/// Whether the triangles at an edge are on different sides of the plane through it and the apex,
/// from which everything is counted.
bool goes_on(const MeshEdge& edge, const V3& apex) {
  if (!edge.shared) return false;
  const V3 normal = cross(edge.a - apex, edge.b - apex);
  const V3 p = edge.opposite[0] - apex, q = edge.opposite[1] - apex;
  const double limit = kSilhouetteMargin * max_abs(normal) * std::max(max_abs(p), max_abs(q));
  const double s = dot(normal, p), t = dot(normal, q);
  return (s > limit && t < -limit) || (s < -limit && t > limit);
}

}  // namespace

EdgeTree edge_tree(const std::vector<std::array<V3, 3>>& triangles) {
  EdgeTree tree;
  tree.edges = edges_of(triangles);
  if (!tree.edges.empty()) build(tree, 0, tree.edges.size());
  return tree;
}

void find_shadow_ends(const EdgeTree& tree, const V3& apex, const Shaft& shaft,
                      std::vector<std::uint32_t>& found) {
  if (tree.nodes.empty()) return;
  std::uint32_t stack[64];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const EdgeTree::Node& node = tree.nodes[index];
    if (face_one_way(node, apex)) continue;
    if (!may_meet(shaft, BoxSurface<double>{node.box.min - apex, node.box.max - apex})) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const MeshEdge& edge = tree.edges[i];
      if (!goes_on(edge, apex) && may_meet(shaft, edge.a - apex, edge.b - apex)) found.push_back(i);
    }
  }
}

}  // namespace litmus

// closed_form_facets.cpp: triangles sorted into the cells of a picture of their mesh.
#include "reference/closed_form_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace litmus {
namespace {

constexpr double kMargin = 1e-6;  // of the picture's extent: far above what rounding moves

glm::dvec3 middle_of(const Mesh& mesh) {
  glm::dvec3 low = mesh.vertices.front(), high = low;
  for (const Point& vertex : mesh.vertices)
    low = glm::min(low, vertex), high = glm::max(high, vertex);
  return low + (high - low) * 0.5;
}

/// The axis along which this vector is shortest.
glm::dvec3 across(const glm::dvec3& v) {
  const glm::dvec3 size = glm::abs(v);
  if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
  return size.y <= size.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
}

}  // namespace

FacetMap::FacetMap(const Mesh& mesh, const PencilEnd& end) : end_(end) {
  std::vector<glm::dvec2> seen;
  forward_ = end.parallel ? end.to : middle_of(mesh) - end.to;
  whole_ = glm::length(forward_) == 0;
  if (!whole_) {
    forward_ = glm::normalize(forward_);
    right_ = glm::normalize(glm::cross(forward_, across(forward_)));
    up_ = glm::cross(right_, forward_);
    for (const Point& vertex : mesh.vertices) {
      double depth = 1;
      seen.push_back(project(vertex, depth));
      whole_ |= depth <= 0;
    }
  }
  const std::size_t count = mesh.triangles.size();
  if (whole_) {
    indices_.resize(count);
    std::iota(indices_.begin(), indices_.end(), 0);
    return;
  }
  glm::dvec2 high = low_ = seen.front();
  for (const glm::dvec2& point : seen) low_ = glm::min(low_, point), high = glm::max(high, point);
  const glm::dvec2 margin(kMargin * std::max(high.x - low_.x, high.y - low_.y));
  low_ -= margin;
  side_ = std::clamp(int(std::sqrt(double(count))), 1, 256);
  cell_ = (high + margin - low_) / double(side_);
  std::vector<std::vector<std::int32_t>> filled(std::size_t(side_) * std::size_t(side_));
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const glm::dvec2 p = seen[std::size_t(a)], q = seen[std::size_t(b)], r = seen[std::size_t(c)];
    const glm::dvec2 least = glm::min(glm::min(p, q), r) - margin,
                     most = glm::max(glm::max(p, q), r) + margin;
    const auto columns = cells(least.x, most.x, 0), rows = cells(least.y, most.y, 1);
    for (int y = rows[0]; y <= rows[1]; ++y)
      for (int x = columns[0]; x <= columns[1]; ++x)
        filled[std::size_t(y) * std::size_t(side_) + std::size_t(x)].push_back(std::int32_t(i));
  }
  starts_.push_back(0);
  for (const auto& each : filled) {
    indices_.insert(indices_.end(), each.begin(), each.end());
    starts_.push_back(std::int32_t(indices_.size()));
  }
}

glm::dvec2 FacetMap::project(const glm::dvec3& point, double& depth) const {
  const glm::dvec3 apart = end_.parallel ? point : point - end_.to;
  const glm::dvec2 flat(glm::dot(apart, right_), glm::dot(apart, up_));
  if (end_.parallel) return flat;
  depth = glm::dot(apart, forward_);
  return depth > 0 ? flat / depth : flat;
}

std::array<int, 2> FacetMap::cells(double from, double to, int axis) const {
  const auto index = [&](double at) {
    return std::clamp(int(std::floor((at - low_[axis]) / cell_[axis])), 0, side_ - 1);
  };
  return {index(from), index(to)};
}

std::span<const std::int32_t> FacetMap::near(const glm::dvec3& from) const {
  if (whole_) return indices_;
  double depth = 1;
  const glm::dvec2 at = (project(from, depth) - low_) / cell_;
  if (depth <= 0) return {};  // the way stays behind the end, and the mesh is before it
  if (!(at.x >= 0 && at.y >= 0 && at.x < side_ && at.y < side_)) return {};
  const std::size_t cell = std::size_t(at.y) * std::size_t(side_) + std::size_t(at.x);
  return std::span(indices_).subspan(std::size_t(starts_[cell]),
                                     std::size_t(starts_[cell + 1] - starts_[cell]));
}

}  // namespace litmus

// area_grid.cpp: the frame and the grid of slides 19 and 20.
#include "exporters/area_grid.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/refusal.h"

namespace litmus {
namespace {

// hypot neither overflows nor underflows where squares do.
Vector unit(const Vector& v, const char* what) {
  const double length = std::hypot(v.x, v.y, v.z);
  if (!(length > 0) || !std::isfinite(length)) {
    throw Refusal(std::string("area light: ") + what);
  }
  return v / length;
}

/// Sample `index` of `count` along a side of length `size`; exactly the negative of sample
/// count - 1 - index, because the numerator is an integer and changes only its sign.
double offset(int index, int count, double size, Placement placement) {
  const int odd = 2 * index + 1 - count;  // ..., -3, -1, 1, 3, ... or ..., -2, 0, 2, ...
  if (placement == Placement::Centres) return odd * size / (2.0 * count);
  return count == 1 ? 0.0 : odd * size / (2.0 * (count - 1));
}

}  // namespace

GridAxes grid_axes(const AreaLight& light) {
  const Vector n = unit(light.normal.value_or(-light.point.origin),
                        "normal: has no length; a light at the origin needs a normal of its own");
  Vector right(1, 0, 0);
  if (light.right) {
    const Vector given = unit(*light.right, "right: has no length");
    const Vector across = given - glm::dot(given, n) * n;
    // What is left of a vector along n is rounding, a few 1e-16, and points anywhere.
    if (glm::length(across) < 1e-12) {
      throw Refusal("area light: right: is parallel to the normal; give one that is not");
    }
    right = unit(across, "right: is parallel to the normal");
  } else if (n.x != 0 || n.y != 0) {
    right = unit(Vector(-n.y, n.x, 0), "normal");  // (0,0,1) x n, exactly
  }
  return {right, glm::cross(n, right), n};
}

std::vector<Point> area_samples(const AreaLight& light) {
  if (light.columns < 1 || light.rows < 1) {
    throw Refusal("area light: columns and rows: must be at least 1");
  }
  const GridAxes frame = grid_axes(light);
  std::vector<Point> samples;
  samples.reserve(std::size_t(light.columns) * std::size_t(light.rows));
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.columns; ++column) {
      const double x = offset(column, light.columns, light.width, light.placement);
      const double y = offset(row, light.rows, light.height, light.placement);
      samples.push_back(light.point.origin + x * frame.right + y * frame.up);
    }
  }
  return samples;
}

}  // namespace litmus

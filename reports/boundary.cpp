// boundary.cpp: looks around a pixel's centre for the value that a reference shows.
#include "reports/boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace litmus {
namespace {

constexpr int kDirections = 12;

glm::dvec3 value_at(const Probe& probe, double x, double y, std::size_t layer) {
  const std::vector<glm::dvec3> colors = probe(x, y);
  if (layer < colors.size()) return colors[layer];
  glm::dvec3 total{0};
  for (const glm::dvec3& color : colors) total += color;
  return total;
}

bool close(const glm::dvec3& a, const glm::dvec3& b, double slack) {
  return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)}) <= slack;
}

}  // namespace

std::optional<double> boundary_distance(const Probe& probe, int x, int y, std::size_t layer,
                                        const glm::dvec3& theirs, double slack) {
  for (double radius = kBoundaryPixels / 1024; radius <= kBoundaryPixels; radius *= 2) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      const double dx = radius * std::cos(angle), dy = radius * std::sin(angle);
      if (close(value_at(probe, x + 0.5 + dx, y + 0.5 + dy, layer), theirs, slack)) return radius;
    }
  }
  return std::nullopt;
}

}  // namespace litmus

// closed_form_light.cpp: slides 8 to 20, literally.
#include "reference/closed_form_light.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/overload.h"

namespace litmus {
namespace {

/// Where sample i of n lies along a side of length 1: the middles of n equal cells, or n places
/// from end to end.
Exact along_side(int i, int n, Placement placement) {
  if (placement == Placement::Corners && n > 1) return Exact(i) / (n - 1) - 0.5L;
  return (i + 0.5L) / n - 0.5L;
}

std::vector<ExactLamp> samples_of(const AreaLight& area) {
  const ExactVec centre(area.point.origin);
  const ExactVec n = glm::normalize(area.normal ? ExactVec(*area.normal) : -centre);
  ExactVec right = glm::cross(ExactVec(0, 0, 1), n);
  if (area.right)
    right = ExactVec(*area.right) - glm::dot(ExactVec(*area.right), n) * n;
  else if (right == ExactVec(0))
    right = {1, 0, 0};
  right = glm::normalize(right);
  const ExactVec up = glm::cross(n, right);
  std::vector<ExactLamp> lamps;
  for (int row = 0; row < area.rows; ++row)
    for (int column = 0; column < area.columns; ++column) {
      const Exact x = along_side(column, area.columns, area.placement) * area.width;
      const Exact y = along_side(row, area.rows, area.placement) * area.height;
      lamps.push_back({false, centre + x * right + y * up, area.point.attenuation, std::nullopt,
                       1.0L / (Exact(area.columns) * area.rows)});
    }
  return lamps;
}

}  // namespace

std::vector<ExactLamp> exact_lamps(const Light& light) {
  using Lamps = std::vector<ExactLamp>;
  return std::visit(
      Overload{[](const DirectionalLight& sun) {
                 return Lamps{{true, -glm::normalize(ExactVec(sun.direction))}};
               },
               [](const PointLight& point) {
                 return Lamps{{false, ExactVec(point.origin), point.attenuation}};
               },
               [](const SpotLight& spot) {
                 return Lamps{{false, ExactVec(spot.point.origin), spot.point.attenuation,
                               ExactCone{glm::normalize(ExactVec(spot.direction)), spot.cutoff,
                                         spot.exponent}}};
               },
               [](const AreaLight& area) { return samples_of(area); }},
      light.shape);
}

Exact angle_off_axis(const ExactLamp& lamp, const ExactVec& point) {
  const ExactVec way = glm::normalize(point - lamp.place);
  // Kahan's formula, which keeps its digits at 0 and at pi.
  return 2 * std::atan2(glm::length(lamp.cone->axis - way), glm::length(lamp.cone->axis + way));
}

Exact arriving(const ExactLamp& lamp, const ExactVec& point) {
  if (lamp.sun) return lamp.share;
  const Exact d = glm::length(lamp.place - point);
  const Exact R = lamp.attenuation.range, L = lamp.attenuation.linear,
              Q = lamp.attenuation.quadratic;
  Exact arrives = lamp.share * (R / (R + L * d)) * (R * R / (R * R + Q * d * d));
  if (lamp.cone) {
    const Exact alpha = angle_off_axis(lamp, point), cutoff = lamp.cone->cutoff;
    arrives *= alpha > cutoff ? 0 : 1 - std::pow(alpha / cutoff, lamp.cone->exponent);
  }
  return arrives;
}

}  // namespace litmus

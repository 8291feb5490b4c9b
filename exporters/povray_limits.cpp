// povray_limits.cpp: the sizes of the exact POV-Ray export, and what they leave inexact.
#include "exporters/povray_limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "exporters/area_grid.h"
#include "exporters/envelope.h"
#include "scene/overload.h"
#include "exporters/povray.h"
#include "exporters/povray_parts.h"
#include "exporters/text.h"

namespace litmus {
namespace povray {

double unit_of(const Scene& scene) {
  if (stays_unmoved(scene)) return 1;
  const double radius = extent_radius(scene);
  return radius > 0 ? std::ldexp(1.0, 8 - std::ilogb(radius)) : 32;
}

double filter_radius(const Point& lamp) { return std::max(1.25e-3, 2e-6 * glm::length(lamp)); }

bool has_medium(const Light& light) {
  const Attenuation a = attenuation_of(light);
  return a.linear > 0 && a.quadratic > 0;
}

namespace {

// The distance from a point to the surface of an object, at least roughly; vertices for meshes.
double distance_to(const Object& object, const Point& p) {
  const auto to_vertices = [&](const auto& vertices) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& v : vertices) nearest = std::min(nearest, glm::distance(p, v));
    return nearest;
  };
  return std::visit(
      Overload{[&](const Sphere& s) { return std::abs(glm::distance(p, s.center) - s.radius); },
               [&](const Plane& plane) {
                 return std::abs(glm::dot(p - plane.point, glm::normalize(plane.normal)));
               },
               [&](const Box& b) {
                 const Vector outside = glm::max(glm::max(b.min - p, p - b.max), Vector(0));
                 const Vector inside = glm::min(p - b.min, b.max - p);
                 return outside == Vector(0) ? std::min({inside.x, inside.y, inside.z})
                                             : glm::length(outside);
               },
               [&](const Triangle& t) {
                 return to_vertices(std::array{t.a, t.b, t.c});
               },
               [&](const Mesh& m) { return to_vertices(m.vertices); }},
      object.shape);
}

void add_caveats(const Scene& scene, const Light& light, std::vector<std::string>& caveats) {
  std::vector<Point> lamps;
  if (auto* point = std::get_if<PointLight>(&light.shape)) lamps = {point->origin};
  if (auto* spot = std::get_if<SpotLight>(&light.shape)) lamps = {spot->point.origin};
  if (auto* area = std::get_if<AreaLight>(&light.shape)) lamps = area_samples(*area);
  const double unit = unit_of(scene);
  const bool filtered = has_medium(light) || std::holds_alternative<SpotLight>(light.shape);
  constexpr double kFarthest = 1e6;  // a tenth of POV-Ray's limit
  for (const Point& lamp : lamps) {
    if (glm::length(lamp) * unit > (has_medium(light) ? kMediumReach : kFarthest)) {
      caveats.push_back(
          fmt::format("\"{}\": too far away for POV-Ray, beside the size of the "
                      "scene; its light may be wrong or missing.",
                      light.name));
      return;
    }
    const double radius = filter_radius(unit * lamp) / unit;
    for (const Object& object : scene.objects)
      if (filtered && distance_to(object, lamp) < 2 * radius) {
        caveats.push_back(
            fmt::format("\"{}\": within {} of \"{}\", where the filter round the lamp "
                        "is; the light there is wrong.",
                        light.name, number(2 * radius), object.name));
        return;
      }
  }
}

}  // namespace
}  // namespace povray

std::vector<std::string> povray_caveats(const Scene& original) {
  using namespace povray;
  const Scene scene = into_envelope(original);
  std::vector<std::string> caveats;
  for (const Light& light : scene.lights) add_caveats(scene, light, caveats);
  return caveats;
}

}  // namespace litmus

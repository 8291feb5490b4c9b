// closed_form_curves.cpp: conics, and convex hulls of corners.
#include "reference/closed_form_curves.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "scene/refusal.h"

namespace litmus {
namespace {

constexpr Exact kRightAngle = std::numbers::pi_v<Exact> / 2;

/// The direction of v on the floor; any where v is vertical.
FloorPoint floor_axis(const ExactVec& v) {
  const FloorPoint flat(v.x, v.y);
  const Exact length = glm::length(flat);
  return length > 0 ? flat / length : FloorPoint(1, 0);
}

/// The corner's shadow: along the line from the lamp through it.
FloorPoint projected(const Point& corner, const ExactLamp& lamp, Exact level) {
  const ExactVec c(corner);
  const Exact h = c.z - level;
  if (lamp.sun)
    return FloorPoint(c.x, c.y) - h / lamp.place.z * FloorPoint(lamp.place.x, lamp.place.y);
  const Exact H = lamp.place.z - level;
  if (!(h < H) || h < 0) throw Refusal("a caster with corners must be between floor and lamp");
  const FloorPoint below(lamp.place.x, lamp.place.y);
  return below + (FloorPoint(c.x, c.y) - below) * (H / (H - h));
}

/// Twice the area of the triangle, positive if counterclockwise.
Exact turn(const FloorPoint& a, const FloorPoint& b, const FloorPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Andrew's monotone chain.
std::vector<FloorPoint> hull_of(std::vector<FloorPoint> points) {
  std::sort(points.begin(), points.end(), [](const FloorPoint& a, const FloorPoint& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  std::vector<FloorPoint> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const FloorPoint& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // begins the other chain
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

Conic cone_on_floor(const ExactVec& apex, const ExactVec& axis, Exact beta, Exact level) {
  const FloorPoint u = floor_axis(axis);
  const Exact H = apex.z - level;
  const Exact phi = std::atan2(glm::length(FloorPoint(axis.x, axis.y)), -axis.z);
  Conic conic;
  if (phi - beta >= kRightAngle) {
    conic.none = true;
    return conic;
  }
  const Exact t1 = H * std::tan(phi - beta), t2 = H * std::tan(phi + beta);
  const Exact e = std::sin(phi) / std::cos(beta);
  conic.hyperbola = phi + beta > kRightAngle;
  conic.axis = u;
  conic.centre = FloorPoint(apex.x, apex.y) + u * ((t1 + t2) / 2);
  conic.a = std::fabs(t2 - t1) / 2;
  conic.b = conic.a * std::sqrt(std::fabs(1 - e * e));
  return conic;
}

Conic sun_shadow(const Sphere& sphere, const ExactVec& toward_sun, Exact level) {
  const ExactVec centre(sphere.center);
  const Exact slide = (centre.z - level) / toward_sun.z;
  Conic conic;
  conic.axis = floor_axis(toward_sun);
  conic.centre = FloorPoint(centre.x, centre.y) - slide * FloorPoint(toward_sun.x, toward_sun.y);
  conic.a = sphere.radius / toward_sun.z;
  conic.b = sphere.radius;
  return conic;
}

Conic lamp_shadow(const Sphere& sphere, const ExactVec& lamp, Exact level) {
  const ExactVec apart = ExactVec(sphere.center) - lamp;
  const Exact distance = glm::length(apart);
  return cone_on_floor(lamp, apart / distance, std::asin(sphere.radius / distance), level);
}

Exact depth(const Conic& conic, const FloorPoint& point) {
  if (conic.none) return -1;
  const FloorPoint apart = point - conic.centre;
  const Exact t = glm::dot(apart, conic.axis) / conic.a;
  const Exact v = (conic.axis.x * apart.y - conic.axis.y * apart.x) / conic.b;
  if (!conic.hyperbola) return 1 - t * t - v * v;
  return t > 0 ? t * t - v * v - 1 : -1;
}

std::vector<FloorPoint> corner_shadow(const Object& object, const ExactLamp& lamp, Exact level) {
  std::vector<FloorPoint> corners;
  if (const auto* box = std::get_if<Box>(&object.shape)) {
    for (const double x : {box->min.x, box->max.x})
      for (const double y : {box->min.y, box->max.y})
        for (const double z : {box->min.z, box->max.z})
          corners.push_back(projected({x, y, z}, lamp, level));
  } else if (const auto* triangle = std::get_if<Triangle>(&object.shape)) {
    for (const Point& corner : {triangle->a, triangle->b, triangle->c})
      corners.push_back(projected(corner, lamp, level));
  } else {
    throw Refusal("\"" + object.name + "\" has no corners");
  }
  return hull_of(std::move(corners));
}

Exact depth(const std::vector<FloorPoint>& polygon, const FloorPoint& point) {
  Exact nearest = std::numeric_limits<Exact>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FloorPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    nearest = std::min(nearest, turn(a, b, point) / glm::distance(a, b));
  }
  return nearest;
}

}  // namespace litmus

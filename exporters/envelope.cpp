// envelope.cpp: recentres and rescales a scene by a power of two.
#include "exporters/envelope.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "exporters/seen_points.h"
#include "scene/overload.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

constexpr double kSmallest = 0.5, kLargest = 200;  // radii that are left as they are
constexpr double kOffCentre = 2;                   // the origin may lie this many radii away
constexpr double kFar = 16;                        // eyes and lights further out do not count

struct Extent {
  Point low{std::numeric_limits<double>::infinity()}, high{-low};
  bool empty() const { return low.x > high.x; }
  Point centre() const { return low + (high - low) * 0.5; }
  double radius() const { return glm::length(high - low) * 0.5; }
  void add(const Point& p) { low = glm::min(low, p), high = glm::max(high, p); }
};

void add_bounded(Extent& extent, const Object& object) {
  std::visit(
      Overload{[&](const Sphere& s) {
                 extent.add(s.center - s.radius);
                 extent.add(s.center + s.radius);
               },
               [&](const Plane&) {}, [&](const Box& b) { extent.add(b.min), extent.add(b.max); },
               [&](const Triangle& t) { extent.add(t.a), extent.add(t.b), extent.add(t.c); },
               [&](const Mesh& m) {
                 for (const Point& p : m.vertices) extent.add(p);
               }},
      object.shape);
}

// The rays through the middle and the corners of the picture.
std::vector<SightRay> outline_rays(const Scene& scene) {
  std::vector<SightRay> rays{sight_ray(scene, 0, 0)};
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) rays.push_back(sight_ray(scene, x, y));
  return rays;
}

// Where the outline of the picture meets planes. A hit near the horizon says nothing about the size
// of the scene, so only hits within twice the nearest distance of each plane count.
void add_planes(Extent& extent, const Scene& scene) {
  const std::vector<SightRay> rays = outline_rays(scene);
  for (const Object& object : scene.objects) {
    const Plane* plane = std::get_if<Plane>(&object.shape);
    if (!plane) continue;
    std::vector<std::pair<double, Point>> hits;
    double nearest = std::numeric_limits<double>::infinity();
    for (const SightRay& ray : rays) {
      const double t = glm::dot(plane->point - ray.origin, plane->normal) /
                       glm::dot(ray.direction, plane->normal);
      if (!(t > 0) || !std::isfinite(t)) continue;
      const double distance = t * glm::length(ray.direction);
      hits.emplace_back(distance, ray.origin + ray.direction * t);
      nearest = std::min(nearest, distance);
    }
    for (const auto& [distance, hit] : hits)
      if (distance <= 2 * nearest) extent.add(hit);
  }
}

const PointLight* positional(const Light& light) {
  if (auto* point = std::get_if<PointLight>(&light.shape)) return point;
  if (auto* spot = std::get_if<SpotLight>(&light.shape)) return &spot->point;
  if (auto* area = std::get_if<AreaLight>(&light.shape)) return &area->point;
  return nullptr;
}

Extent extent_of(const Scene& scene) {
  Extent extent;
  for (const Object& object : scene.objects) add_bounded(extent, object);
  add_planes(extent, scene);
  std::vector<Point> others{scene.camera.eye};
  for (const Light& light : scene.lights)
    if (const PointLight* point = positional(light)) others.push_back(point->origin);
  const Extent core = extent;
  for (const Point& p : others)
    if (core.empty() || glm::distance(p, core.centre()) <= kFar * core.radius()) extent.add(p);
  return extent;
}

void resolve_normal(Light& light) {
  AreaLight* area = std::get_if<AreaLight>(&light.shape);
  if (!area || area->normal) return;
  if (area->point.origin == Point(0))
    throw Refusal(fmt::format("light \"{}\": normal: a light at the origin needs one", light.name));
  area->normal = -area->point.origin;
}

void apply(const Envelope& envelope, Object& object) {
  const auto move = [&](Point& p) { p = (p - envelope.centre) * envelope.scale; };
  std::visit(Overload{[&](Sphere& s) { move(s.center), s.radius *= envelope.scale; },
                      [&](Plane& p) { move(p.point); }, [&](Box& b) { move(b.min), move(b.max); },
                      [&](Triangle& t) { move(t.a), move(t.b), move(t.c); },
                      [&](Mesh& m) {
                        for (Point& p : m.vertices) move(p);
                      }},
             object.shape);
}

void apply(const Envelope& envelope, Light& light) {
  const auto place = [&](PointLight& p) {
    p.origin = (p.origin - envelope.centre) * envelope.scale;
    p.attenuation.range *= envelope.scale;
  };
  std::visit(Overload{[&](DirectionalLight&) {}, [&](PointLight& p) { place(p); },
                      [&](SpotLight& s) { place(s.point); },
                      [&](AreaLight& a) {
                        place(a.point);
                        a.width *= envelope.scale;
                        a.height *= envelope.scale;
                      }},
             light.shape);
}

}  // namespace

bool stays_unmoved(const Scene& scene) {
  return std::find(scene.tags.begin(), scene.tags.end(), "unmoved") != scene.tags.end();
}

Envelope envelope_of(const Scene& scene) {
  if (stays_unmoved(scene)) return {};
  const Extent extent = extent_of(scene);
  const double radius = extent.radius();
  if (extent.empty() || !(radius > 0) || !std::isfinite(radius)) return {};
  const bool near = glm::length(extent.centre()) <= kOffCentre * radius;
  if (near && radius >= kSmallest && radius <= kLargest) return {};
  return {extent.centre(), std::ldexp(1.0, 3 - std::ilogb(radius))};
}

double extent_radius(const Scene& scene) {
  const Extent extent = extent_of(scene);
  return extent.empty() ? 0 : extent.radius();
}

Scene into_envelope(const Scene& scene) {
  Scene moved = scene;
  for (Light& light : moved.lights) resolve_normal(light);
  const Envelope envelope = envelope_of(scene);
  if (envelope.identity()) return moved;
  for (Object& object : moved.objects) apply(envelope, object);
  for (Light& light : moved.lights) apply(envelope, light);
  moved.camera.eye = (moved.camera.eye - envelope.centre) * envelope.scale;
  moved.camera.target = (moved.camera.target - envelope.centre) * envelope.scale;
  moved.camera.height *= envelope.scale;
  return moved;
}

}  // namespace litmus

// blender_geometry.cpp: bounds of what is seen and of what casts shadows.
#include "exporters/blender_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "exporters/area_grid.h"

namespace litmus {
namespace {

constexpr double kFarthest = 1e6;      // scene units in the envelope
constexpr double kInnerHalfSize = 32;  // of the first rectangle, and the factor to the next
constexpr double kGrowth = 4;
constexpr double kMargin = 0.01;  // of the size, so that no edge touches a ray

struct View {
  Point eye;
  Vector forward, right, up;  // right and up reach to the border of the picture
  bool flat;

  // The ray through (x, y) in -1..1, and its direction, not normalised.
  Point origin(double x, double y) const { return flat ? eye + x * right + y * up : eye; }
  Vector direction(double x, double y) const {
    return flat ? forward : forward + x * right + y * up;
  }
};

View view_of(const Camera& camera, double aspect) {
  View view;
  view.eye = camera.eye;
  view.flat = camera.projection == Projection::Orthographic;
  view.forward = glm::normalize(camera.target - camera.eye);
  const double half = view.flat ? camera.height / 2 : std::tan(camera.fov / 2);
  const Vector right = glm::normalize(glm::cross(view.forward, camera.up));
  view.right = half * aspect * right;
  view.up = half * glm::cross(right, view.forward);
  return view;
}

double aspect_of(const Scene& scene) { return double(scene.width) / scene.height; }

/// A plane's own coordinates.
struct PlaneAxes {
  Point centre;  // the point of the plane nearest to the origin
  Vector n, u, v;
};

PlaneAxes frame_of(const Plane& plane) {
  PlaneAxes frame;
  frame.n = glm::normalize(plane.normal);
  frame.centre = glm::dot(plane.point, frame.n) * frame.n;
  const Vector size = glm::abs(frame.n);
  const Vector axis = size.x <= size.y && size.x <= size.z ? Vector(1, 0, 0)
                      : size.y <= size.z                   ? Vector(0, 1, 0)
                                                           : Vector(0, 0, 1);
  frame.u = glm::normalize(axis - glm::dot(axis, frame.n) * frame.n);
  frame.v = glm::cross(frame.n, frame.u);
  return frame;
}

/// A rectangle in a plane's own coordinates.
struct Rectangle {
  double u0 = std::numeric_limits<double>::infinity(), u1 = -u0, v0 = u0, v1 = -u0;

  bool empty() const { return u0 > u1; }
  void add(const PlaneAxes& frame, const Point& p) {
    const double u = glm::dot(p - frame.centre, frame.u), v = glm::dot(p - frame.centre, frame.v);
    u0 = std::min(u0, u), u1 = std::max(u1, u);
    v0 = std::min(v0, v), v1 = std::max(v1, v);
  }
  std::array<Point, 4> corners(const PlaneAxes& f) const {
    const auto at = [&](double u, double v) { return f.centre + u * f.u + v * f.v; };
    return {at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)};
  }
};

/// What the picture shows of a plane if nothing is in front of it.
Rectangle visible_part(const Scene& scene, const PlaneAxes& frame) {
  const View view = view_of(scene.camera, aspect_of(scene));
  Rectangle part;
  const int columns = scene.width * scene.samples, rows = scene.height * scene.samples;
  for (int j = 0; j < rows; ++j) {
    const double y = 1 - (2.0 * j + 1) / rows;
    for (int i = 0; i < columns; ++i) {
      const double x = (2.0 * i + 1) / columns - 1;
      const Point origin = view.origin(x, y);
      const Vector direction = view.direction(x, y);
      const double t = glm::dot(frame.centre - origin, frame.n) / glm::dot(direction, frame.n);
      if (!(t > 0) || !(t < kFarthest)) continue;
      part.add(frame, origin + t * direction);
    }
  }
  return part;
}

struct Bounds {
  Point low{std::numeric_limits<double>::infinity()}, high{-low};
  void add(const Point& p) { low = glm::min(low, p), high = glm::max(high, p); }
};

/// The corners of the box around an object; none around a plane.
std::vector<Point> box_corners(const Object& object) {
  Bounds b;
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
    b.add(sphere->center - sphere->radius), b.add(sphere->center + sphere->radius);
  } else if (const auto* box = std::get_if<Box>(&object.shape)) {
    b.add(box->min), b.add(box->max);
  } else if (const auto* triangle = std::get_if<Triangle>(&object.shape)) {
    b.add(triangle->a), b.add(triangle->b), b.add(triangle->c);
  } else if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
    for (const Point& p : mesh->vertices) b.add(p);
  }
  std::vector<Point> corners;
  if (b.low.x > b.high.x) return corners;
  for (int k = 0; k < 8; ++k) {
    corners.emplace_back(k & 1 ? b.high.x : b.low.x, k & 2 ? b.high.y : b.low.y,
                         k & 4 ? b.high.z : b.low.z);
  }
  return corners;
}

/// Points whose convex hull holds every surface that can be seen.
std::vector<Point> receivers(const Scene& scene) {
  std::vector<Point> points;
  for (const Object& object : scene.objects) {
    for (const Point& corner : box_corners(object)) points.push_back(corner);
    if (const auto* plane = std::get_if<Plane>(&object.shape)) {
      const PlaneAxes frame = frame_of(*plane);
      const Rectangle part = visible_part(scene, frame);
      if (part.empty()) continue;
      for (const Point& corner : part.corners(frame)) points.push_back(corner);
    }
  }
  return points;
}

std::vector<Point> lamp_positions(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light.shape)) return {point->origin};
  if (const auto* spot = std::get_if<SpotLight>(&light.shape)) return {spot->point.origin};
  if (const auto* area = std::get_if<AreaLight>(&light.shape)) return area_samples(*area);
  return {};
}

/// Grows `part` by where the plane may stand between a surface and a lamp. The crossing lies
/// between both, hence within the box around their feet on the plane; or, under a sun, where the
/// sun's rays carry the surface.
void add_shadow_casters(const Scene& scene, const PlaneAxes& frame, Rectangle& part) {
  const std::vector<Point> points = receivers(scene);
  const auto height = [&](const Point& p) { return glm::dot(p - frame.centre, frame.n); };
  for (const Light& light : scene.lights) {
    if (const auto* sun = std::get_if<DirectionalLight>(&light.shape)) {
      const Vector towards = -glm::normalize(sun->direction);
      for (const Point& p : points) {
        const double t = -height(p) / glm::dot(towards, frame.n);
        if (t > 0 && t < kFarthest) part.add(frame, p), part.add(frame, p + t * towards);
      }
    }
    for (const Point& lamp : lamp_positions(light)) {
      for (const Point& p : points) {
        if (height(p) * height(lamp) < 0) part.add(frame, p), part.add(frame, lamp);
      }
    }
  }
}

}  // namespace

std::vector<std::array<Point, 4>> plane_rectangles(const Scene& scene, const Plane& plane) {
  const PlaneAxes frame = frame_of(plane);
  Rectangle all = visible_part(scene, frame);
  if (scene.shadows) add_shadow_casters(scene, frame, all);
  if (all.empty()) return {};
  const double margin = kMargin * std::max({all.u1 - all.u0, all.v1 - all.v0, 1e-3});
  all.u0 -= margin, all.u1 += margin, all.v0 -= margin, all.v1 += margin;

  // Nest squares around the part's point nearest to the scene's middle, cut to the part.
  const double u = std::clamp(0.0, all.u0, all.u1), v = std::clamp(0.0, all.v0, all.v1);
  std::vector<std::array<Point, 4>> rectangles;
  for (double half = kInnerHalfSize;; half *= kGrowth) {
    Rectangle part;
    part.u0 = std::max(all.u0, u - half), part.u1 = std::min(all.u1, u + half);
    part.v0 = std::max(all.v0, v - half), part.v1 = std::min(all.v1, v + half);
    rectangles.push_back(part.corners(frame));
    if (part.u0 == all.u0 && part.u1 == all.u1 && part.v0 == all.v0 && part.v1 == all.v1) break;
  }
  return rectangles;
}

bool holds_eye(const Camera& camera, double aspect, const Sphere& sphere) {
  const Vector apart = sphere.center - camera.eye;
  if (camera.projection == Projection::Perspective) return glm::length(apart) < sphere.radius;
  const View view = view_of(camera, aspect);
  const double depth = glm::dot(apart, view.forward);
  const double across = glm::length(apart - depth * view.forward);
  return std::abs(depth) < sphere.radius &&
         across < sphere.radius + glm::length(view.right) + glm::length(view.up);
}

Point near_eye(const Scene& scene) {
  const Camera& camera = scene.camera;
  if (camera.projection == Projection::Perspective) return camera.eye;
  const View view = view_of(camera, aspect_of(scene));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Object& object : scene.objects) {
    if (!object.camera_visible) continue;
    for (const Point& corner : box_corners(object)) {
      nearest = std::min(nearest, glm::dot(corner - view.eye, view.forward));
    }
    const auto* plane = std::get_if<Plane>(&object.shape);
    if (!plane || glm::dot(plane->normal, view.forward) == 0) continue;
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        nearest = std::min(nearest, glm::dot(plane->point - view.origin(x, y), plane->normal) /
                                        glm::dot(view.forward, plane->normal));
      }
    }
  }
  if (!std::isfinite(nearest) || nearest <= 1) return camera.eye;
  return camera.eye + (nearest - 1) * view.forward;
}

}  // namespace litmus

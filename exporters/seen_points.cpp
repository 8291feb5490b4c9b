// seen_points.cpp: a few rays from the camera.
#include "exporters/seen_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <variant>

namespace litmus {
namespace {

constexpr int kAcross = 24, kDown = 18;
constexpr double kNone = std::numeric_limits<double>::infinity();

/// The smaller of two distances that lies in front of the eye.
double first_of(double near, double far) { return near > 0 ? near : far > 0 ? far : kNone; }

double meet(const SightRay& ray, const Sphere& sphere) {
  const Vector out = ray.origin - sphere.center;
  const double a = glm::dot(ray.direction, ray.direction), b = glm::dot(out, ray.direction);
  const double root = b * b - a * (glm::dot(out, out) - sphere.radius * sphere.radius);
  if (root < 0) return kNone;
  return first_of((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
}

double meet(const SightRay& ray, const Plane& plane) {
  const double t =
      glm::dot(plane.point - ray.origin, plane.normal) / glm::dot(ray.direction, plane.normal);
  return t > 0 ? t : kNone;  // also where the ray runs along the plane
}

double meet(const SightRay& ray, const Box& box) {
  double near = -kNone, far = kNone;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near <= far ? first_of(near, far) : kNone;
}

/// Moeller and Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
double meet(const SightRay& ray, const Triangle& triangle) {
  const Vector u = triangle.b - triangle.a, v = triangle.c - triangle.a;
  const Vector across = glm::cross(ray.direction, v), out = ray.origin - triangle.a;
  const double determinant = glm::dot(u, across);
  const double x = glm::dot(out, across) / determinant;
  const double y = glm::dot(ray.direction, glm::cross(out, u)) / determinant;
  const double t = glm::dot(v, glm::cross(out, u)) / determinant;
  return x >= 0 && y >= 0 && x + y <= 1 && t > 0 ? t : kNone;
}

double meet(const SightRay& ray, const Mesh& mesh) {
  double nearest = kNone;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle triangle{mesh.vertices[std::size_t(a)], mesh.vertices[std::size_t(b)],
                            mesh.vertices[std::size_t(c)]};
    nearest = std::min(nearest, meet(ray, triangle));
  }
  return nearest;
}

}  // namespace

SightRay sight_ray(const Scene& scene, double x, double y) {
  const Camera& c = scene.camera;
  const bool flat = c.projection == Projection::Orthographic;
  const Vector forward = glm::normalize(c.target - c.eye);
  const Vector right = glm::normalize(glm::cross(forward, c.up));
  const Vector up = glm::cross(right, forward);
  const double half = flat ? c.height / 2 : std::tan(c.fov / 2);
  const double aspect = double(scene.width) / scene.height;
  const Vector offset = right * (x * half * aspect) + up * (y * half);
  return flat ? SightRay{c.eye + offset, forward} : SightRay{c.eye, forward + offset};
}

std::vector<Point> seen_points(const Scene& scene) {
  std::vector<Point> points;
  for (int k = 0; k < kAcross * kDown; ++k) {
    const SightRay ray = sight_ray(scene, (2 * (k % kAcross) + 1.0) / kAcross - 1,
                                   (2 * (k / kAcross) + 1.0) / kDown - 1);
    double nearest = kNone;
    for (const Object& object : scene.objects) {
      if (!object.camera_visible) continue;
      nearest = std::min(
          nearest, std::visit([&](const auto& shape) { return meet(ray, shape); }, object.shape));
    }
    if (nearest < kNone) points.push_back(ray.origin + nearest * ray.direction);
  }
  return points;
}

}  // namespace litmus

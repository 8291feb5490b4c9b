// closed_form_surfaces.cpp: where rays meet planes, spheres and boxes.
#include "reference/closed_form_surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/refusal.h"

namespace litmus {
namespace {

bool is_covered(const Object& object, std::span<const Oracle> oracles) {
  const auto named = [&](Oracle oracle) {
    return std::find(oracles.begin(), oracles.end(), oracle) != oracles.end();
  };
  return (std::holds_alternative<Plane>(object.shape) && named(Oracle::Floor)) ||
         (std::holds_alternative<Sphere>(object.shape) && named(Oracle::Spheres)) ||
         (std::holds_alternative<Box>(object.shape) && named(Oracle::Boxes));
}

/// Seen from inside, a surface has no outline, and the far side is what is in view.
void refuse_from_inside(const Scene& scene, const Object& object) {
  const Point& eye = scene.camera.eye;
  const auto* sphere = std::get_if<Sphere>(&object.shape);
  const auto* box = std::get_if<Box>(&object.shape);
  bool inside = sphere && glm::distance(eye, sphere->center) <= sphere->radius;
  if (box) {
    inside = true;
    for (int axis = 0; axis < 3; ++axis)
      inside &= eye[axis] >= box->min[axis] && eye[axis] <= box->max[axis];
  }
  if (inside && scene.camera.projection == Projection::Perspective)
    throw Refusal(scene.name + ": expect: the eye is inside of \"" + object.name +
                  "\", whose closed form is of its outside");
}

std::optional<SeenPoint> sphere_point(const Object& object, const Sight& sight, bool& unsure) {
  const auto& sphere = std::get<Sphere>(object.shape);
  const Exact r = sphere.radius;
  const ExactVec apart = (sight.start - ExactVec(sphere.center)) / r;
  const ExactVec aside = apart - glm::dot(apart, sight.along) * sight.along;
  const Exact under = 1 - glm::dot(aside, aside);
  unsure |= std::fabs(under) < kBoundaryBand;
  if (under <= 0) return std::nullopt;
  const ExactVec n = aside - std::sqrt(under) * sight.along;
  const ExactVec at = ExactVec(sphere.center) + r * n;
  if (glm::dot(at - sight.start, sight.along) <= 0) return std::nullopt;
  return SeenPoint{at, n, -sight.along, &object};
}

std::optional<SeenPoint> box_point(const Object& object, const Sight& sight, bool& unsure) {
  const auto& box = std::get<Box>(object.shape);
  Exact second = 0, enter = 0, leave = std::numeric_limits<Exact>::infinity();
  int face = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const Exact below = Exact(box.min[axis]) - sight.start[axis];
    const Exact above = Exact(box.max[axis]) - sight.start[axis];
    const Exact d = sight.along[axis];
    if (d == 0) {
      const Exact within = std::min(-below, above) / (above - below);
      unsure |= std::fabs(within) < kBoundaryBand;
      if (within < 0) return std::nullopt;
      continue;
    }
    leave = std::min(leave, std::max(below / d, above / d));
    const Exact enters = std::min(below / d, above / d);
    second = std::max(second, std::min(enter, enters));
    if (enters > enter) enter = enters, face = axis;
  }
  // At an edge the ray enters by two faces at once, or enters where it leaves.
  unsure |= face >= 0 && (std::fabs(leave - enter) < kBoundaryBand * enter ||
                          (leave > enter && enter - second < kBoundaryBand * enter));
  if (face < 0 || leave <= enter) return std::nullopt;
  ExactVec n(0);
  n[face] = sight.along[face] > 0 ? -1 : 1;
  ExactVec at = sight.start + enter * sight.along;
  at[face] = sight.along[face] > 0 ? box.min[face] : box.max[face];
  return SeenPoint{at, n, -sight.along, &object};
}

}  // namespace

std::optional<SeenPoint> surface_point(const Object& object, const Sight& sight, bool& unsure) {
  if (std::holds_alternative<Sphere>(object.shape)) return sphere_point(object, sight, unsure);
  if (std::holds_alternative<Box>(object.shape)) return box_point(object, sight, unsure);
  return floor_point(object, sight);
}

SurfaceOracle::SurfaceOracle(const Scene& scene, std::span<const Oracle> oracles)
    : scene_(scene), view_(view_of(scene)) {
  if (std::find(oracles.begin(), oracles.end(), Oracle::Floor) != oracles.end()) floor_of(scene);
  for (const Object& object : scene.objects) {
    if (!object.camera_visible) continue;
    if (is_covered(object, oracles)) {
      refuse_from_inside(scene, object);
      surfaces_.push_back(&object);
    } else {
      nothing_else_ = false;
    }
  }
  if (surfaces_.empty())
    throw Refusal(scene.name + ": expect: the camera sees no floor, sphere or box of the oracles");
  before_eye_ = obstacles(scene, eye_of(view_), true);
  lights_ = exact_lights(scene);
}

std::optional<SeenPoint> SurfaceOracle::nearest(const Sight& sight, bool& unsure) const {
  std::optional<SeenPoint> nearest;
  Exact distance = std::numeric_limits<Exact>::infinity();
  for (const Object* object : surfaces_) {
    const std::optional<SeenPoint> seen = surface_point(*object, sight, unsure);
    if (!seen) continue;
    const Exact far = glm::dot(seen->at - sight.start, sight.along);
    if (far < distance) distance = far, nearest = seen;
  }
  return nearest;
}

SurfaceOracle::Seen SurfaceOracle::see(int x, int y) const {
  const Sight through = sight(view_, x, y);
  bool unsure = false;
  const std::optional<SeenPoint> seen = nearest(through, unsure);
  if (unsure) return {};
  if (!seen) return {nothing_else_ ? PixelTerms::Sees::Nothing : PixelTerms::Sees::Unknown};
  if (passage_through(before_eye_, {seen->at, through.start}, seen->object) != Way::Open) return {};
  return {PixelTerms::Sees::Surface, *seen};
}

PixelTerms SurfaceOracle::at(int x, int y) const {
  const Seen seen = see(x, y);
  PixelTerms terms{seen.sees, seen.point.object, {}};
  if (seen.sees != PixelTerms::Sees::Surface) return terms;
  const Material& material = scene_.materials[std::size_t(seen.point.object->material)];
  for (const ExactLight& light : lights_)
    terms.lights.push_back(terms_at(seen.point, light, material));
  return terms;
}

}  // namespace litmus

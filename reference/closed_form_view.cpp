// closed_form_view.cpp: pixels, planes, and slide 5 once more.
#include "reference/closed_form_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/refusal.h"

namespace litmus {
namespace {

/// The terms of one lamp; `before` is null where nothing casts a shadow.
ExactTerms terms_of(const SeenPoint& seen, const ExactLamp& lamp, const Obstacles* before,
                    const Material& material) {
  if (!lamp.sun && lamp.place == seen.at) return {};  // a lamp on the surface has no direction
  const ExactVec l = lamp.sun ? lamp.place : glm::normalize(lamp.place - seen.at);
  const Exact cosine = glm::dot(l, seen.normal);
  const bool shiny = material.specular != Color(0);
  if (cosine <= 0) return {0, 0, cosine < -kBoundaryBand || !shiny};
  const Exact arrives = arriving(lamp, seen.at);
  if (arrives == 0) return {};  // outside the cone, where the decay begins with 0
  if (before) {
    const Way way = passage_through(*before, {seen.at, lamp.place, lamp.sun}, seen.object);
    if (way != Way::Open) return {0, 0, way == Way::Blocked};
  }
  ExactTerms terms{arrives * cosine};
  if (!shiny) return terms;
  terms.sure = cosine > kBoundaryBand;
  const ExactVec both = l + seen.eye;
  if (const Exact length = glm::length(both); length > 0)
    if (const Exact c = glm::dot(both, seen.normal) / length; c > 0)
      terms.specular = arrives * std::pow(c, Exact(material.shininess));
  return terms;
}

}  // namespace

ExactFrame exact_frame(const Camera& camera) {
  ExactFrame frame;
  frame.forward = glm::normalize(ExactVec(camera.target) - ExactVec(camera.eye));
  frame.right = glm::normalize(glm::cross(frame.forward, ExactVec(camera.up)));
  frame.up = glm::cross(frame.right, frame.forward);
  return frame;
}

ClosedFormView view_of(const Scene& scene) {
  const Camera& camera = scene.camera;
  const bool parallel = camera.projection == Projection::Orthographic;
  return {exact_frame(camera),
          ExactVec(camera.eye),
          parallel,
          parallel ? Exact(camera.height) / 2 : std::tan(Exact(camera.fov) / 2),
          scene.width,
          scene.height};
}

Sight sight(const ClosedFormView& view, int x, int y) {
  const Exact u = Exact(2 * x + 1 - view.width) / view.height;
  const Exact v = Exact(view.height - 1 - 2 * y) / view.height;
  const ExactVec aside = view.half * (u * view.frame.right + v * view.frame.up);
  if (view.parallel) return {view.eye + aside, view.frame.forward};
  return {view.eye, glm::normalize(view.frame.forward + aside)};
}

PencilEnd eye_of(const ClosedFormView& view) {
  return {glm::dvec3(view.parallel ? -view.frame.forward : view.eye), view.parallel};
}

const Object& floor_of(const Scene& scene) {
  const Object* floor = nullptr;
  for (const Object& object : scene.objects) {
    const auto* plane = std::get_if<Plane>(&object.shape);
    if (!plane || !object.camera_visible) continue;
    if (!floor) {
      floor = &object;
      continue;
    }
    const Plane& first = std::get<Plane>(floor->shape);
    if (glm::cross(first.normal, plane->normal) != Vector(0) ||
        glm::dot(first.point - plane->point, first.normal) != 0 ||
        object.material != floor->material)
      throw Refusal(scene.name + ": expect: a floor is one plane, not two that differ");
  }
  if (!floor) throw Refusal(scene.name + ": expect: a floor is a plane that the camera sees");
  return *floor;
}

std::optional<SeenPoint> floor_point(const Object& floor, const Sight& sight) {
  const Plane& plane = std::get<Plane>(floor.shape);
  ExactVec n = glm::normalize(ExactVec(plane.normal));
  const Exact fall = glm::dot(sight.along, n);
  const Exact t = fall == 0 ? 0 : glm::dot(ExactVec(plane.point) - sight.start, n) / fall;
  if (t <= 0) return std::nullopt;
  return SeenPoint{sight.start + t * sight.along, fall < 0 ? n : -n, -sight.along, &floor};
}

std::vector<ExactLight> exact_lights(const Scene& scene) {
  std::vector<ExactLight> lights;
  for (const Light& light : scene.lights) {
    ExactLight& exact = lights.emplace_back(ExactLight{exact_lamps(light), {}});
    if (!scene.shadows) continue;
    for (const ExactLamp& lamp : exact.lamps)
      exact.before.push_back(obstacles(scene, {glm::dvec3(lamp.place), lamp.sun}));
  }
  return lights;
}

ExactTerms terms_at(const SeenPoint& seen, const ExactLight& light, const Material& material) {
  ExactTerms total;
  for (std::size_t i = 0; i < light.lamps.size(); ++i) {
    const ExactTerms one =
        terms_of(seen, light.lamps[i], light.before.empty() ? nullptr : &light.before[i], material);
    total.diffuse += one.diffuse, total.specular += one.specular, total.sure &= one.sure;
  }
  return total;
}

}  // namespace litmus

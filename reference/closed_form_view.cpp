// closed_form_view.cpp: pixels, planes, and slide 5 once more.
#include "reference/closed_form_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/refusal.h"

namespace litmus {
namespace {

/// kd Id (l.n) + ks Is (h.n)^ns of one lamp that nothing hides, apart from all colours.
struct Factors {
  Exact diffuse = 0, specular = 0;
  bool sure = true;
};

Factors factors(const Scene& scene, const ExactLamp& lamp, const SeenPoint& seen,
                const Material& material) {
  if (!lamp.sun && lamp.place == seen.at) return {};  // a lamp on the surface has no direction
  const ExactVec l = lamp.sun ? lamp.place : glm::normalize(lamp.place - seen.at);
  const Exact cosine = glm::dot(l, seen.normal);
  const bool shiny = material.specular != Color(0);
  if (cosine <= 0) return {0, 0, cosine < -kBoundaryBand || !shiny};
  Factors result;
  if (scene.shadows) {
    const Way way = passage_through(scene, {seen.at, lamp.place, lamp.sun}, seen.object);
    if (way != Way::Open) return {0, 0, way == Way::Blocked};
  }
  const Exact arrives = arriving(lamp, seen.at);
  result.diffuse = arrives * cosine;
  if (!shiny) return result;
  result.sure = cosine > kBoundaryBand;
  const ExactVec both = l + seen.eye;
  if (const Exact length = glm::length(both); length > 0)
    if (const Exact c = glm::dot(both, seen.normal) / length; c > 0)
      result.specular = arrives * std::pow(c, Exact(material.shininess));
  return result;
}

glm::dvec3 rounded(const ExactVec& v) { return {double(v.x), double(v.y), double(v.z)}; }

}  // namespace

ExactFrame exact_frame(const Camera& camera) {
  ExactFrame frame;
  frame.forward = glm::normalize(ExactVec(camera.target) - ExactVec(camera.eye));
  frame.right = glm::normalize(glm::cross(frame.forward, ExactVec(camera.up)));
  frame.up = glm::cross(frame.right, frame.forward);
  return frame;
}

Sight sight(const Scene& scene, int x, int y) {
  const ExactFrame frame = exact_frame(scene.camera);
  const Exact u = Exact(2 * x + 1 - scene.width) / scene.height;
  const Exact v = Exact(scene.height - 1 - 2 * y) / scene.height;
  const ExactVec aside = u * frame.right + v * frame.up, eye(scene.camera.eye);
  if (scene.camera.projection == Projection::Orthographic)
    return {eye + aside * Exact(scene.camera.height / 2), frame.forward};
  const Exact half = std::tan(Exact(scene.camera.fov) / 2);
  return {eye, glm::normalize(frame.forward + half * aside)};
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

Way in_view(const Scene& scene, const SeenPoint& seen, const Sight& sight) {
  return passage_through(scene, {seen.at, sight.start}, seen.object, true);
}

std::vector<std::vector<ExactLamp>> all_exact_lamps(const Scene& scene) {
  std::vector<std::vector<ExactLamp>> lamps;
  for (const Light& light : scene.lights) lamps.push_back(exact_lamps(light));
  return lamps;
}

void expect_point(const Scene& scene, const std::vector<std::vector<ExactLamp>>& lamps,
                  const SeenPoint& seen, std::size_t index, std::vector<ExpectedLayer>& layers) {
  const Material& material = scene.materials[std::size_t(seen.object->material)];
  ExactVec ambient(scene.ambient);
  for (const Light& light : scene.lights)
    ambient += Exact(light.intensity) * ExactVec(light.ambient);
  layers[0].picture.pixels[index] = rounded(ExactVec(material.ambient) * ambient);
  layers[0].known[index] = 1;
  for (std::size_t k = 0; k < lamps.size(); ++k) {
    const Light& light = scene.lights[k];
    Factors total;
    for (const ExactLamp& lamp : lamps[k]) {
      const Factors one = factors(scene, lamp, seen, material);
      total.diffuse += one.diffuse, total.specular += one.specular, total.sure &= one.sure;
    }
    const ExactVec lit = ExactVec(material.diffuse) * ExactVec(light.diffuse) * total.diffuse +
                         ExactVec(material.specular) * ExactVec(light.specular) * total.specular;
    layers[k + 1].picture.pixels[index] = rounded(Exact(light.intensity) * lit);
    layers[k + 1].known[index] = total.sure;
  }
}

}  // namespace litmus

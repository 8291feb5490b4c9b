// closed_form_pictures.cpp: floors, spheres, shells and darkness.
#include "reference/closed_form_pictures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "reference/closed_form_view.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

/// Calls visit(x, y, index) for each pixel that the ambient layer does not know yet.
template <class Visit>
void for_each_unknown(const Scene& scene, const std::vector<ExpectedLayer>& layers, Visit visit) {
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const std::size_t index = std::size_t(y) * std::size_t(scene.width) + std::size_t(x);
      if (!layers[0].known[index]) visit(x, y, index);
    }
}

/// The point of a sphere on an orthographic ray, if it is not on the rim; `near_rim` is set there.
std::optional<SeenPoint> sphere_point(const Object& object, const ExactFrame& frame,
                                      const Sight& sight, bool& near_rim) {
  const auto& sphere = std::get<Sphere>(object.shape);
  const ExactVec centre(sphere.center);
  const Exact r = sphere.radius;
  const ExactVec aside = sight.start - centre;
  const Exact u = glm::dot(aside, frame.right) / r, v = glm::dot(aside, frame.up) / r;
  const Exact under = 1 - u * u - v * v;
  near_rim |= std::fabs(under) < kBoundaryBand;
  if (under <= 0) return std::nullopt;
  const ExactVec n = u * frame.right + v * frame.up - std::sqrt(under) * frame.forward;
  const ExactVec at = centre + r * n;
  if (glm::dot(at - sight.start, frame.forward) <= 0) return std::nullopt;
  return SeenPoint{at, n, -frame.forward, &object};
}

bool is_only(const Scene& scene, bool (*allowed)(const Object&)) {
  return std::all_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
    return !object.camera_visible || allowed(object);
  });
}

}  // namespace

void expect_floor(const Scene& scene, std::vector<ExpectedLayer>& layers) {
  const Object& floor = floor_of(scene);
  const auto lamps = all_exact_lamps(scene);
  for_each_unknown(scene, layers, [&](int x, int y, std::size_t index) {
    const Sight through = sight(scene, x, y);
    const std::optional<SeenPoint> seen = floor_point(floor, through);
    if (seen && in_view(scene, *seen, through) == Way::Open)
      expect_point(scene, lamps, *seen, index, layers);
  });
}

void expect_spheres(const Scene& scene, std::vector<ExpectedLayer>& layers) {
  if (scene.camera.projection != Projection::Orthographic)
    throw Refusal(scene.name + ": expect: \"spheres\" needs an orthographic camera");
  const bool empty_elsewhere = is_only(
      scene, [](const Object& object) { return std::holds_alternative<Sphere>(object.shape); });
  const ExactFrame frame = exact_frame(scene.camera);
  const auto lamps = all_exact_lamps(scene);
  for_each_unknown(scene, layers, [&](int x, int y, std::size_t index) {
    const Sight through = sight(scene, x, y);
    bool near_rim = false, hit = false;
    for (const Object& object : scene.objects) {
      if (!object.camera_visible || !std::holds_alternative<Sphere>(object.shape)) continue;
      const std::optional<SeenPoint> seen = sphere_point(object, frame, through, near_rim);
      hit |= seen.has_value();
      if (seen && in_view(scene, *seen, through) == Way::Open)
        expect_point(scene, lamps, *seen, index, layers);
    }
    for (ExpectedLayer& layer : layers) {
      if (near_rim) layer.known[index] = 0;
      if (!near_rim && !hit && empty_elsewhere) layer.known[index] = 1;
    }
  });
}

void expect_shell(const Scene& scene, std::vector<ExpectedLayer>& layers) {
  const auto* sphere =
      scene.objects.size() == 1 ? std::get_if<Sphere>(&scene.objects[0].shape) : nullptr;
  if (!sphere || glm::distance(scene.camera.eye, sphere->center) >= sphere->radius ||
      scene.materials[std::size_t(scene.objects[0].material)].specular != Color(0))
    throw Refusal(scene.name + ": expect: \"shell\" needs one matte sphere around the eye");
  const auto lamps = all_exact_lamps(scene);
  for (const auto& each : lamps)
    for (const ExactLamp& lamp : each)
      if (lamp.sun || lamp.spot || lamp.place != ExactVec(sphere->center))
        throw Refusal(scene.name + ": expect: \"shell\" needs its lights at the sphere's centre");
  // Seen from the centre, any point of the shell will do.
  const ExactVec out(0, 0, 1);
  const SeenPoint seen{ExactVec(sphere->center) + Exact(sphere->radius) * out, -out, -out,
                       &scene.objects[0]};
  for_each_unknown(scene, layers, [&](int, int, std::size_t index) {
    expect_point(scene, lamps, seen, index, layers);
  });
}

void expect_darkness(const Scene& scene, std::vector<ExpectedLayer>& layers) {
  for (std::size_t k = 1; k < layers.size(); ++k)
    std::fill(layers[k].known.begin(), layers[k].known.end(), 1);
  const bool no_ambient = scene.ambient == Color(0) &&
                          std::all_of(scene.lights.begin(), scene.lights.end(), [](const Light& l) {
                            return l.intensity * l.ambient == Color(0);
                          });
  if (no_ambient) std::fill(layers[0].known.begin(), layers[0].known.end(), 1);
}

}  // namespace litmus

// scenes.h: small scenes for the tracer's tests, built in memory.
#pragma once

#include <string>

#include "scene/scene.h"

namespace litmus {

/// One matte grey material, an orthographic camera looking down on `size` x `size` pixels of a
/// square of side 6.
inline Scene seen_from_above(int size = 64) {
  Scene scene;
  scene.width = scene.height = size;
  scene.camera.projection = Projection::Orthographic;
  scene.camera.eye = {0, 0, 10};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.camera.height = 6;
  scene.materials.push_back({"matte", Color(1), Color(0.8), Color(0), 1});
  return scene;
}

inline Scene floor_from_above(int size = 64) {
  Scene scene = seen_from_above(size);
  scene.objects.push_back({"floor", Plane{}, 0, true});
  return scene;
}

inline Light make_light(decltype(Light::shape) shape, std::string name = "lamp") {
  Light light;
  light.name = std::move(name);
  light.shape = std::move(shape);
  return light;
}

inline Light sun(const Vector& direction) { return make_light(DirectionalLight{direction}, "sun"); }

inline Light bulb(const Point& origin, const Attenuation& attenuation = {}) {
  return make_light(PointLight{origin, attenuation});
}

/// The floor point that the centre of pixel (x, y) of seen_from_above shows.
inline Point floor_point(const Scene& scene, int x, int y) {
  const double half = scene.camera.height / 2;
  return {(2 * x + 1 - scene.width) * half / scene.width,
          -(2 * y + 1 - scene.height) * half / scene.height, 0};
}

}  // namespace litmus

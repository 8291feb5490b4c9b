// stage.h: the scenes that the benchmarks and `litmus cost --peers` render.
#pragma once

#include <cmath>

#include "scene/mesh.h"
#include "scene/scene.h"

namespace litmus {

/// A floor, three spheres and a box, seen from the front.
inline Scene stage(int size) {
  Scene scene;
  scene.name = "stage";
  scene.width = scene.height = size;
  scene.camera.eye = {3, -8, 4}, scene.camera.target = {0, 0, 0.8};
  scene.materials.push_back({"gloss", Color(1), Color(0.7), Color(0.3), 40});
  scene.objects = {{"floor", Plane{}, 0, true},
                   {"left", Sphere{{-1.5, 0, 1}, 1}, 0, true},
                   {"right", Sphere{{1, 0.5, 0.7}, 0.7}, 0, true},
                   {"front", Sphere{{0.2, -1.5, 0.5}, 0.5}, 0, true},
                   {"block", Box{{2, -1, 0}, {2.8, 0, 1.2}}, 0, true}};
  return scene;
}

inline Light bulb_at(const Point& origin, const Attenuation& attenuation = {10, 0, 1}) {
  Light light;
  light.name = "lamp";
  light.shape = PointLight{origin, attenuation};
  return light;
}

/// One point light with quadratic attenuation.
inline Scene point_stage(int size) {
  Scene scene = stage(size);
  scene.lights = {bulb_at({4, -4, 6})};
  return scene;
}

/// An area light of n x n samples.
inline Scene area_stage(int size, int n) {
  Scene scene = stage(size);
  AreaLight panel;
  panel.point = {{4, -4, 6}, {10, 0, 1}};
  panel.width = panel.height = 2, panel.columns = panel.rows = n;
  scene.lights = {bulb_at({})};
  scene.lights[0].shape = panel;
  return scene;
}

/// Matte, without shadows or attenuation: the least that a light can ask for.
inline Scene diffuse_stage(int size) {
  Scene scene = stage(size);
  scene.materials[0].specular = Color(0);
  scene.shadows = false;
  scene.lights = {bulb_at({4, -4, 6}, {})};
  return scene;
}

/// A smooth torus of about that many triangles, alone, under a low lamp: it shadows itself.
inline Scene mesh_stage(int size, int triangles) {
  Scene scene = stage(size);
  const int sides = int(std::sqrt(triangles / 4.0)), segments = 2 * sides;
  scene.objects = {
      {"ring", torus({0, 0, 0.8}, {0.3, 0.2, 1}, 1.6, 0.7, segments, sides, true), 0, true}};
  scene.materials[0].specular = Color(0);
  scene.lights = {bulb_at({4, -4, 1.5}, {})};
  return scene;
}

}  // namespace litmus

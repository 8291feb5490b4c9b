// moved_scene.h: scenes that must give the same picture, or one that is known.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/bands.h"
#include "scene/load.h"
#include "scene/scene.h"

namespace litmus {

/// Every canonical scene, at most `side` pixels a side (both even) and one sample per pixel. Of one
/// with spectra its middle bands, as a scene with plain colours.
inline std::vector<Scene> small_canonical_scenes(int side) {
  std::vector<Scene> scenes = load_canonical_scenes().scenes;
  for (Scene& scene : scenes) {
    if (scene.spectra) {
      std::vector<Scene> bands = band_scenes(scene);
      scene = std::move(bands[bands.size() / 2]);
    }
    const double shrink = std::min(1.0, double(side) / std::max(scene.width, scene.height));
    scene.width = std::max(2, 2 * int(scene.width * shrink / 2));
    scene.height = std::max(2, 2 * int(scene.height * shrink / 2));
    scene.samples = 1;
  }
  return scenes;
}

/// What a motion of space does to points, to directions and to lengths.
struct Motion {
  Point (*point)(const Point&, double by);
  Vector (*direction)(const Vector&, double by);
  double (*length)(double, double by);
  double by = 0;
};

inline void move(const Motion& m, PointLight& light) {
  light.origin = m.point(light.origin, m.by);
  light.attenuation.range = m.length(light.attenuation.range, m.by);
}

inline void move(const Motion& m, Light& light) {
  if (auto* sun = std::get_if<DirectionalLight>(&light.shape)) {
    sun->direction = m.direction(sun->direction, m.by);
  } else if (auto* point = std::get_if<PointLight>(&light.shape)) {
    move(m, *point);
  } else if (auto* spot = std::get_if<SpotLight>(&light.shape)) {
    move(m, spot->point);
    spot->direction = m.direction(spot->direction, m.by);
  } else if (auto* area = std::get_if<AreaLight>(&light.shape)) {
    if (!area->normal) area->normal = -area->point.origin;
    move(m, area->point);
    area->normal = m.direction(*area->normal, m.by);
    if (area->right) area->right = m.direction(*area->right, m.by);
    area->width = m.length(area->width, m.by), area->height = m.length(area->height, m.by);
  }
}

inline void move(const Motion& m, Object& object) {
  const auto point = [&](Point& p) { p = m.point(p, m.by); };
  if (auto* sphere = std::get_if<Sphere>(&object.shape)) {
    point(sphere->center);
    sphere->radius = m.length(sphere->radius, m.by);
  } else if (auto* plane = std::get_if<Plane>(&object.shape)) {
    point(plane->point);
    plane->normal = m.direction(plane->normal, m.by);
  } else if (auto* box = std::get_if<Box>(&object.shape)) {
    const Point a = m.point(box->min, m.by), b = m.point(box->max, m.by);
    for (int i = 0; i < 3; ++i)
      box->min[i] = std::min(a[i], b[i]), box->max[i] = std::max(a[i], b[i]);
  } else if (auto* triangle = std::get_if<Triangle>(&object.shape)) {
    point(triangle->a), point(triangle->b), point(triangle->c);
  } else if (auto* mesh = std::get_if<Mesh>(&object.shape)) {
    for (Point& vertex : mesh->vertices) point(vertex);
    for (Vector& normal : mesh->normals) normal = m.direction(normal, m.by);
  }
}

/// The scene with everything in it moved.
inline Scene moved(Scene scene, const Motion& m) {
  Camera& camera = scene.camera;
  camera.eye = m.point(camera.eye, m.by), camera.target = m.point(camera.target, m.by);
  camera.up = m.direction(camera.up, m.by), camera.height = m.length(camera.height, m.by);
  for (Object& object : scene.objects) move(m, object);
  for (Light& light : scene.lights) move(m, light);
  return scene;
}

/// All lengths times 2^k.
inline Motion scaling(int k) {
  return {[](const Point& p, double by) { return by * p; },
          [](const Vector& d, double) { return d; },
          [](double length, double by) { return by * length; }, std::ldexp(1.0, k)};
}

/// x to -x.
inline Motion mirroring() {
  return {[](const Point& p, double) { return Point(-p.x, p.y, p.z); },
          [](const Vector& d, double) { return Vector(-d.x, d.y, d.z); },
          [](double length, double) { return length; }};
}

/// By `by` along (1, 1/2, -1/4).
inline Motion translation(double by) {
  return {[](const Point& p, double by) { return p + by * Vector(1, 0.5, -0.25); },
          [](const Vector& d, double) { return d; }, [](double length, double) { return length; },
          by};
}

/// By an angle in radians around the z axis. Boxes stay along the axes: not for scenes with boxes,
/// unless it is a quarter turn.
inline Motion quarter_turn() {
  return {[](const Point& p, double) { return Point(-p.y, p.x, p.z); },
          [](const Vector& d, double) { return Vector(-d.y, d.x, d.z); },
          [](double length, double) { return length; }};
}
inline Motion rotation(double angle) {
  const auto turn = [](const Vector& v, double by) {
    return Vector(std::cos(by) * v.x - std::sin(by) * v.y, std::sin(by) * v.x + std::cos(by) * v.y,
                  v.z);
  };
  return {turn, turn, [](double length, double) { return length; }, angle};
}

}  // namespace litmus

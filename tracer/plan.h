// plan.h: a scene made ready for the kernel: unit vectors, expanded lights, one list per kind of
// surface.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"
#include "tracer/bvh.h"
#include "tracer/effects.h"
#include "tracer/lights.h"
#include "tracer/shade.h"

namespace litmus {

/// A surface and the object it belongs to (index into Scene::objects).
template <class Shape>
struct Part {
  Shape shape;
  int object;
};

/// What a hit needs to know of a triangle besides its corners.
template <Real R>
struct TriangleInfo {
  int object;
  Vec<R> normal;                  ///< geometric, unit
  std::array<Vec<R>, 3> normals;  ///< of the corners, if smooth
  bool smooth = false;
};

/// A material as the kernel reads it.
template <Value V>
struct Finish {
  Vec<V> ambient, diffuse, specular;
  Exponent<V> shininess;
  Mask<V> shiny = false;     ///< ks is not 0
  Mask<V> reflects = false;  ///< kd or ks is not 0 (in the sample code's reading, always)
};

/// The lamps of one light: one, or the samples of its area.
template <Real R>
struct Source {
  std::vector<Lamp<R>> lamps;
  R weight{1};               ///< 1 / number of lamps
  Vec<R> diffuse, specular;  ///< intensity times colour
  Ball<R> ball;              ///< around the lamps of an area light
};

template <Real R>
struct View {
  bool orthographic;
  Vec<R> eye, forward, right, up;  ///< right and up reach from the picture's centre to its border
  int width, height, samples;
};

template <Real R>
struct Plan {
  View<R> view;
  std::vector<Part<SphereSurface<R>>> spheres;
  std::vector<Part<PlaneSurface<R>>> planes;
  std::vector<Part<BoundedBox<R>>> boxes;
  std::vector<std::array<Vec<R>, 3>> triangles;
  std::vector<TriangleInfo<R>> triangle_info;
  Bvh<R> bvh;
  Ball<R> mesh_ball;                 ///< around all triangles
  std::vector<char> camera_visible;  ///< per object
  std::vector<Finish<R>> finishes;   ///< per object
  std::vector<Source<R>> sources;    ///< per light
  Vec<R> ambient;                    ///< Ia: the scene's and every light's, added once
  bool specular = true;              ///< some surface may shine: half vectors are asked for
  bool smooth = false;               ///< some normal is not that of its surface
  bool shadows = true;
  bool sample_code = false;
  bool edges = true;          ///< signatures and flags are asked for
  bool everything = false;    ///< cull nothing, evaluate every term
  bool idle_shadows = false;  ///< trace shadow rays, although nothing is in shadow
};

/// Lowers a scene to the scalar R, with those effects and no others. Lights that cannot add
/// anything have no lamps.
template <Real R>
Plan<R> lower(const Scene& scene, const Effects& effects);

/// Lowers a scene with all that it calls for.
template <Real R>
Plan<R> lower(const Scene& scene) {
  return lower<R>(scene, effects_of(scene));
}

}  // namespace litmus

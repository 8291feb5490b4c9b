// load_parts.h: the parts of load_scene, one per kind of table. Each throws Refusal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/fields.h"
#include "scene/scene.h"

namespace litmus {

inline constexpr int kLargestSide = 16384;      ///< pixels, of an image
inline constexpr int kMostSamples = 64;         ///< per pixel and axis
inline constexpr int kMostLightSamples = 4096;  ///< columns * rows of an area light
inline constexpr std::int64_t kMostPrimitives =
    1'000'000;  ///< in a scene; a mesh counts its triangles

/// `[camera]`
Camera read_camera(const Fields& fields);

/// One `[[light]]`, without its name.
Light read_light(const Fields& fields);

/// One `[[object]]`'s shape. Triangles without area are left out and counted in `dropped`, so a
/// mesh may come back empty. `room` is how many primitives the scene may still take.
decltype(Object::shape) read_shape(const Fields& fields, std::int64_t room, std::int64_t& dropped);

/// Primitives that a shape counts as: a mesh's triangles, else 1.
std::int64_t primitives(const Object& object);

/// `[spectra]`, `bands`, and every colour that names a spectrum: fills `scene.spectra` and the RGB
/// colours that stand in, where there is one. `root` is the file, from which `scene` has been read
/// already.
void read_spectra(const Fields& root, Scene& scene);

}  // namespace litmus

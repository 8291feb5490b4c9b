// json.h: writes a scene as JSON, fully resolved, for a renderer in any language.
#pragma once

#include <iosfwd>

#include "scene/scene.h"

namespace litmus {

/// The version of the exported scene, its member "litmus_scene".
inline constexpr int kSceneJsonVersion = 1;

/// The scene as scene.schema.json (beside this file) describes it: directions are unit vectors, the
/// camera is a frame with a formula for the ray of each pixel, an area light is the list of its
/// points, colours of lights are multiplied by their intensity, ambient light is one colour (Ia of
/// slide 5), every surface is a sphere, a plane, a box or a mesh. Numbers are the shortest text
/// that reads back as the same double. Throws Refusal if an area light has no frame.
///
/// Derived from the scene alone: it shares no code with the tracer.
void write_scene_json(const Scene& scene, std::ostream& out);

}  // namespace litmus

// blender_parts.h: what the exact and the native Blender scripts have in common.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// "(x, y, z)".
std::string python_triple(const glm::dvec3& v);

/// A name for people as a Python string; Blender takes no control characters in names.
std::string python_label(const std::string& name);

/// Throws Refusal for what no Blender script can show: shading = "sample-code", and pictures of
/// fewer than 4 pixels a side.
void refuse_for_blender(const Scene& scene);

/// Ia: the scene's ambient colour and every light's, added once.
Color blender_ambient(const Scene& scene);

/// The two commands, what the frames are, and where the scene was moved to, as comment lines.
/// `given` is the scene before the envelope; `samples_have_frames`: an area light has one each.
void write_blender_commands(const Scene& given, bool samples_have_frames, std::ostream& out);

/// One line per material, and the Python variables that hold them, in the scene's order.
std::vector<std::string> write_blender_materials(const Scene& scene, std::ostream& out);

/// mesh(`start`, vertices="""...""", triangles="""...""", normals="""..."""`end`.
void write_blender_mesh(const std::string& start, const Mesh& mesh, const std::string& end,
                        std::ostream& out);

/// The line that calls camera(); an orthographic eye is moved near to the scene.
void write_blender_camera(const Scene& scene, std::ostream& out);

}  // namespace litmus

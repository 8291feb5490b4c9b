// povray_parts.h: what the exact and the native POV-Ray export have in common.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace litmus::povray {

/// "<1, 2, 3>"
std::string vector_text(const Vector& v);

/// The names that the file declares, parallel to the scene's materials and lights.
struct Names {
  std::vector<std::string> materials;  ///< "Material_RedFloor"
  std::vector<std::string> lights;     ///< "Light_Key"; a number, the light's frame
};
Names names_of(const Scene& scene);

/// Throws Refusal for `shading = "sample-code"`.
void refuse_sample_code(const Scene& scene);

/// "---- Title ----" on a comment line.
void write_title(const std::string& title, std::ostream& out);

// The following use `Unit`, and write_materials() also `Layer`, `Boost`, `Gain`, `Ia`, `Id`, `Is`.

void write_camera(const Scene& scene, std::ostream& out);

/// Instead of exponent 0, a highlight everywhere: POV-Ray divides by the exponent.
inline constexpr double kNoShininess = 1e-30;
void write_materials(const Scene& scene, const Names& names, std::ostream& out);

/// How a mesh is written: as a union of triangles, because POV-Ray's mesh2 keeps vertices in single
/// precision and lets single rays through at edges; or as that mesh2, which users write. The union
/// is split for POV-Ray's search tree and as fast: 81,920 triangles parse in 0.4 s either way.
enum class MeshAs { Triangles, Mesh2 };
void write_objects(const Scene& scene, const Names& names, MeshAs mesh, std::ostream& out);

}  // namespace litmus::povray

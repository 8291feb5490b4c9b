// povray_parts.h: what the exact and the native POV-Ray export have in common.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "exporters/envelope.h"
#include "scene/scene.h"

namespace litmus::povray {

/// "<1, 2, 3>"
std::string vector_text(const Vector& v);

/// Instead of exponent 0, a highlight everywhere: POV-Ray divides by the exponent.
inline constexpr double kNoShininess = 1e-30;

/// The names that the file declares, parallel to the scene's materials and lights.
struct Names {
  std::vector<std::string> materials;  ///< "Material_RedFloor"
  std::vector<std::string> lights;     ///< "Light_Key"; a number, the light's frame
};
Names names_of(const Scene& scene);

/// "---- Title ----" on a comment line.
void write_title(const std::string& title, std::ostream& out);

/// Throws Refusal for `shading = "sample-code"`.
void refuse_sample_code(const Scene& scene);

/// Id and Is: the intensity times the diffuse or specular colour.
Color diffuse_power(const Light& light);
Color specular_power(const Light& light);
/// Ia: the scene's ambient colour plus each light's intensity times its ambient colour.
Color ambient_power(const Scene& scene);

/// A factor per channel that turns each light's diffuse into its specular colour, the same for all
/// lights. False if there is none.
bool common_specular(const Scene& scene, Color& factor);

/// The attenuation of a light, or none for a directional one.
Attenuation attenuation_of(const Light& light);

/// The gain of frame 0: all layers together do not clip.
double whole_gain(const Scene& scene);

/// The header: what the scene shows, the command, the frames. `notes` are further paragraphs.
void write_header(const Scene& scene, const Envelope& envelope, const std::string& kind,
                  const std::vector<std::string>& notes, std::ostream& out);

/// #version, global_settings, the unit and the choice of the layer. `unit`: how large a unit of the
/// scene is in POV-Ray, see `Unit` below. `whole`: frame 0 renders all lights.
void write_layers(const Scene& scene, const Names& names, double unit, bool whole,
                  std::ostream& out);

// The following use what write_layers() declares: `Unit`, `Layer`, `Boost`, `Gain`, `Ia`, `Id`,
// `Is`.

void write_camera(const Scene& scene, std::ostream& out);
void write_materials(const Scene& scene, const Names& names, std::ostream& out);

/// How a mesh is written: as a union of triangles, because POV-Ray's mesh2 keeps vertices in single
/// precision and lets single rays through at edges; or as that mesh2, which users write. The union
/// is split for POV-Ray's search tree and as fast: 81,920 triangles parse in 0.4 s either way.
enum class MeshAs { Triangles, Mesh2 };
void write_objects(const Scene& scene, const Names& names, MeshAs mesh, std::ostream& out);

}  // namespace litmus::povray

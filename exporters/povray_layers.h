// povray_layers.h: how bright each frame of a POV-Ray export is, its header, and the choice of the
// frame.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "exporters/envelope.h"
#include "exporters/povray_parts.h"
#include "scene/scene.h"

namespace litmus::povray {

/// Id and Is: the intensity times the diffuse or specular colour.
Color diffuse_power(const Light& light);
Color specular_power(const Light& light);
/// Ia: the scene's ambient colour plus each light's intensity times its ambient colour.
Color ambient_power(const Scene& scene);

/// A factor per channel that turns each light's diffuse into its specular colour, the same for all
/// lights. False if there is none.
bool common_specular(const Scene& scene, Color& factor);

/// The gain of frame 0: all layers together do not clip.
double whole_gain(const Scene& scene);

/// The header: what the scene shows, the command, the frames. `notes` are further paragraphs.
void write_header(const Scene& scene, const Envelope& envelope, const std::string& kind,
                  const std::vector<std::string>& notes, std::ostream& out);

/// #version, global_settings, the unit and the choice of the layer: declares `Unit`, `Layer`,
/// `Boost`, `Gain`, `Ia`, `Id`, `Is` and the macro `Shines`. `unit`: how large a unit of the scene
/// is in POV-Ray. `whole`: frame 0 renders all lights.
void write_layers(const Scene& scene, const Names& names, double unit, bool whole,
                  std::ostream& out);

}  // namespace litmus::povray

// povray_limits.h: the sizes that the exact POV-Ray export chooses, and why.
#pragma once

#include "scene/scene.h"

namespace litmus::povray {

/// How large the file's unit is: the scene's radius becomes 256..512. POV-Ray ignores occluders
/// within 1e-3 of a surface, which shows at the terminator of meshes where the scene is 10 across,
/// and no more from 100 on. The scene's numbers stay the author's. 1 for
/// a scene that stays unmoved.
double unit_of(const Scene& scene);

/// The radius of a filter round a lamp, both in POV-Ray's units. It must exceed POV-Ray's shadow
/// tolerance (1e-3), or it is ignored, and be small, because rays to other samples pass through it.
/// Far lamps get a larger one: a sphere at distance d is hit to about 1e-16 d^2.
double filter_radius(const Point& lamp);

/// Where parallel light starts: beyond, nothing casts a shadow. POV-Ray ends at 1e7.
inline constexpr double kSunDistance = 1e5;

/// The medium of attenuation fills a box of this half size; beyond, light is not attenuated.
inline constexpr double kMediumReach = 1e5;

/// Whether the light's attenuation needs the medium: POV-Ray has either factor, not both.
bool has_medium(const Light& light);

}  // namespace litmus::povray

// closed_form_claims.h: the oracles that say of each pixel what must hold, not which value it has.
#pragma once

#include "reference/closed_form.h"

namespace litmus {

/// Each adds its claims, and throws Refusal if the scene lacks what it needs.

/// The ambient layer shows, at each pixel, ka Ia of a material in the scene or 0, to 1e-15.
void claim_ambient_levels(const Scene& scene, std::vector<Claim>& claims);

/// O1, O2, O3, O8: a light's layer is 0 exactly where the floor point lies inside the curves of the
/// casters, for every lamp of the light. Spots add their cone. Needs a level floor that only
/// casters hidden from the camera stand over, spheres, boxes and triangles.
void claim_shadow_curves(const Scene& scene, std::vector<Claim>& claims);

/// O6: a spot's layer is 0 outside the conic of its cone, and not inside where nothing casts a
/// shadow. Needs a level floor and a spot of cutoff under 90 degrees.
void claim_cone_curves(const Scene& scene, std::vector<Claim>& claims);

}  // namespace litmus

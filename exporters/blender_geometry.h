// blender_geometry.h: what Cycles needs to be told apart from the scene: how much of a plane is
// needed, which spheres hold the eye, and how near an orthographic eye may stand.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// As much of an infinite plane as the picture and its shadows need, as nested rectangles in the
/// plane: ring k reaches from rectangle k - 1 to rectangle k. A plane within 32 units has one
/// rectangle. Cycles is as exact as its triangles are small: a quad of 2000 units costs 1.8e-5.
/// What lies further away than 1e6 units is cut off. `scene` must be in its envelope.
std::vector<std::array<Point, 4>> plane_rectangles(const Scene& scene, const Plane& plane);

/// Whether the picture is taken from inside the sphere. Cycles shows and shadows its points from
/// outside only.
bool holds_eye(const Camera& camera, double aspect, const Sphere& sphere);

/// The eye of an orthographic camera moved along its view, to one unit before the first visible
/// object; the picture is the same and rays lose fewer digits. Other cameras keep theirs.
Point near_eye(const Scene& scene);

}  // namespace litmus

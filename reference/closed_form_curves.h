// closed_form_curves.h: the curves in which cones and shadows end on a level floor, as explicit
// conics and polygons.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "reference/closed_form_light.h"

namespace litmus {

using FloorPoint = glm::vec<2, long double>;

/// An ellipse ((t/a)^2 + (v/b)^2 < 1) or one branch of a hyperbola ((t/a)^2 - (v/b)^2 > 1, t > 0),
/// with t along the unit vector `axis` from `centre` and v across it.
struct Conic {
  FloorPoint centre{0}, axis{1, 0};
  Exact a = 0, b = 0;
  bool hyperbola = false;
  bool none = false;  ///< the cone does not meet the floor at all
};

/// Where the cone of half angle `beta` around the unit vector `axis` from `apex` meets the floor at
/// height `level`: with phi the angle of the axis from straight down and H the apex's height,
///     t1 = H tan(phi - beta), t2 = H tan(phi + beta), a = |t2 - t1| / 2, e = sin(phi) / cos(beta),
///     b = a sqrt|1 - e^2|;
/// phi + beta < 90 degrees is an ellipse, > 90 a hyperbola. beta < 90 degrees, H > 0; a parabola,
/// which no rounded number is, becomes a very long ellipse.
Conic cone_on_floor(const ExactVec& apex, const ExactVec& axis, Exact beta, Exact level);

/// The shadow of a sphere under the sun: centre C - (C.z / L.z) L, half axes r / L.z along L and r
/// across.
Conic sun_shadow(const Sphere& sphere, const ExactVec& toward_sun, Exact level);

/// The shadow of a sphere under a lamp: the cone of its tangents, asin(r / D) wide.
Conic lamp_shadow(const Sphere& sphere, const ExactVec& lamp, Exact level);

/// Positive inside, negative outside, 0 on the curve; dimensionless, and about twice the distance
/// from the curve divided by the half axis near it.
Exact depth(const Conic& conic, const FloorPoint& point);

/// The shadow of a box or triangle: the convex hull of its corners projected from the lamp (each
/// scaled by H / (H - h) about the point below the lamp, or slid along the sun's direction),
/// counterclockwise. Throws Refusal if a corner is not between floor and lamp.
std::vector<FloorPoint> corner_shadow(const Object& object, const ExactLamp& lamp, Exact level);

/// Positive inside: the distance from the nearest edge, in scene units.
Exact depth(const std::vector<FloorPoint>& polygon, const FloorPoint& point);

}  // namespace litmus

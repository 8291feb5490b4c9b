// closed_form_light.h: how much light arrives at a point, in the slides' own forms, for the closed
// forms. In extended precision, and without the tracer: slide by slide this is written a second
// time.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace litmus {

using Exact = long double;
using ExactVec = glm::vec<3, long double>;

/// A spot's cone (slide 15).
struct ExactCone {
  ExactVec axis{0};  ///< unit, away from the lamp
  Exact cutoff = 0, exponent = 1;
};

/// One place that light comes from: the sun, a point, or a sample of a rectangle.
struct ExactLamp {
  bool sun = false;
  ExactVec place{0};  ///< of the lamp; for the sun the unit vector towards it
  Attenuation attenuation{};
  std::optional<ExactCone> cone{};  ///< narrows the light
  Exact share = 1;                  ///< of the light's intensity
};

/// The lamps of a light (slides 8, 10, 15, 20).
std::vector<ExactLamp> exact_lamps(const Light& light);

/// The angle between a cone's axis and the way from its lamp to `point`, radians.
Exact angle_off_axis(const ExactLamp& lamp, const ExactVec& point);

/// The fraction of the light's intensity that this lamp sends to `point`: its share times
/// R/(R + L d) times R^2/(R^2 + Q d^2) (slide 11) times 1 - (alpha/cutoff)^exponent (slide 16).
Exact arriving(const ExactLamp& lamp, const ExactVec& point);

}  // namespace litmus

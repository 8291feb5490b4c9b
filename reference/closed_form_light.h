// closed_form_light.h: how much light arrives at a point, in the slides' own forms, for the closed
// forms. In extended precision, and without the tracer: slide by slide this is written a second
// time.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace litmus {

using Exact = long double;
using ExactVec = glm::vec<3, long double>;

/// One place that light comes from: the sun, a point, or a sample of a rectangle.
struct ExactLamp {
  bool sun = false;
  ExactVec place{0};  ///< of the lamp; for the sun the unit vector towards it
  Attenuation attenuation{};
  const SpotLight* spot = nullptr;  ///< narrows the light to its cone
  Exact share = 1;                  ///< of the light's intensity
};

/// The lamps of a light (slides 8, 10, 15, 20). Those of a spot point into the light.
std::vector<ExactLamp> exact_lamps(const Light& light);

/// The angle between a spot's axis and the way from it to `point`, radians.
Exact angle_off_axis(const SpotLight& spot, const ExactVec& point);

/// The fraction of the light's intensity that this lamp sends to `point`: its share times
/// R/(R + L d) times R^2/(R^2 + Q d^2) (slide 11) times 1 - (alpha/cutoff)^exponent (slide 16).
Exact arriving(const ExactLamp& lamp, const ExactVec& point);

}  // namespace litmus

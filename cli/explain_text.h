// explain_text.h: an explanation of a pixel as a worked example for people.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracer/explain.h"

namespace litmus {

/// What a reference shows in the explained pixel.
struct ReferencePixel {
  std::string name, title;         ///< "povray", "POV-Ray"
  std::string source, version;     ///< "live" or "stored"; "" if there is no image
  std::string failure, skipped;    ///< one sentence where there is no image
  std::vector<glm::dvec3> layers;  ///< ambient, then each light; empty if there is no image
};

/// Slide 5 with numbers, light by light, then the sum. `light` is a light's name, "ambient" or
/// "all" (or empty); of one light alone no sum is shown.
std::string explanation_text(const Scene& scene, const Explanation& pixel,
                             std::span<const ReferencePixel> references, const std::string& light);

}  // namespace litmus

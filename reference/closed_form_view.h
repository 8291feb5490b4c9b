// closed_form_view.h: from a pixel to the floor, and what a point that is seen must show.
#pragma once

#include <optional>

#include "reference/closed_form.h"
#include "reference/closed_form_shadow.h"

namespace litmus {

/// The ray through a pixel's centre: from `start`, along the unit vector `along`.
struct Sight {
  ExactVec start{0}, along{0};
};

/// The camera's axes: unit vectors, z up in the picture's sense (right, up, forward).
struct ExactFrame {
  ExactVec right{0}, up{0}, forward{0};
};
ExactFrame exact_frame(const Camera& camera);

/// x to the right, y down, (0, 0) the top left pixel.
Sight sight(const Scene& scene, int x, int y);

/// A point of a surface as it is seen: `normal` and `eye` are unit and on one side.
struct SeenPoint {
  ExactVec at{0}, normal{0}, eye{0};
  const Object* object = nullptr;
};

/// The one plane that the camera sees, or several that coincide in one material. Throws Refusal if
/// there is none, or there are others.
const Object& floor_of(const Scene& scene);

/// Where the ray meets the floor in front of the eye, whether or not something else hides it.
std::optional<SeenPoint> floor_point(const Object& floor, const Sight& sight);

/// Nothing (hidden by what the camera sees), unsure, or in view.
Way in_view(const Scene& scene, const SeenPoint& seen, const Sight& sight);

/// The lamps of each light, in the scene's order.
std::vector<std::vector<ExactLamp>> all_exact_lamps(const Scene& scene);

/// Sets pixel `index` of every layer to what the seen point shows by slide 5, as far as it is
/// known.
void expect_point(const Scene& scene, const std::vector<std::vector<ExactLamp>>& lamps,
                  const SeenPoint& seen, std::size_t index, std::vector<ExpectedLayer>& layers);

}  // namespace litmus

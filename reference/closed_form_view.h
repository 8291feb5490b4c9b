// closed_form_view.h: from a pixel to what it sees, and what light does there.
#pragma once

#include <optional>

#include "reference/closed_form.h"
#include "reference/closed_form_shadow.h"

namespace litmus {

/// The camera's axes: unit vectors, z up in the picture's sense (right, up, forward).
struct ExactFrame {
  ExactVec right{0}, up{0}, forward{0};
};
ExactFrame exact_frame(const Camera& camera);

/// A camera with what all its pixels have in common.
struct ClosedFormView {
  ExactFrame frame;
  ExactVec eye{0};
  bool parallel = false;  ///< orthographic
  Exact half = 0;         ///< of the picture's height, at the distance 1 in perspective
  int width = 0, height = 0;
};
ClosedFormView view_of(const Scene& scene);

/// The ray through a pixel's centre: from `start`, along the unit vector `along`.
struct Sight {
  ExactVec start{0}, along{0};
};

/// x to the right, y down, (0, 0) the top left pixel.
Sight sight(const ClosedFormView& view, int x, int y);

/// Where all ways to the eye end.
PencilEnd eye_of(const ClosedFormView& view);

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

/// What a light may do at every point: its lamps, and what stands before each of them; nothing
/// does in a scene without shadows.
struct ExactLight {
  std::vector<ExactLamp> lamps;
  std::vector<Obstacles> before;
};

/// Of each light, in the scene's order.
std::vector<ExactLight> exact_lights(const Scene& scene);

/// Slide 5 without colours and intensity: the sums of (l.n) and of (h.n)^ns over the lamps in view,
/// times what arrives of each.
struct ExactTerms {
  Exact diffuse = 0, specular = 0;
  bool sure = true;  ///< no boundary is too near
};
ExactTerms terms_at(const SeenPoint& seen, const ExactLight& light, const Material& material);

}  // namespace litmus

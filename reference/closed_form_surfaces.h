// closed_form_surfaces.h: floors, spheres and boxes as pixels see them, and the terms of each light
// there.
#pragma once

#include <span>
#include <vector>

#include "reference/closed_form_view.h"

namespace litmus {

/// What is known of a pixel apart from colours.
struct PixelTerms {
  enum class Sees { Unknown, Nothing, Surface };
  Sees sees = Sees::Unknown;
  const Object* object = nullptr;  ///< of a surface
  std::vector<ExactTerms> lights;  ///< of a surface, one for each light of the scene
};

/// Where the ray first meets a plane, sphere or box; `unsure` is set where its edge passes within
/// kBoundaryBand.
std::optional<SeenPoint> surface_point(const Object& object, const Sight& sight, bool& unsure);

/// Which surface each pixel sees, in closed form, and slide 5 there.
///   Floor: a plane.
///   Spheres: across the ray the normal is (start - centre) / r without its part along the ray,
///     which makes it (u, v) in the ray's own frame, and sqrt(1 - u^2 - v^2) against the ray.
///   Boxes: the face of the last of the three pairs of parallel planes that the ray comes between.
/// Which of them is nearest, and what else hides it, is decided by closed_form_shadow.h; where
/// nothing else is in view, the pixels beside them are background.
class SurfaceOracle {
 public:
  /// Those of `oracles` that are surfaces count. The scene must outlive this. Throws Refusal if it
  /// lacks what they need.
  SurfaceOracle(const Scene& scene, std::span<const Oracle> oracles);

  struct Seen {
    PixelTerms::Sees sees = PixelTerms::Sees::Unknown;
    SeenPoint point{};  ///< of a surface
  };
  Seen see(int x, int y) const;

  PixelTerms at(int x, int y) const;

 private:
  /// The nearest of the surfaces on the ray; nothing, and `unsure`, next to an edge.
  std::optional<SeenPoint> nearest(const Sight& sight, bool& unsure) const;

  const Scene& scene_;
  ClosedFormView view_;
  std::vector<const Object*> surfaces_;
  bool nothing_else_ = true;  ///< is in view
  Obstacles before_eye_;
  std::vector<ExactLight> lights_;
};

}  // namespace litmus

// pixel_condition.h: how much a pixel's closed form changes with what it is computed from.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "reference/closed_form_surfaces.h"

namespace litmus {

/// The condition number C of a light's terms at a pixel: the sum over all quantities q on the way
/// to a term v of size(q) |dv/dq|. A computation that rounds each of them once, by the relative
/// unit u, is wrong by u C, to first order (Higham, Accuracy and Stability of Numerical Algorithms,
/// 2002, 1.6 and 3.1). The size of a coordinate is that of the largest term of the sum that makes
/// it: a vector is as inexact as its largest component, and the point seen as the way to it.
struct TermCondition {
  double diffuse = 0, specular = 0;
};

/// Computes them by differences in extended precision, where the pixel sees a surface.
class PixelCondition {
 public:
  explicit PixelCondition(const Scene& scene)
      : scene_(scene),
        view_(view_of(scene)),
        surfaces_(scene, scene.expect),
        lights_(exact_lights(scene)) {}

  struct AtPixel {
    const Object* object = nullptr;  ///< the surface seen; null: none
    TermCondition terms{};           ///< of the light there
  };
  AtPixel at(int x, int y, std::size_t light) const {
    const SurfaceOracle::Seen seen = surfaces_.see(x, y);
    if (seen.sees != PixelTerms::Sees::Surface) return {};
    const std::vector<SeenPoint> moved = moved_points(seen.point, sight(view_, x, y));
    return {seen.point.object, of(seen.point, moved, lights_[light])};
  }

 private:
  static constexpr Exact kStep = 0x1p-40L;  // far above 2^-64, far below what curves the terms

  static Exact size_of(const ExactVec& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  }

  /// Calls visit(v') with the vector moved by `size` steps along each axis.
  template <class Visit>
  static void nudge(ExactVec v, Exact size, Visit visit) {
    for (int axis = 0; axis < 3; ++axis) {
      ExactVec moved = v;
      moved[axis] += kStep * size;
      visit(moved);
    }
  }

  /// The point seen where the ray, the object, the point, its normal or the way to the eye is
  /// moved.
  static std::vector<SeenPoint> moved_points(const SeenPoint& seen, const Sight& sight) {
    std::vector<SeenPoint> moved;
    const Object& object = *seen.object;
    const auto again = [&](const Sight& ray, const Object& changed) {
      bool unsure = false;
      if (auto point = surface_point(changed, ray, unsure)) {
        point->object = seen.object;
        moved.push_back(*point);
      }
    };
    nudge(sight.start, size_of(sight.start), [&](auto& v) { again({v, sight.along}, object); });
    nudge(sight.along, 1, [&](auto& v) { again({sight.start, glm::normalize(v)}, object); });
    const Exact far = std::max(size_of(sight.start), glm::distance(seen.at, sight.start));
    const auto* sphere = std::get_if<Sphere>(&object.shape);
    nudge(seen.at, far, [&](auto& v) {
      const ExactVec n = sphere ? glm::normalize(v - ExactVec(sphere->center)) : seen.normal;
      moved.push_back({v, n, seen.eye, seen.object});
    });
    if (sphere)
      nudge(ExactVec(sphere->center), size_of(ExactVec(sphere->center)), [&](auto& v) {
        moved.push_back({seen.at, glm::normalize(seen.at - v), seen.eye, seen.object});
      });
    nudge(seen.normal, 1, [&](auto& v) {
      moved.push_back({seen.at, glm::normalize(v), seen.eye, seen.object});
    });
    nudge(seen.eye, 1, [&](auto& v) {
      moved.push_back({seen.at, seen.normal, glm::normalize(v), seen.object});
    });
    return moved;
  }

  /// The lamp with its place, axis or one of its numbers moved.
  static std::vector<ExactLamp> moved_lamps(const ExactLamp& lamp) {
    std::vector<ExactLamp> moved;
    const auto with = [&](auto change) { change(moved.emplace_back(lamp)); };
    nudge(lamp.place, lamp.sun ? 1 : size_of(lamp.place), [&](auto& v) {
      with([&](ExactLamp& l) { l.place = lamp.sun ? glm::normalize(v) : v; });
    });
    if (!lamp.cone) return moved;
    nudge(lamp.cone->axis, 1,
          [&](auto& v) { with([&](ExactLamp& l) { l.cone->axis = glm::normalize(v); }); });
    with([](ExactLamp& l) { l.cone->cutoff *= 1 + kStep; });
    with([](ExactLamp& l) { l.cone->exponent *= 1 + kStep; });
    return moved;
  }

  TermCondition of(const SeenPoint& seen, const std::vector<SeenPoint>& moved,
                   const ExactLight& light) const {
    const Material& material = scene_.materials[std::size_t(seen.object->material)];
    TermCondition sum;
    for (std::size_t i = 0; i < light.lamps.size(); ++i) {
      const ExactLamp& lamp = light.lamps[i];
      const Passage way{seen.at, lamp.place, lamp.sun};
      // A lamp in view stays so, and a hidden one hidden.
      if (!light.before.empty() && passage_through(light.before[i], way, seen.object) != Way::Open)
        continue;
      const ExactTerms here = terms_at(seen, {{lamp}, {}}, material);
      const auto add = [&](const ExactTerms& there) {
        sum.diffuse += double(std::fabs(there.diffuse - here.diffuse) / kStep);
        sum.specular += double(std::fabs(there.specular - here.specular) / kStep);
      };
      for (const SeenPoint& point : moved) add(terms_at(point, {{lamp}, {}}, material));
      for (const ExactLamp& other : moved_lamps(lamp)) add(terms_at(seen, {{other}, {}}, material));
    }
    return sum;
  }

  const Scene& scene_;
  ClosedFormView view_;
  SurfaceOracle surfaces_;
  std::vector<ExactLight> lights_;
};

}  // namespace litmus

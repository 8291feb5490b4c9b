// closed_form_claims.cpp: levels and boundaries.
#include "reference/closed_form_claims.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>

#include "reference/closed_form_curves.h"
#include "reference/closed_form_view.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

/// The floor's height; throws unless it is level.
Exact level_of(const Scene& scene, const Object& floor) {
  const Plane& plane = std::get<Plane>(floor.shape);
  if (plane.normal.x != 0 || plane.normal.y != 0)
    throw Refusal(scene.name + ": expect: curves need a level floor");
  return plane.point.z;
}

/// Everything that throws a shadow on the floor from one lamp.
struct Curves {
  std::vector<Conic> conics;
  std::vector<std::vector<FloorPoint>> polygons;
};

Curves curves_of(const Scene& scene, const Object& floor, const ExactLamp& lamp, Exact level) {
  Curves curves;
  if (!scene.shadows) return curves;
  for (const Object& object : scene.objects) {
    if (&object == &floor || (std::holds_alternative<Plane>(object.shape) && object.camera_visible))
      continue;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape))
      curves.conics.push_back(lamp.sun ? sun_shadow(*sphere, lamp.place, level)
                                       : lamp_shadow(*sphere, lamp.place, level));
    else
      curves.polygons.push_back(corner_shadow(object, lamp, level));
  }
  return curves;
}

/// How deep the point is inside the union of the curves.
Exact depth_in(const Curves& curves, const FloorPoint& point) {
  Exact deepest = -1;
  for (const Conic& conic : curves.conics) deepest = std::max(deepest, depth(conic, point));
  for (const auto& polygon : curves.polygons) deepest = std::max(deepest, depth(polygon, point));
  return deepest;
}

Conic cone_of(const ExactLamp& lamp, Exact level) {
  return cone_on_floor(lamp.place, lamp.cone->axis, lamp.cone->cutoff, level);
}

bool narrow(const ExactCone& cone) { return cone.cutoff < std::numbers::pi_v<Exact> / 2; }

/// What the floor shows of a light at a point: dark, lit, or too near a curve to say.
using Lit = std::function<std::optional<bool>(const FloorPoint&)>;

/// The floor point of each pixel that sees the floor and nothing else.
using FloorPoints = std::vector<std::optional<FloorPoint>>;

std::shared_ptr<const FloorPoints> floor_points(const Scene& scene, const Object& floor) {
  const ClosedFormView view = view_of(scene);
  const Obstacles before_eye = obstacles(scene, eye_of(view), true);
  FloorPoints points(std::size_t(scene.width) * std::size_t(scene.height));
  tbb::parallel_for(0, scene.height, [&](int y) {
    for (int x = 0; x < scene.width; ++x) {
      const Sight through = sight(view, x, y);
      const std::optional<SeenPoint> seen = floor_point(floor, through);
      if (seen && passage_through(before_eye, {seen->at, through.start}, &floor) == Way::Open)
        points[std::size_t(y) * std::size_t(scene.width) + std::size_t(x)] =
            FloorPoint(seen->at.x, seen->at.y);
    }
  });
  return std::make_shared<const FloorPoints>(std::move(points));
}

/// Where the pixel sees the floor and nothing else, its value is 0 exactly where `lit` says so.
Claim boundary(Oracle oracle, std::size_t layer, int width,
               std::shared_ptr<const FloorPoints> points, Lit lit) {
  return {oracle, layer,
          [points = std::move(points), width, lit = std::move(lit)](
              int x, int y, const glm::dvec3& value) -> std::optional<bool> {
            const auto& point = (*points)[std::size_t(y) * std::size_t(width) + std::size_t(x)];
            if (!point) return std::nullopt;
            const std::optional<bool> is_lit = lit(*point);
            if (!is_lit) return std::nullopt;
            return (value != glm::dvec3(0)) == *is_lit;
          }};
}

/// Lit where any lamp's way is outside all curves (and inside its cone).
Lit lit_by(std::vector<Curves> shadows, std::optional<Conic> cone) {
  return [shadows = std::move(shadows), cone](const FloorPoint& point) -> std::optional<bool> {
    bool lit = false;
    for (const Curves& curves : shadows) {
      const Exact d = depth_in(curves, point);
      if (std::fabs(d) < kBoundaryBand) return std::nullopt;
      lit |= d < 0;
    }
    if (!cone) return lit;
    const Exact d = depth(*cone, point);
    if (std::fabs(d) < kBoundaryBand) return std::nullopt;
    return lit && d > 0;
  };
}

}  // namespace

void claim_ambient_levels(const Scene& scene, std::vector<Claim>& claims) {
  if (scene.spectra)
    throw Refusal(scene.name + ": expect: \"ambient\" is of RGB colours, not of bands");
  glm::dvec3 ambient = scene.ambient;
  for (const Light& light : scene.lights) ambient += light.intensity * light.ambient;
  std::vector<glm::dvec3> levels{glm::dvec3(0)};
  for (const Object& object : scene.objects)
    levels.push_back(scene.materials[std::size_t(object.material)].ambient * ambient);
  claims.push_back({Oracle::Ambient, 0, [levels](int, int, const glm::dvec3& value) {
                      return std::optional(
                          std::any_of(levels.begin(), levels.end(), [&](const glm::dvec3& level) {
                            const glm::dvec3 apart = glm::abs(value - level);
                            return std::max({apart.x, apart.y, apart.z}) <= 1e-15;
                          }));
                    }});
}

void claim_shadow_curves(const Scene& scene, std::vector<Claim>& claims) {
  const Object& floor = floor_of(scene);
  const Exact level = level_of(scene, floor);
  const auto points = floor_points(scene, floor);
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    std::vector<Curves> shadows;
    std::optional<Conic> cone;
    for (const ExactLamp& lamp : exact_lamps(scene.lights[k])) {
      if ((lamp.sun ? lamp.place.z : lamp.place.z - level) <= 0)
        throw Refusal(scene.name + ": expect: \"shadow-curves\" needs its lights above the floor");
      if (lamp.cone && !narrow(*lamp.cone))
        throw Refusal(scene.name + ": expect: \"shadow-curves\" needs cutoffs under 90 degrees");
      if (lamp.cone) cone = cone_of(lamp, level);
      shadows.push_back(curves_of(scene, floor, lamp, level));
    }
    claims.push_back(boundary(Oracle::ShadowCurves, k + 1, scene.width, points,
                              lit_by(std::move(shadows), std::move(cone))));
  }
  if (claims.empty()) throw Refusal(scene.name + ": expect: \"shadow-curves\" needs a light");
}

void claim_cone_curves(const Scene& scene, std::vector<Claim>& claims) {
  const Object& floor = floor_of(scene);
  const Exact level = level_of(scene, floor);
  const bool casters = scene.shadows && scene.objects.size() > 1;
  const auto points = floor_points(scene, floor);
  const std::size_t before = claims.size();
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const ExactLamp lamp = exact_lamps(scene.lights[k]).front();
    if (!lamp.cone || !narrow(*lamp.cone)) continue;
    claims.push_back(boundary(
        Oracle::ConeCurve, k + 1, scene.width, points,
        [cone = cone_of(lamp, level), casters](const FloorPoint& point) -> std::optional<bool> {
          const Exact d = depth(cone, point);
          if (std::fabs(d) < kBoundaryBand || (d > 0 && casters)) return std::nullopt;
          return d > 0;
        }));
  }
  if (claims.size() == before)
    throw Refusal(scene.name + ": expect: \"cone-curve\" needs a spot of cutoff under 90 degrees");
}

}  // namespace litmus

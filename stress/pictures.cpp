// pictures.cpp: whole pictures. None has a pixel that is not finite, and none changes with the
// rounding mode by more than its error.
#include <fmt/format.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <thread>

#include "scene/load.h"
#include "stress/hostile_scenes.h"
#include "stress/naive.h"
#include "stress/ulp.h"
#include "tracer/camera.h"
#include "tracer/closest.h"
#include "tracer/render.h"
#include "tracer/visibility.h"

namespace litmus {
namespace {

bool finite(const glm::dvec3& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

template <Real R>
constexpr Precision kPrecision = std::is_same_v<R, float> ? Precision::Float : Precision::Double;

// ---- Pixels that are not finite --------------------------------------------------------------

/// Slides 5, 11 and 16 as they are usually written, at a point that the camera sees.
template <Real R>
R naive_color(const Lamp<R>& lamp, const Hit<R>& hit, const Vec<R>& eye, R shininess) {
  const Vec<R> apart = lamp.origin - hit.point;
  const R distance = std::sqrt(dot(apart, apart));
  const Vec<R> l = lamp.directional ? lamp.toward : apart / distance;
  R intensity = 1;
  if (lamp.attenuated) {
    intensity = naive::linear_attenuation(lamp.range, distance, lamp.linear) *
                naive::quadratic_attenuation(lamp.range, distance, lamp.quadratic);
  }
  if (lamp.cone)
    intensity *= naive::spot_decay(naive::angle_between(lamp.axis, -l), lamp.cutoff, lamp.exponent);
  const Vec<R> h = naive::normalize(l + eye);
  return intensity *
         (std::max(dot(l, hit.normal), R(0)) + naive::specular_power(h, hit.normal, shininess));
}

template <Real R>
std::uint64_t naive_nonfinite(const Scene& scene) {
  const Plan<R> plan = lower<R>(scene);
  std::uint64_t count = 0;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const Ray<R> ray =
          camera_ray(plan.view, screen<R>(x, scene.width), -screen<R>(y, scene.height));
      const Hit<R> hit = closest_hit(plan, ray);
      if (hit.kind == Kind::None) continue;
      R total = 0;
      for (const Source<R>& source : plan.sources) {
        for (const Lamp<R>& lamp : source.lamps) {
          total += naive_color(lamp, hit, -normalize(ray.direction),
                               plan.finishes[std::size_t(hit.object)].shininess.value);
        }
      }
      count += !std::isfinite(total);
    }
  }
  return count;
}

template <Real R>
StressRow nonfinite_row(const std::vector<Scene>& scenes) {
  std::uint64_t pixels = 0, ours = 0, naive = 0;
  for (const Scene& scene : scenes) {
    const Rendering rendering = render(scene, {kPrecision<R>});
    pixels += rendering.whole.pixels.size();
    ours +=
        std::uint64_t(std::count_if(rendering.whole.pixels.begin(), rendering.whole.pixels.end(),
                                    [](const glm::dvec3& c) { return !finite(c); }));
    naive += naive_nonfinite<R>(scene);
  }
  const std::string scalar(kScalarName<R>);
  return {"nonfinite-" + scalar,
          "pictures",
          "pixels that are NaN or infinite",
          scalar,
          fmt::format("{} scenes: hostile lights, views and readings of slide 5", scenes.size()),
          "pixels",
          pixels,
          double(ours),
          0,
          "the slides' formulas word for word",
          double(naive)};
}

// ---- Rounding modes --------------------------------------------------------------------------

constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// The scene rendered in one rounding mode. A thread of its own keeps the mode from everybody else;
/// the pool that it starts takes the mode over.
Rendering render_rounding(const Scene& scene, const RenderOptions& options, int mode) {
  Rendering rendering;
  std::thread([&] {
    std::fesetround(mode);
    rendering = render(scene, options);
  }).join();
  return rendering;
}

struct RoundingTally {
  std::uint64_t pixels = 0, flips = 0, steady = 0, uncovered = 0, uncovered_by_a_thousandth = 0;
};

/// One unit in the last place of the largest channel.
double unit_of(Precision precision, const glm::dvec3& color) {
  const double epsilon = precision == Precision::Float ? std::numeric_limits<float>::epsilon()
                                                       : std::numeric_limits<double>::epsilon();
  return epsilon * std::max({color.x, color.y, color.z});
}

/// The four pictures of a scene against each other and against quad precision.
void compare_modes(const Scene& scene, Precision precision, bool with_truth, RoundingTally& tally) {
  std::vector<Rendering> modes;
  for (const int mode : kModes) modes.push_back(render_rounding(scene, {precision}, mode));
  Picture truth;
  if (with_truth) truth = render(scene, {Precision::Quad}).whole;
  for (std::size_t i = 0; i < modes[0].whole.pixels.size(); ++i) {
    ++tally.pixels;
    const bool flips = std::any_of(modes.begin() + 1, modes.end(), [&](const Rendering& other) {
      for (std::size_t k = 0; k < other.signatures.size(); ++k)
        if (other.signatures[k].values[i] != modes[0].signatures[k].values[i]) return true;
      return false;
    });
    tally.flips += flips;
    if (!with_truth || flips) continue;
    double spread = 0, error = 0;
    for (int c = 0; c < 3; ++c) {
      double low = modes[0].whole.pixels[i][c], high = low;
      for (const Rendering& mode : modes) {
        low = std::min(low, mode.whole.pixels[i][c]),
        high = std::max(high, mode.whole.pixels[i][c]);
      }
      spread = std::max(spread, high - low);
      error = std::max(error, std::fabs(modes[0].whole.pixels[i][c] - truth.pixels[i][c]));
    }
    ++tally.steady;
    // Four roundings may agree on a value that is not exact: half a unit is no surprise.
    const double unit = unit_of(precision, truth.pixels[i]);
    tally.uncovered += error > std::max(2 * spread, unit);
    tally.uncovered_by_a_thousandth += error > std::max(2e-3 * spread, 1e-3 * unit);
  }
}

/// A canonical scene of at most 16 pixels a side, moved along x by `offset`.
Scene small(Scene scene, double offset) {
  const double shrink = 16.0 / std::max(scene.width, scene.height);
  scene.width = std::max(1, int(scene.width * shrink)),
  scene.height = std::max(1, int(scene.height * shrink));
  scene.samples = 1;
  const Vector by{offset, 0, 0};
  scene.camera.eye += by, scene.camera.target += by;
  for (Object& object : scene.objects) {
    std::visit(
        [&](auto& shape) {
          using S = std::decay_t<decltype(shape)>;
          if constexpr (std::is_same_v<S, Sphere>) shape.center += by;
          if constexpr (std::is_same_v<S, Plane>) shape.point += by;
          if constexpr (std::is_same_v<S, Box>) shape.min += by, shape.max += by;
          if constexpr (std::is_same_v<S, Triangle>) shape.a += by, shape.b += by, shape.c += by;
          if constexpr (std::is_same_v<S, Mesh>)
            for (Point& vertex : shape.vertices) vertex += by;
        },
        object.shape);
  }
  for (Light& light : scene.lights) {
    if (auto* point = std::get_if<PointLight>(&light.shape)) point->origin += by;
    if (auto* spot = std::get_if<SpotLight>(&light.shape)) spot->point.origin += by;
    if (auto* area = std::get_if<AreaLight>(&light.shape)) {
      if (!area->normal) area->normal = -area->point.origin;
      area->point.origin += by;
    }
  }
  return scene;
}

template <Real R>
void add_rounding_rows(std::vector<StressRow>& rows, const std::vector<Scene>& scenes) {
  const double far = std::is_same_v<R, float> ? 0x1p16 : 0x1p44;
  RoundingTally here, away;
  for (const Scene& scene : scenes) {
    compare_modes(small(scene, 0), kPrecision<R>, true, here);
    compare_modes(small(scene, far), kPrecision<R>, false, away);
  }
  const std::string scalar(kScalarName<R>);
  const std::string domain = fmt::format("{} canonical scenes, 16 pixels wide", scenes.size());
  rows.push_back({"flips-" + scalar, "pictures",
                  "pixels that another rounding mode decides otherwise", scalar, domain, "pixels",
                  here.pixels, double(here.flips), 0,
                  fmt::format("the scenes {:.2g} units away", far), double(away.flips)});
  const double share = 100.0 / double(std::max<std::uint64_t>(1, here.steady));
  rows.push_back({"spread-" + scalar, "pictures",
                  "pixels whose error is over twice the spread over the rounding modes and over "
                  "one unit in the last place",
                  scalar, domain, "% of pixels", here.steady, share * double(here.uncovered), 0.5,
                  "a thousandth of both", share * double(here.uncovered_by_a_thousandth)});
}

}  // namespace

std::vector<StressRow> stress_pictures(const StressOptions&) {
  const std::vector<Scene> hostile = hostile_scenes();
  std::vector<StressRow> rows{nonfinite_row<float>(hostile), nonfinite_row<double>(hostile)};
  const std::vector<Scene> canonical = load_canonical_scenes().scenes;
  add_rounding_rows<float>(rows, canonical);
  add_rounding_rows<double>(rows, canonical);
  return rows;
}

}  // namespace litmus

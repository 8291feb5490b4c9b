// render_sampled.cpp: the loop over pixels for area lights that are not sampled on their grid.
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>

#include "scene/refusal.h"
#include "tracer/area_sampling.h"
#include "tracer/camera.h"
#include "tracer/certified.h"
#include "tracer/closest.h"
#include "tracer/light_terms.h"

namespace litmus {
namespace {

using V3 = Vec<double>;

/// A light of the scene with its rectangle, if it has one.
struct SampledSource {
  const Source<double>* source;
  std::optional<Panel> panel;
  int n = 1;                         ///< samples along each side
  std::vector<LightSample> samples;  ///< where they are the same for all pixels
};

struct Setup {
  Plan<double> plan;
  Occluders occluders;
  std::vector<SampledSource> sources;
  RenderOptions options;
};

/// Sums of what was done, over all threads.
struct Totals {
  std::atomic<std::uint64_t> rays{0}, evaluations{0};
};

bool may_meet_triangles(const Plan<double>& plan, const Panel& panel) {
  const V3 c = panel.center;
  const auto reach = [&](int axis) {
    return std::fabs(panel.across[axis]) + std::fabs(panel.up[axis]);
  };
  return std::any_of(plan.triangles.begin(), plan.triangles.end(), [&](const auto& corners) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
      if (low > c[axis] + reach(axis) || high < c[axis] - reach(axis)) return false;
    }
    return true;
  });
}

Panel panel_of(const Plan<double>& plan, const Source<double>& source, const AreaLight& light) {
  const AreaFrame<double> frame = area_frame<double>(light);
  Panel panel{source.lamps[0], V3(light.point.origin), light.width / 2 * frame.right,
              light.height / 2 * frame.up};
  panel.meets_triangles = may_meet_triangles(plan, panel);
  return panel;
}

Setup set_up(const Scene& scene, const RenderOptions& options) {
  Setup setup{lower<double>(scene), {}, {}, options};
  if (options.sampler == Sampler::Certified)
    setup.occluders.edges = edge_tree(setup.plan.triangles);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    SampledSource one{&setup.plan.sources[i], {}, 1, {}};
    const AreaLight* area = std::get_if<AreaLight>(&scene.lights[i].shape);
    if (area && !one.source->lamps.empty()) {
      one.panel = panel_of(setup.plan, *one.source, *area);
      one.n = options.area_samples > 0 ? options.area_samples : std::max(area->columns, area->rows);
      if (options.sampler == Sampler::Gauss) one.samples = light_samples(options.sampler, one.n, 0);
    }
    setup.sources.push_back(std::move(one));
  }
  // The plan has moved: its sources with it.
  for (std::size_t i = 0; i < setup.sources.size(); ++i)
    setup.sources[i].source = &setup.plan.sources[i];
  return setup;
}

/// What one light does at a hit, its colours left out, and how far that may be off.
struct Answer {
  LightTerms<double> terms, bound;
  std::uint64_t rays = 0, evaluations = 0;
};

Answer by_points(const Setup& setup, const SampledSource& one, const Hit<double>& hit,
                 const V3& eye, std::uint64_t pixel) {
  std::vector<LightSample> own;
  if (one.samples.empty()) own = light_samples(setup.options.sampler, one.n, pixel);
  Answer answer;
  std::size_t reached = 0, lit = 0;
  Lamp<double> lamp = one.panel->lamp;
  for (const LightSample& sample : one.samples.empty() ? own : one.samples) {
    lamp.origin =
        one.panel->center + 2 * sample.u * one.panel->across + 2 * sample.v * one.panel->up;
    const LampTerms<double> terms = lamp_terms(setup.plan, lamp, hit, eye);
    reached += terms.reached, lit += terms.lit;
    if (terms.terms.specular > terms.light.intensity / 2) answer.terms.flags |= kHighlight;
    answer.terms.diffuse += sample.weight * terms.terms.diffuse;
    answer.terms.specular += sample.weight * terms.terms.specular;
  }
  if (reached > 0) answer.terms.flags |= lit == reached ? kLit : lit > 0 ? kPenumbra : kUmbra;
  answer.rays = setup.plan.shadows ? reached : 0, answer.evaluations = lit;
  return answer;
}

Answer by_proof(const Setup& setup, const SampledSource& one, const Hit<double>& hit,
                const V3& eye) {
  const Finish<double>& finish = setup.plan.finishes[std::size_t(hit.object)];
  const Terms<double> weight{max_abs(finish.diffuse * one.source->diffuse),
                             max_abs(finish.specular * one.source->specular)};
  const PanelTerms terms =
      certified_terms(setup.plan, setup.occluders, *one.panel, hit, eye, weight, one.n);
  Answer answer;
  answer.terms.diffuse = terms.value.diffuse, answer.terms.specular = terms.value.specular;
  answer.bound.diffuse = terms.bound.diffuse, answer.bound.specular = terms.bound.specular;
  answer.terms.flags = terms.flags;
  answer.rays = terms.rays, answer.evaluations = terms.evaluations;
  return answer;
}

/// One sample of the picture, added to the pixel's layers with that weight.
void look(const Setup& setup, double x, double y, std::uint64_t number, double weight,
          std::size_t pixel, Rendering& result, Totals& totals) {
  const Plan<double>& plan = setup.plan;
  const Ray<double> ray = camera_ray(plan.view, x, y);
  const Hit<double> hit = closest_hit(plan, ray);
  for (Signature& signature : result.signatures)
    signature.values[pixel] = mix(signature.values[pixel], std::uint64_t(hit.object + 1));
  if (hit.kind == Kind::None) return;
  const V3 eye = -normalize(ray.direction);
  const Finish<double>& finish = plan.finishes[std::size_t(hit.object)];
  const auto add = [&](const V3& color, Picture& picture) {
    picture.pixels[pixel] += weight * glm::dvec3(color.x, color.y, color.z);
  };
  add(finish.ambient * plan.ambient, result.layers[0].picture);
  for (std::size_t i = 0; i < setup.sources.size(); ++i) {
    const SampledSource& one = setup.sources[i];
    Answer answer;
    if (!one.panel) {
      answer.terms = light_terms(plan, *one.source, hit, eye);
    } else if (setup.options.sampler == Sampler::Certified) {
      answer = by_proof(setup, one, hit, eye);
      add(light_color(plan, *one.source, finish, answer.bound, task_of(plan)), result.bound);
    } else {
      answer = by_points(setup, one, hit, eye, number);
    }
    add(light_color(plan, *one.source, finish, answer.terms, task_of(plan)),
        result.layers[i + 1].picture);
    std::uint64_t& signature = result.signatures[i + 1].values[pixel];
    signature = mix(signature, one.panel ? answer.terms.flags : answer.terms.signature);
    result.flags[i + 1][pixel] |= answer.terms.flags;
    totals.rays += answer.rays, totals.evaluations += answer.evaluations;
  }
}

void render_row(const Setup& setup, int y, Rendering& result, Totals& totals) {
  const View<double>& view = setup.plan.view;
  const int n = view.samples, across = view.width * n, down = view.height * n;
  for (int x = 0; x < view.width; ++x) {
    const std::size_t pixel = std::size_t(y) * std::size_t(view.width) + std::size_t(x);
    for (int j = y * n; j < (y + 1) * n; ++j) {
      for (int i = x * n; i < (x + 1) * n; ++i) {
        look(setup, screen(double(i), across, 2 * setup.options.shift_x * n),
             -screen(double(j), down, 2 * setup.options.shift_y * n),
             std::uint64_t(j) * std::uint64_t(across) + std::uint64_t(i), 1.0 / (n * n), pixel,
             result, totals);
      }
    }
    for (const Layer& layer : result.layers)
      result.whole.pixels[pixel] += layer.picture.pixels[pixel];
  }
}

Rendering blank(const Scene& scene, bool bounded) {
  Rendering result;
  result.whole = Picture(scene.width, scene.height);
  if (bounded) result.bound = result.whole;
  result.layers.push_back({"ambient", "ambient", result.whole});
  for (const Light& light : scene.lights)
    result.layers.push_back({light.name, std::string(light_type(light)), result.whole});
  const std::size_t pixels = result.whole.pixels.size();
  result.signatures.assign(result.layers.size(), Signature{scene.width, scene.height,
                                                           std::vector<std::uint64_t>(pixels)});
  result.flags.assign(result.layers.size(), std::vector<std::uint8_t>(pixels));
  return result;
}

Rendering render_off_grid(const Scene& scene, const RenderOptions& options) {
  if (options.precision != Precision::Double)
    throw Refusal("sampler: " + std::string(sampler_name(options.sampler)) +
                  " works in double precision; scene, centres and corners in every one");
  if (scene.shading == Shading::SampleCode)
    throw Refusal("sampler: " + std::string(sampler_name(options.sampler)) +
                  " cannot render shading = \"sample-code\", where each sample of an area light is "
                  "a light; use scene, centres or corners");
  const Setup setup = set_up(scene, options);
  Rendering result = blank(scene, options.sampler == Sampler::Certified);
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
  }
  Totals totals;
  const auto start = std::chrono::steady_clock::now();
  tbb::parallel_for(0, scene.height, [&](int y) { render_row(setup, y, result, totals); });
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.area_rays = totals.rays, result.area_evaluations = totals.evaluations;
  return result;
}

}  // namespace

Rendering render_with_sampler(const Scene& scene, const RenderOptions& options) {
  const bool on_grid = options.sampler == Sampler::Scene || options.sampler == Sampler::Centres ||
                       options.sampler == Sampler::Corners;
  if (!on_grid) return render_off_grid(scene, options);
  Scene changed = scene;
  for (Light& light : changed.lights) {
    AreaLight* area = std::get_if<AreaLight>(&light.shape);
    if (!area) continue;
    if (options.area_samples > 0) area->columns = area->rows = options.area_samples;
    if (options.sampler == Sampler::Centres) area->placement = Placement::Centres;
    if (options.sampler == Sampler::Corners) area->placement = Placement::Corners;
  }
  RenderOptions plain = options;
  plain.sampler = Sampler::Scene, plain.area_samples = 0;
  return render(changed, plain);
}

}  // namespace litmus

// render.cpp: the loop over pixels, samples and lights, for each scalar.
#include "tracer/render.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "tracer/camera.h"
#include "tracer/light_terms.h"

namespace litmus {
namespace {

/// What one sample sees: a colour and a signature per layer.
template <Real R>
struct Seen {
  std::vector<Vec<Sum<R>>> colors;
  std::vector<std::uint64_t> signatures;
  std::vector<std::uint8_t> flags;
};

template <Real R>
Vec<Sum<R>> wide(const Vec<R>& v) {
  return {Sum<R>(v.x), Sum<R>(v.y), Sum<R>(v.z)};
}

template <Real R>
void look(const Plan<R>& plan, R x, R y, Seen<R>& seen) {
  const Ray<R> ray = camera_ray(plan.view, x, y);
  const Hit<R> hit = closest_hit(plan, ray);
  std::fill(seen.colors.begin(), seen.colors.end(), Vec<Sum<R>>{});
  std::fill(seen.signatures.begin(), seen.signatures.end(), std::uint64_t(hit.object + 1));
  std::fill(seen.flags.begin(), seen.flags.end(), std::uint8_t(0));
  if (hit.kind == Kind::None) return;
  const Vec<R> eye = -normalize(ray.direction);
  const Finish<R>& finish = plan.finishes[std::size_t(hit.object)];
  if (!plan.sample_code) seen.colors[0] = wide(finish.ambient) * wide(plan.ambient);
  for (std::size_t i = 0; i < plan.sources.size(); ++i) {
    const LightTerms<R> terms = light_terms(plan, plan.sources[i], hit, eye);
    seen.colors[i + 1] = light_color(plan, plan.sources[i], finish, terms);
    seen.signatures[i + 1] = mix(seen.signatures[i + 1], terms.signature);
    seen.flags[i + 1] = terms.flags;
  }
}

template <Real R>
glm::dvec3 to_double(const Vec<R>& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

Rendering blank(const Scene& scene) {
  Rendering result;
  result.whole = Picture(scene.width, scene.height);
  result.layers.push_back({"ambient", "ambient", result.whole});
  for (const Light& light : scene.lights) {
    result.layers.push_back({light.name, std::string(light_type(light)), result.whole});
  }
  const Signature signature{scene.width, scene.height,
                            std::vector<std::uint64_t>(result.whole.pixels.size())};
  result.signatures.assign(result.layers.size(), signature);
  result.flags.assign(result.layers.size(), std::vector<std::uint8_t>(signature.values.size()));
  return result;
}

template <Real R>
void render_row(const Plan<R>& plan, const RenderOptions& options, int y, Rendering& result) {
  const int n = plan.view.samples;
  const int across = plan.view.width * n, down = plan.view.height * n;
  const R shift_x = R(2 * options.shift_x * n), shift_y = R(2 * options.shift_y * n);
  const std::size_t layers = result.layers.size();
  Seen<R> seen{std::vector<Vec<Sum<R>>>(layers), std::vector<std::uint64_t>(layers),
               std::vector<std::uint8_t>(layers)};
  std::vector<Vec<Sum<R>>> totals(layers);
  for (int x = 0; x < plan.view.width; ++x) {
    std::fill(totals.begin(), totals.end(), Vec<Sum<R>>{});
    Vec<Sum<R>> whole;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        look(plan, screen(x * n + i, across, shift_x), -screen(y * n + j, down, shift_y), seen);
        for (std::size_t k = 0; k < layers; ++k) {
          totals[k] = totals[k] + seen.colors[k];
          whole = whole + seen.colors[k];
          std::uint64_t& signature =
              result.signatures[k].values[std::size_t(y * plan.view.width + x)];
          signature = mix(signature, seen.signatures[k]);
          result.flags[k][std::size_t(y * plan.view.width + x)] |= seen.flags[k];
        }
      }
    }
    const Sum<R> count = Sum<R>(n * n);
    for (std::size_t k = 0; k < layers; ++k)
      result.layers[k].picture.at(x, y) = to_double(totals[k] / count);
    result.whole.at(x, y) = to_double(whole / count);
  }
}

template <Real R>
Rendering render_in(const Scene& scene, const RenderOptions& options) {
  const Plan<R> plan = lower<R>(scene);
  Rendering result = blank(scene);
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
  }
  const auto start = std::chrono::steady_clock::now();
  tbb::parallel_for(0, scene.height, [&](int y) { render_row(plan, options, y, result); });
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace

std::string_view precision_name(Precision precision) {
  static constexpr std::string_view kNames[] = {"float", "double", "long-double", "quad"};
  return kNames[std::size_t(precision)];
}

Rendering render(const Scene& scene, const RenderOptions& options) {
  switch (options.precision) {
    case Precision::Float:
      return render_in<float>(scene, options);
    case Precision::LongDouble:
      return render_in<long double>(scene, options);
    case Precision::Quad:
      return render_in<Quad>(scene, options);
    case Precision::Double:
      break;
  }
  return render_in<double>(scene, options);
}

Probe probe(const Scene& scene, const RenderOptions& options) {
  const auto plan = std::make_shared<const Plan<double>>(lower<double>(scene));
  return [plan, options](double x, double y) {
    const View<double>& view = plan->view;
    const std::size_t layers = plan->sources.size() + 1;
    const int n = view.samples;
    Seen<double> seen{std::vector<Vec<double>>(layers), std::vector<std::uint64_t>(layers),
                      std::vector<std::uint8_t>(layers)};
    std::vector<glm::dvec3> colors(layers);
    for (int sample = 0; sample < n * n; ++sample) {
      const double dx = (sample % n + 0.5) / n - 0.5 + options.shift_x;
      const double dy = (sample / n + 0.5) / n - 0.5 + options.shift_y;
      look(*plan, 2 * (x + dx) / view.width - 1, 1 - 2 * (y + dy) / view.height, seen);
      for (std::size_t k = 0; k < layers; ++k)
        colors[k] += to_double(seen.colors[k]) / double(n * n);
    }
    return colors;
  };
}

}  // namespace litmus

// render.cpp: the loop over pixels, samples and lights, for each scalar.
#include "tracer/render.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "tracer/area_sampling.h"
#include "tracer/pixels.h"

namespace litmus {
namespace {

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
Rendering render_in(const Scene& scene, const RenderOptions& options) {
  const Plan<R> plan = lower<R>(scene);
  Rendering result = blank(scene);
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
  }
  const auto start = std::chrono::steady_clock::now();
  tbb::parallel_for(0, scene.height, [&](int y) { render_row<R>(plan, options, y, result); });
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace

std::string_view precision_name(Precision precision) {
  static constexpr std::string_view kNames[] = {"float", "double", "long-double", "quad"};
  return kNames[std::size_t(precision)];
}

Rendering render(const Scene& scene, const RenderOptions& options) {
  if (options.sampler != Sampler::Scene || options.area_samples > 0)
    return render_with_sampler(scene, options);
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
    Seen<double> seen(layers);
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

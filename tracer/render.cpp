// render.cpp: the loop over pixels, samples and lights, for each scalar.
#include "tracer/render.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "tracer/area_sampling.h"
#include "tracer/bands.h"
#include "tracer/kernel.h"
#include "tracer/pixels.h"

namespace litmus {
namespace {

Rendering blank(const Scene& scene, const RenderOptions& options) {
  Rendering result;
  result.whole = Picture(scene.width, scene.height);
  const std::size_t layers = scene.lights.size() + 1;
  if (options.layers) {
    result.layers.push_back({"ambient", "ambient", result.whole});
    for (const Light& light : scene.lights) {
      result.layers.push_back({light.name, std::string(light_type(light)), result.whole});
    }
  }
  if (options.edges) {
    const Signature signature{scene.width, scene.height,
                              std::vector<std::uint64_t>(result.whole.pixels.size())};
    result.signatures.assign(layers, signature);
    result.flags.assign(layers, std::vector<std::uint8_t>(signature.values.size()));
  }
  return result;
}

/// The packet renderer that the options name, if R has one.
template <Real R>
const PacketKernel* packet_kernel(const RenderOptions& options) {
  if (!kOwnMath<R> || options.kernel == Kernel::Scalar) return nullptr;
  for (const PacketKernel& kernel : packet_kernels()) {
    if (options.target.empty() || kernel.target == options.target) return &kernel;
  }
  return nullptr;
}

template <Real R>
RowRenderer<R> row_renderer(const PacketKernel* kernel) {
  if constexpr (std::is_same_v<R, float>) {
    if (kernel) return kernel->float_row;
  } else if constexpr (std::is_same_v<R, double>) {
    if (kernel) return kernel->double_row;
  }
  return render_row<R, R>;
}

template <Real R>
Rendering render_in(const Scene& scene, const RenderOptions& options) {
  Plan<R> plan = lower<R>(scene, options.effects ? *options.effects : effects_of(scene));
  plan.edges = options.edges;
  Rendering result = blank(scene, options);
  const PacketKernel* const kernel = packet_kernel<R>(options);
  const RowRenderer<R> row = row_renderer<R>(kernel);
  result.target = kernel ? kernel->target : "scalar";
  std::vector<Counts> counts(options.counts ? std::size_t(scene.height) : 0);
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
  }
  const auto start = std::chrono::steady_clock::now();
  tbb::parallel_for(0, scene.height, [&](int y) {
    row(plan, options, y, result, counts.empty() ? nullptr : &counts[std::size_t(y)]);
  });
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const Counts& one : counts) result.counts += one;
  return result;
}

}  // namespace

std::string_view precision_name(Precision precision) {
  static constexpr std::string_view kNames[] = {"float", "double", "long-double", "quad"};
  return kNames[std::size_t(precision)];
}

std::string_view kernel_name(Kernel kernel) {
  static constexpr std::string_view kNames[] = {"auto", "scalar", "packet"};
  return kNames[std::size_t(kernel)];
}

Rendering render(const Scene& scene, const RenderOptions& options) {
  if (scene.spectra) return render_bands(scene, options).rendering;
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
  if (scene.spectra) return probe_bands(scene, options);
  const auto plan = std::make_shared<const Plan<double>>(lower<double>(scene));
  return [plan, options](double x, double y) {
    const View<double>& view = plan->view;
    const std::size_t layers = plan->sources.size() + 1;
    const int n = view.samples;
    std::vector<glm::dvec3> colors(layers);
    for (int sample = 0; sample < n * n; ++sample) {
      const double dx = (sample % n + 0.5) / n - 0.5 + options.shift_x;
      const double dy = (sample / n + 0.5) / n - 0.5 + options.shift_y;
      look(*plan, 2 * (x + dx) / view.width - 1, 1 - 2 * (y + dy) / view.height,
           [&](std::size_t k, const Seen<double>& seen) {
             colors[k] += to_double(seen.color) / double(n * n);
           });
    }
    return colors;
  };
}

}  // namespace litmus

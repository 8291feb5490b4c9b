// peer_kernels.cpp: litmus's own kernels, and what their arithmetic allows.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "reports/peer_entrants.h"
#include "tracer/cpu_clock.h"
#include "tracer/kernel.h"
#include "tracer/pixels.h"

namespace litmus {
namespace {

template <Real R>
Entrant rows_entrant(const std::string& name, const Scene& scene, RowRenderer<R> row) {
  auto plan = std::make_shared<Plan<R>>(lower<R>(scene));
  plan->edges = false;
  auto picture = std::make_shared<Rendering>();
  picture->whole = Picture(scene.width, scene.height);
  const auto once = [=] {
    RenderOptions options;
    options.layers = options.edges = false;
    const double start = cpu_seconds();
    for (int y = 0; y < picture->whole.height; ++y) row(*plan, options, y, *picture, nullptr);
    return cpu_seconds() - start;
  };
  return {name, [=] { return least_of(once); }};
}

double limit_seconds(const Operations& operations, const ArithmeticRates& rates) {
  const double sums = double(operations.sums + operations.fused) / rates.sums;
  const double slow =
      double(operations.divisions) / rates.divisions + double(operations.roots) / rates.roots;
  return std::max(sums, slow);  // units of their own, which work at the same time
}

}  // namespace

std::vector<Entrant> kernel_entrants(const Scene& scene) {
  const std::string kDouble = "litmus, double", kFloat = "litmus, float";
  std::vector<Entrant> entrants;
  if (packet_kernels().empty()) {
    const std::string why = "this processor has no AVX2, which packets need";
    entrants = {{kDouble, {}, why}, {kFloat, {}, why}};
  } else {
    const PacketKernel& kernel = packet_kernels()[0];
    entrants = {rows_entrant<double>(kDouble, scene, kernel.double_row),
                rows_entrant<float>(kFloat, scene, kernel.float_row)};
  }
  entrants.push_back({"litmus, double, pixel by pixel", [=] {
                        RenderOptions options{.threads = 1, .kernel = Kernel::Scalar};
                        options.layers = options.edges = false;
                        const double start = cpu_seconds();
                        render(scene, options);
                        return cpu_seconds() - start;
                      }});
  return entrants;
}

Operations counted_operations(const Scene& scene, Picture* picture) {
  Plan<double> plan = lower<double>(scene);
  plan.edges = false;
  RenderOptions options;
  options.layers = options.edges = false;
  Rendering rendering;
  rendering.whole = Picture(scene.width, scene.height);
  Counted::tally = {};
  for (int y = 0; y < scene.height; ++y) render_row<Counted>(plan, options, y, rendering, nullptr);
  if (picture) *picture = std::move(rendering.whole);
  return Counted::tally;
}

Entrant limit_entrant(const Operations& operations, const ArithmeticRates& rates) {
  const std::string name = "its operations, counted, at this processor's rates";
  if (rates.sums == 0) return {name, {}, "no rates for this processor: it has no AVX2"};
  // Measured anew each time: a busy machine slows them as it does the picture.
  return {name, [=] { return limit_seconds(operations, arithmetic_rates()); }};
}

std::vector<std::string> limit_notes(const Operations& operations, const ArithmeticRates& rates,
                                     double pixels) {
  if (rates.sums == 0) return {};
  constexpr double kGiga = 1e9;
  return {fmt::format("Counted: {:.0f} sums and products, {:.1f} divisions, {:.1f} roots a pixel.",
                      double(operations.sums + operations.fused) / pixels,
                      double(operations.divisions) / pixels, double(operations.roots) / pixels),
          fmt::format("Rates: {:.0f}, {:.1f} and {:.1f} thousand million a second. The ratio is "
                      "the share of them that is reached.",
                      rates.sums / kGiga, rates.divisions / kGiga, rates.roots / kGiga)};
}

}  // namespace litmus

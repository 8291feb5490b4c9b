// effects_study.cpp: needed effects beside all of them, scene by scene.
#include "reports/effects_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "reports/cost_measure.h"
#include "reports/plain_text.h"
#include "tracer/cpu_clock.h"

namespace litmus {
namespace {

bool same_pixels(const Picture& a, const Picture& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(a.pixels[0])) == 0;
}

double timed(const Scene& scene, const Effects& effects) {
  RenderOptions options{.threads = 1, .effects = effects};
  options.layers = options.edges = false;
  const double start = cpu_seconds();
  render(scene, options);
  return cpu_seconds() - start;
}

EffectUse use_of(Scene scene, const CostOptions& options) {
  scene = cost_sized(std::move(scene), options);
  EffectUse use{.scene = scene.name, .called_for = effects_of(scene)};
  const Rendering needed = render(scene, {.effects = use.called_for, .counts = true}),
                  all = render(scene, {.effects = all_effects(), .counts = true});
  use.needed = needed.counts, use.all = all.counts;
  use.identical = same_bits(needed, all);
  std::vector<double> needed_seconds, all_seconds;
  for (int i = 0; i < (options.quick ? kFewCostRepeats : kCostRepeats); ++i) {
    needed_seconds.push_back(timed(scene, use.called_for));
    all_seconds.push_back(timed(scene, all_effects()));
  }
  use.needed_time = time_of(needed_seconds), use.all_time = time_of(all_seconds);
  return use;
}

}  // namespace

double EffectUse::saving() const {
  return needed_time.least > 0 ? all_time.least / needed_time.least : 0;
}

bool same_bits(const Rendering& a, const Rendering& b) {
  return same_pixels(a.whole, b.whole) &&
         std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(),
                    [](const auto& x, const auto& y) { return same_pixels(x.picture, y.picture); });
}

std::vector<EffectUse> measure_effects(std::span<const Scene> scenes, const CostOptions& options) {
  std::vector<EffectUse> uses;
  for (const Scene& scene : scenes) uses.push_back(use_of(scene, options));
  return uses;
}

std::string effects_sentence(const std::vector<EffectUse>& uses) {
  if (uses.empty()) return "";
  std::vector<double> savings;
  for (const EffectUse& use : uses) savings.push_back(use.saving());
  std::sort(savings.begin(), savings.end());
  const auto same =
      std::count_if(uses.begin(), uses.end(), [](const EffectUse& u) { return u.identical; });
  return fmt::format(
      "Every effect everywhere takes {} times as long as what a scene calls for ({} to {}; median "
      "of {}); {} bit by bit the same.",
      short_number(median(savings)), short_number(savings.front()), short_number(savings.back()),
      counted((long long)(uses.size()), "scene", "scenes"),
      same == std::ssize(uses) ? "all pictures are" : fmt::format("only {} pictures are", same));
}

}  // namespace litmus

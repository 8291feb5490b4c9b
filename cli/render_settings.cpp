// render_settings.cpp: words of the command line as settings of the tracer, and its counts as
// lines.
#include "cli/render_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "scene/refusal.h"
#include "tracer/kernel.h"

namespace litmus {
namespace {

constexpr Precision kPrecisions[] = {Precision::Float, Precision::Double, Precision::LongDouble,
                                     Precision::Quad};

}  // namespace

std::vector<std::string> precision_names() {
  std::vector<std::string> names;
  for (const Precision precision : kPrecisions) names.emplace_back(precision_name(precision));
  return names;
}

Precision precision_of(const std::string& name) {
  for (const Precision precision : kPrecisions)
    if (precision_name(precision) == name) return precision;
  return Precision::Double;
}

std::vector<std::string> sampler_names() {
  std::vector<std::string> names;
  for (const Sampler sampler : kSamplers) names.emplace_back(sampler_name(sampler));
  return names;
}

Sampler sampler_of(const std::string& name) {
  for (const Sampler sampler : kSamplers)
    if (sampler_name(sampler) == name) return sampler;
  return Sampler::Scene;
}

std::vector<std::string> kernel_names() {
  std::vector<std::string> names{"auto", "scalar", "packet"};
  for (const PacketKernel& kernel : packet_kernels()) names.emplace_back(kernel.target);
  return names;
}

void set_kernel(const std::string& name, RenderOptions& options) {
  if (name == "auto") return;
  options.kernel = name == "scalar" ? Kernel::Scalar : Kernel::Packet;
  if (name != "scalar" && name != "packet") options.target = name;
  const bool has_packets =
      options.precision == Precision::Float || options.precision == Precision::Double;
  if (options.kernel == Kernel::Packet && (!has_packets || packet_kernels().empty()))
    throw Refusal(
        fmt::format("--kernel: {} has no packets; they are of float and double, on "
                    "processors with AVX2: leave out --kernel",
                    precision_name(options.precision)));
}

Effects effects_named(const std::string& list, const Scene& scene) {
  if (list == "needed") return effects_of(scene);
  if (list == "all") return all_effects();
  Effects effects;
  std::string names = "all, needed";
  for (const EffectName& effect : effect_names()) names += fmt::format(", {}", effect.name);
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto found = std::ranges::find(effect_names(), word, &EffectName::name);
    if (found == effect_names().end())
      throw Refusal(fmt::format("--effects: no effect \"{}\"; there are {}", word, names));
    effects.*found->member = true;
  }
  return effects;
}

void print_stats(const Scene& scene, const Effects& effects, const Rendering& rendering) {
  const Effects needed = effects_of(scene);
  for (const EffectName& effect : effect_names()) {
    const bool on = effects.*effect.member, called_for = needed.*effect.member;
    fmt::print("{:<14} {:<10} {}\n", effect.name, on ? "evaluated" : "left out",
               on == called_for ? ""
               : called_for     ? "(the scene calls for it)"
                                : "(not called for)");
  }
  for (const CountName& count : count_names())
    fmt::print("{:<14} {}\n", count.name, rendering.counts.*count.member);
  fmt::print("{:<14} {}\n{:<14} {:.6f}\n", "kernel", rendering.target, "seconds",
             rendering.seconds);
}

}  // namespace litmus

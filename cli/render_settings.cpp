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

template <class Values, class NameOf>
std::vector<std::string> names_of(const Values& values, NameOf name_of) {
  std::vector<std::string> names;
  for (const auto& value : values) names.emplace_back(name_of(value));
  return names;
}

/// The command line has refused other names already.
template <class Values, class NameOf>
auto value_of(const std::string& name, const Values& values, NameOf name_of) {
  const auto found = std::ranges::find(values, name, name_of);
  return found != std::end(values) ? *found : throw Refusal("no setting \"" + name + "\"");
}

}  // namespace

std::vector<std::string> precision_names() { return names_of(kPrecisions, precision_name); }
Precision precision_of(const std::string& name) {
  return value_of(name, kPrecisions, precision_name);
}

std::vector<std::string> sampler_names() { return names_of(kSamplers, sampler_name); }
Sampler sampler_of(const std::string& name) { return value_of(name, kSamplers, sampler_name); }

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

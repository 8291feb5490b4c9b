// render_settings.h: words of the command line as settings of the tracer, and its counts as lines.
#pragma once

#include <string>
#include <vector>

#include "tracer/area_sampling.h"
#include "tracer/effects.h"
#include "tracer/render.h"

namespace litmus {

std::vector<std::string> precision_names();
Precision precision_of(const std::string& name);

std::vector<std::string> sampler_names();
Sampler sampler_of(const std::string& name);

/// "auto", "scalar", "packet", and the kinds of processors that this one is.
std::vector<std::string> kernel_names();
/// Throws Refusal where packets are asked for of a precision or processor that has none.
void set_kernel(const std::string& name, RenderOptions& options);

/// "needed", "all" or a list with commas. Throws Refusal for a word that is no effect.
Effects effects_named(const std::string& list, const Scene& scene);

/// Prints what was evaluated, and how often: one line each, name and number.
void print_stats(const Scene& scene, const Effects& effects, const Rendering& rendering);

}  // namespace litmus

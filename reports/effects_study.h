// effects_study.h: what it saves to do only what a scene calls for.
#pragma once

#include <span>

#include "reports/cost.h"
#include "reports/cost_study.h"
#include "tracer/render.h"

namespace litmus {

/// Each scene with the effects that it calls for, and with every effect everywhere (effects.h), at
/// the size and as often as cost_measure.h says, in one thread. The times are those of a picture
/// alone, with making the scene ready; the pictures compared have every layer.
std::vector<EffectUse> measure_effects(std::span<const Scene> scenes, const CostOptions& options);

/// Whether two renderings hold the same bits: the whole and every layer.
bool same_bits(const Rendering& a, const Rendering& b);

/// "Doing only what a scene calls for takes ...", for all rows together.
std::string effects_sentence(const std::vector<EffectUse>& uses);

}  // namespace litmus

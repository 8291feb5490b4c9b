// html_effects.h: the section of cost.html on what scenes call for.
#pragma once

#include <string>

#include "reports/cost.h"

namespace litmus {

/// A row per scene: the share of every effect's evaluations that it needs. Empty without rows.
std::string effects_section(const CostStudy& study);

}  // namespace litmus

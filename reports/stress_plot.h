// stress_plot.h: the plots of stress.html, as SVG.
#pragma once

#include <string>

#include "stress/stress.h"

namespace litmus {

/// The errors of a row over its domain, robust and naive, with the bound. Where a result was not
/// finite the curve runs along the upper edge. The row must have a curve.
std::string stress_plot(const StressRow& row);

}  // namespace litmus

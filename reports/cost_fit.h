// cost_fit.h: orders of convergence.
#pragma once

#include <span>

#include "reports/cost.h"

namespace litmus {

/// A point of a curve that may be a power law.
struct KnobError {
  double knob, error;
};

/// The straight line through log error over log knob by least squares; its slope is the order. The
/// interval is the middle 95 % of 2000 bootstrap samples of the points (Efron 1979; a fixed
/// sequence of random numbers), those left out that have fewer than two different knobs. At least
/// three points with errors above 0 are needed, else `points` is 0.
CostFit fit_order(std::span<const KnobError> curve);

/// Fits every region and metric of a series over knobs of 4 and more and errors of at least three
/// times the truth's own.
std::vector<CostFit> fit_orders(const CostSeries& series, const CostFigures& truth_error);

}  // namespace litmus

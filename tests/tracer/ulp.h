// ulp.h: how far a result is from the truth, in units of its last place.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/value.h"

namespace litmus {

/// |ours - exact| in units of the last place of R at `exact`, subnormals included; infinite if
/// `ours` is not a number.
template <class R>
double error_in_ulp(R ours, const Quad& exact) {
  if (std::isnan(ours)) return std::numeric_limits<double>::infinity();
  int exponent = 0;
  frexp(exact, &exponent);
  exponent = std::max(exponent, std::numeric_limits<R>::min_exponent);
  const Quad ulp = ldexp(Quad(1), exponent - std::numeric_limits<R>::digits);
  return double(abs(Quad(ours) - exact) / ulp);
}

}  // namespace litmus

// self_check.cpp: NaN, subnormal numbers, and the rounding mode.
#include "tracer/self_check.h"

#include <cfenv>
#include <cmath>
#include <limits>

namespace litmus {

std::string arithmetic_fault() {
  // Volatile: the processor has to answer, not the compiler.
  volatile double zero = 0, smallest = std::numeric_limits<double>::min(), half = 0.5, one = 1,
                  tiny = 0x1p-53;
  const volatile double not_a_number = zero / zero;
  if (not_a_number == not_a_number || !std::isnan(not_a_number))
    return "NaN is not recognised: build without -ffast-math and -ffinite-math-only";
  const volatile double denormal = std::numeric_limits<double>::denorm_min();
  if (denormal * (one / tiny) == 0)
    return "numbers below 2.2e-308 are read as zero (DAZ): a library built with -ffast-math was "
           "loaded; remove it from LD_PRELOAD or rebuild it";
  const volatile double subnormal = smallest * half;
  if (subnormal == 0)
    return "numbers below 2.2e-308 are flushed to zero (FTZ): a library built with -ffast-math was "
           "loaded; remove it from LD_PRELOAD or rebuild it";
  if (std::fegetround() != FE_TONEAREST || one + tiny != 1 || -one - tiny != -1)
    return "results are not rounded to the nearest number: a library changed the rounding mode";
  return {};
}

}  // namespace litmus

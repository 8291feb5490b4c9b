// self_check.h: whether this process computes as IEEE 754 says, which all figures rest on.
#pragma once

#include <string>

namespace litmus {

/// Empty if all is well, else what is wrong and what to do: NaN must compare unequal to itself,
/// subnormal numbers must neither be flushed nor read as zero (a library built with -ffast-math may
/// switch that on when it is loaded), and results must be rounded to the nearest. Looks at the
/// calling thread.
std::string arithmetic_fault();

}  // namespace litmus

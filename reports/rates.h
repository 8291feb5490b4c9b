// rates.h: how many operations a second this processor reaches.
#pragma once

namespace litmus {

/// Operations on doubles a second, on one thread in the processor's widest vectors; 0 where that is
/// not known.
struct ArithmeticRates {
  double sums = 0, divisions = 0, roots = 0;  ///< sums: additions and multiplications in turns
};

/// Measures them, in some milliseconds of processor time. 0 but on x86 with AVX2.
ArithmeticRates arithmetic_rates();

}  // namespace litmus

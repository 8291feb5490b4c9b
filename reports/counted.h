// counted.h: a double that counts what is computed with it, as a value that the kernel's formulas
// take.
#pragma once

#include <cmath>
#include <cstdint>

#include "tracer/value.h"
#include "tracer/vector_math.h"

namespace litmus {

/// Operations of IEEE 754. Comparisons, choices, changes of sign and memory are free.
struct Operations {
  std::uint64_t sums = 0;   ///< additions, subtractions and multiplications
  std::uint64_t fused = 0;  ///< a * b + c in one rounding: where the formulas ask for it
  std::uint64_t divisions = 0, roots = 0;
};

/// A packet of one lane (packet.h) whose operations are counted in `tally`. For one thread alone.
struct Counted {
  double value = 0;

  static inline Operations tally;

  Counted() = default;
  Counted(double value) : value(value) {}

  Counted operator-() const { return -value; }
  friend Counted operator+(Counted a, Counted b) { return ++tally.sums, a.value + b.value; }
  friend Counted operator-(Counted a, Counted b) { return ++tally.sums, a.value - b.value; }
  friend Counted operator*(Counted a, Counted b) { return ++tally.sums, a.value * b.value; }
  friend Counted operator/(Counted a, Counted b) { return ++tally.divisions, a.value / b.value; }
  Counted& operator+=(Counted b) { return *this = *this + b; }

  friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
  friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
  friend bool operator<=(Counted a, Counted b) { return a.value <= b.value; }
  friend bool operator>=(Counted a, Counted b) { return a.value >= b.value; }
  friend bool operator==(Counted a, Counted b) { return a.value == b.value; }

  friend Counted sqrt(Counted a) { return ++tally.roots, std::sqrt(a.value); }
  friend Counted fabs(Counted a) { return std::fabs(a.value); }
  friend Counted fma(Counted a, Counted b, Counted c) {
    return ++tally.fused, std::fma(a.value, b.value, c.value);
  }
  friend Counted larger(Counted a, Counted b) { return a.value > b.value ? a : b; }
  friend Counted smaller(Counted a, Counted b) { return a.value < b.value ? a : b; }
  friend double largest_of(Counted a) { return a.value; }
  friend double smallest_of(Counted a) { return a.value; }
  friend std::uint64_t bits_of(Counted a) { return litmus::bits_of(a.value); }
  friend double lane(Counted a, int) { return a.value; }
  friend void set_lane(Counted& a, int, double value) { a.value = value; }
  friend void copy_interleaved(Counted x, Counted y, Counted z, double* to) {
    to[0] = x.value, to[1] = y.value, to[2] = z.value;
  }
  friend Counted widen(Counted a) { return a; }
};

template <>
struct ValueTraits<Counted> {
  using Scalar = double;
  using Mask = bool;
  using Index = int;
  using Bits = std::uint64_t;
  using Sum = Counted;
  using Abreast = double;  ///< triangles are not counted
  static constexpr int kLanes = 1;
  static Counted load(const double* scalars) { return *scalars; }
};

}  // namespace litmus

// sum.h: many lamps' light added up to the last digit.
#pragma once

#include "tracer/value.h"

namespace litmus {

/// A sum of terms of one sign, right to one unit in the last place of V for up to 4096 terms in any
/// order. A float sum is kept in double; the others carry the rounding error of every addition
/// along (Knuth 1997, vol. 2, 4.2.2, theorem B), where plain addition loses 20 units.
template <Value V>
class Total {
 public:
  void add(const V& term) {
    if constexpr (std::is_same_v<Scalar<V>, float>) {
      sum_ += widen(term);
    } else {
      const V sum = sum_ + term, part = sum - sum_;
      lost_ += (sum_ - (sum - part)) + (term - part);
      sum_ = sum;
    }
  }
  Sum<V> value() const { return sum_ + lost_; }

 private:
  Sum<V> sum_{}, lost_{};
};

}  // namespace litmus

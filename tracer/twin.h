// twin.h: two packets as one value, so that the processor works on one while it waits for the
// other.
//
// A formula is a chain of operations, each of which waits for the one before it: a processor that
// starts several in a cycle is idle for most of it. Twins are two such chains, step by step.
#pragma once

#include "tracer/packet.h"

namespace litmus {

/// The masks of two packets side by side.
template <class P>
struct TwinMask {
  using Half = Mask<P>;
  static constexpr int kHalf = kLanes<P>;
  Half low, high;

  LITMUS_INLINE TwinMask() = default;
  LITMUS_INLINE TwinMask(bool all) : low(all), high(all) {}
  LITMUS_INLINE TwinMask(const Half& low, const Half& high) : low(low), high(high) {}

  LITMUS_INLINE friend TwinMask operator&(const TwinMask& a, const TwinMask& b) {
    return {a.low & b.low, a.high & b.high};
  }
  LITMUS_INLINE friend TwinMask operator|(const TwinMask& a, const TwinMask& b) {
    return {a.low | b.low, a.high | b.high};
  }
  LITMUS_INLINE TwinMask operator!() const { return {!low, !high}; }
  LITMUS_INLINE friend bool any_of(const TwinMask& mask) { return any_of(mask.low | mask.high); }
  LITMUS_INLINE friend bool all_of(const TwinMask& mask) { return all_of(mask.low & mask.high); }
  LITMUS_INLINE friend bool none_of(const TwinMask& mask) { return none_of(mask.low | mask.high); }
  LITMUS_INLINE friend int count_of(const TwinMask& mask) {
    return count_of(mask.low) + count_of(mask.high);
  }
  LITMUS_INLINE friend bool lane(const TwinMask& mask, int i) {
    return i < kHalf ? lane(mask.low, i) : lane(mask.high, i - kHalf);
  }
  LITMUS_INLINE friend void set_lane(TwinMask& mask, int i, bool value) {
    i < kHalf ? set_lane(mask.low, i, value) : set_lane(mask.high, i - kHalf, value);
  }
  LITMUS_INLINE friend unsigned lanes_of(const TwinMask& mask) {
    return lanes_of(mask.low) | lanes_of(mask.high) << kHalf;
  }
  LITMUS_INLINE friend int first_of(const TwinMask& mask) {
    return std::countr_zero(lanes_of(mask));
  }
};

/// Two packets side by side: the lanes of `low`, then those of `high`.
template <class P>
struct Twin {
  using T = Scalar<P>;
  using Mask = TwinMask<P>;
  static constexpr int kHalf = kLanes<P>;
  P low, high;

  LITMUS_INLINE Twin() = default;
  LITMUS_INLINE Twin(T all) : low(all), high(all) {}
  LITMUS_INLINE Twin(const P& low, const P& high) : low(low), high(high) {}

  LITMUS_INLINE Twin operator-() const { return {-low, -high}; }
#define LITMUS_TWIN(RESULT, OPERATOR)                                           \
  LITMUS_INLINE friend RESULT operator OPERATOR(const Twin& a, const Twin& b) { \
    return {a.low OPERATOR b.low, a.high OPERATOR b.high};                      \
  }
  LITMUS_TWIN(Twin, +)
  LITMUS_TWIN(Twin, -)
  LITMUS_TWIN(Twin, *)
  LITMUS_TWIN(Twin, /)
  LITMUS_TWIN(Twin, &)
  LITMUS_TWIN(Twin, |)
  LITMUS_TWIN(Mask, <)
  LITMUS_TWIN(Mask, >)
  LITMUS_TWIN(Mask, <=)
  LITMUS_TWIN(Mask, >=)
  LITMUS_TWIN(Mask, ==)
#undef LITMUS_TWIN
  LITMUS_INLINE Twin& operator+=(const Twin& b) { return low += b.low, high += b.high, *this; }
  LITMUS_INLINE friend Twin operator<<(const Twin& a, int shift) {
    return {a.low << shift, a.high << shift};
  }
  LITMUS_INLINE friend Twin operator>>(const Twin& a, int shift) {
    return {a.low >> shift, a.high >> shift};
  }

  LITMUS_INLINE friend Twin select(const Mask& mask, const Twin& a, const Twin& b) {
    return {select(mask.low, a.low, b.low), select(mask.high, a.high, b.high)};
  }
  LITMUS_INLINE friend Twin larger(const Twin& a, const Twin& b) {
    return {larger(a.low, b.low), larger(a.high, b.high)};
  }
  LITMUS_INLINE friend Twin smaller(const Twin& a, const Twin& b) {
    return {smaller(a.low, b.low), smaller(a.high, b.high)};
  }
  LITMUS_INLINE friend T largest_of(const Twin& a) { return largest_of(larger(a.low, a.high)); }
  LITMUS_INLINE friend T smallest_of(const Twin& a) { return smallest_of(smaller(a.low, a.high)); }
  LITMUS_INLINE friend Twin sqrt(const Twin& a) { return {sqrt(a.low), sqrt(a.high)}; }
  LITMUS_INLINE friend Twin fabs(const Twin& a) { return {fabs(a.low), fabs(a.high)}; }
  LITMUS_INLINE friend Twin fma(const Twin& a, const Twin& b, const Twin& c) {
    return {fma(a.low, b.low, c.low), fma(a.high, b.high, c.high)};
  }
  LITMUS_INLINE static Twin from_bits(const Twin<Bits<P>>& bits) {
    return {P::from_bits(bits.low), P::from_bits(bits.high)};
  }
  LITMUS_INLINE friend T lane(const Twin& a, int i) {
    return i < kHalf ? lane(a.low, i) : lane(a.high, i - kHalf);
  }
  LITMUS_INLINE friend void set_lane(Twin& a, int i, T value) {
    i < kHalf ? set_lane(a.low, i, value) : set_lane(a.high, i - kHalf, value);
  }
  LITMUS_INLINE friend void copy_interleaved(const Twin& x, const Twin& y, const Twin& z, T* to) {
    copy_interleaved(x.low, y.low, z.low, to);
    copy_interleaved(x.high, y.high, z.high, to + 3 * kHalf);
  }
};

template <class P>
LITMUS_INLINE inline Twin<Sum<P>> widen(const Twin<P>& a) {
  return {widen(a.low), widen(a.high)};
}
template <class P>
LITMUS_INLINE inline Twin<Bits<P>> bits_of(const Twin<P>& a) {
  return {bits_of(a.low), bits_of(a.high)};
}

template <class P>
struct ValueTraits<Twin<P>> {
  using Scalar = litmus::Scalar<P>;
  using Mask = TwinMask<P>;
  using Index = Twin<litmus::Index<P>>;
  using Bits = Twin<litmus::Bits<P>>;
  using Sum = Twin<litmus::Sum<P>>;
  using Abreast = litmus::Abreast<P>;
  static constexpr int kLanes = 2 * litmus::kLanes<P>;
  LITMUS_INLINE static Twin<P> load(const Scalar* scalars) {
    return {ValueTraits<P>::load(scalars), ValueTraits<P>::load(scalars + litmus::kLanes<P>)};
  }
};

}  // namespace litmus

// packet.h: several floats or doubles side by side, as a value that the kernel's formulas take.
//
// A thin cover of std::experimental::simd: it lives in this namespace, so that the formulas find
// its functions, and it has the few operations that they use. Every operation is one of IEEE 754,
// lane by lane, so a lane holds the bits that the same scalar operation gives.
#pragma once

#include <bit>
#include <experimental/simd>

#include "tracer/value.h"

namespace litmus {

/// An operation on packets is one instruction; a call would cost ten.
#define LITMUS_INLINE [[gnu::always_inline]]

namespace stdx = std::experimental;

/// The type of the processor's vectors, or several of them, with N lanes of T.
template <class T, int N>
using Simd = stdx::simd<T, stdx::simd_abi::deduce_t<T, std::size_t(N)>>;

template <class T, int N>
struct PacketMask {
  using Lanes = typename Simd<T, N>::mask_type;
  Lanes lanes;

  LITMUS_INLINE PacketMask() : lanes(false) {}
  LITMUS_INLINE PacketMask(bool all) : lanes(all) {}
  LITMUS_INLINE PacketMask(const Lanes& lanes) : lanes(lanes) {}

  LITMUS_INLINE friend PacketMask operator&(const PacketMask& a, const PacketMask& b) {
    return a.lanes && b.lanes;
  }
  LITMUS_INLINE friend PacketMask operator|(const PacketMask& a, const PacketMask& b) {
    return a.lanes || b.lanes;
  }
  LITMUS_INLINE PacketMask operator!() const { return !lanes; }
  LITMUS_INLINE friend bool any_of(const PacketMask& mask) { return stdx::any_of(mask.lanes); }
  LITMUS_INLINE friend bool all_of(const PacketMask& mask) { return stdx::all_of(mask.lanes); }
  LITMUS_INLINE friend bool none_of(const PacketMask& mask) { return stdx::none_of(mask.lanes); }
  LITMUS_INLINE friend int count_of(const PacketMask& mask) { return stdx::popcount(mask.lanes); }
  LITMUS_INLINE friend bool lane(const PacketMask& mask, int i) {
    return mask.lanes[std::size_t(i)];
  }
  LITMUS_INLINE friend void set_lane(PacketMask& mask, int i, bool value) {
    mask.lanes[std::size_t(i)] = value;
  }
  /// The first lane that is set; there is one.
  LITMUS_INLINE friend int first_of(const PacketMask& mask) {
    return stdx::find_first_set(mask.lanes);
  }
};

template <class T, int N>
struct Packet {
  using Mask = PacketMask<T, N>;
  using Unsigned = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  Simd<T, N> lanes;

  LITMUS_INLINE Packet() : lanes(T(0)) {}
  LITMUS_INLINE Packet(T all) : lanes(all) {}
  LITMUS_INLINE Packet(const Simd<T, N>& lanes) : lanes(lanes) {}

  LITMUS_INLINE Packet operator-() const { return -lanes; }
  LITMUS_INLINE friend Packet operator+(const Packet& a, const Packet& b) {
    return a.lanes + b.lanes;
  }
  LITMUS_INLINE friend Packet operator-(const Packet& a, const Packet& b) {
    return a.lanes - b.lanes;
  }
  LITMUS_INLINE friend Packet operator*(const Packet& a, const Packet& b) {
    return a.lanes * b.lanes;
  }
  LITMUS_INLINE friend Packet operator/(const Packet& a, const Packet& b) {
    return a.lanes / b.lanes;
  }
  LITMUS_INLINE Packet& operator+=(const Packet& b) { return lanes += b.lanes, *this; }

  LITMUS_INLINE friend Mask operator<(const Packet& a, const Packet& b) {
    return a.lanes < b.lanes;
  }
  LITMUS_INLINE friend Mask operator>(const Packet& a, const Packet& b) {
    return a.lanes > b.lanes;
  }
  LITMUS_INLINE friend Mask operator<=(const Packet& a, const Packet& b) {
    return a.lanes <= b.lanes;
  }
  LITMUS_INLINE friend Mask operator>=(const Packet& a, const Packet& b) {
    return a.lanes >= b.lanes;
  }
  LITMUS_INLINE friend Mask operator==(const Packet& a, const Packet& b) {
    return a.lanes == b.lanes;
  }
  LITMUS_INLINE friend Mask operator!=(const Packet& a, const Packet& b) {
    return a.lanes != b.lanes;
  }

  LITMUS_INLINE friend Packet operator&(const Packet& a, const Packet& b) {
    return a.lanes & b.lanes;
  }
  LITMUS_INLINE friend Packet operator|(const Packet& a, const Packet& b) {
    return a.lanes | b.lanes;
  }
  LITMUS_INLINE friend Packet operator<<(const Packet& a, int shift) { return a.lanes << shift; }
  LITMUS_INLINE friend Packet operator>>(const Packet& a, int shift) { return a.lanes >> shift; }

  LITMUS_INLINE friend Packet select(const Mask& mask, const Packet& a, const Packet& b) {
    Simd<T, N> result = b.lanes;
    stdx::where(mask.lanes, result) = a.lanes;
    return result;
  }
  LITMUS_INLINE friend Packet sqrt(const Packet& a) { return stdx::sqrt(a.lanes); }
  LITMUS_INLINE friend Packet fabs(const Packet& a) { return stdx::fabs(a.lanes); }
  LITMUS_INLINE friend Packet fma(const Packet& a, const Packet& b, const Packet& c) {
    return stdx::fma(a.lanes, b.lanes, c.lanes);
  }
  LITMUS_INLINE friend T lane(const Packet& a, int i) { return a.lanes[std::size_t(i)]; }
  LITMUS_INLINE friend void set_lane(Packet& a, int i, T value) { a.lanes[std::size_t(i)] = value; }
  LITMUS_INLINE friend void copy_lanes(const Packet& a, T* to) {
    a.lanes.copy_to(to, stdx::element_aligned);
  }
  /// A float's lanes as doubles, a double's as they are.
  LITMUS_INLINE friend Packet<double, N> widen(const Packet& a) {
    if constexpr (std::is_same_v<T, double>) {
      return a;
    } else {
      return stdx::static_simd_cast<Simd<double, N>>(a.lanes);
    }
  }

  LITMUS_INLINE friend Packet<Unsigned, N> bits_of(const Packet& a) {
    return std::bit_cast<Simd<Unsigned, N>>(a.lanes);
  }
  LITMUS_INLINE static Packet from_bits(const Packet<Unsigned, N>& bits) {
    return std::bit_cast<Simd<T, N>>(bits.lanes);
  }
};

template <class T, int N>
struct ValueTraits<Packet<T, N>> {
  using Scalar = T;
  using Mask = PacketMask<T, N>;
  using Index = Packet<T, N>;  ///< exact up to 2^24 in float
  using Bits = Packet<typename Packet<T, N>::Unsigned, N>;
  using Sum = Packet<double, N>;
  static constexpr int kLanes = N;
};

/// As many lanes as a vector of the processor has that this file is compiled for.
template <class T>
using NativePacket = Packet<T, int(stdx::native_simd<T>::size())>;

}  // namespace litmus

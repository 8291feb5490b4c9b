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

namespace stdx = std::experimental;

/// The type of the processor's vectors, or several of them, with N lanes of T.
template <class T, int N>
using Simd = stdx::simd<T, stdx::simd_abi::deduce_t<T, std::size_t(N)>>;

template <class T, int N>
struct PacketMask {
  using Lanes = typename Simd<T, N>::mask_type;
  Lanes lanes;

  PacketMask() : lanes(false) {}
  PacketMask(bool all) : lanes(all) {}
  PacketMask(const Lanes& lanes) : lanes(lanes) {}

  friend PacketMask operator&(const PacketMask& a, const PacketMask& b) {
    return a.lanes && b.lanes;
  }
  friend PacketMask operator|(const PacketMask& a, const PacketMask& b) {
    return a.lanes || b.lanes;
  }
  PacketMask operator!() const { return !lanes; }
  friend bool any_of(const PacketMask& mask) { return stdx::any_of(mask.lanes); }
  friend bool all_of(const PacketMask& mask) { return stdx::all_of(mask.lanes); }
  friend bool none_of(const PacketMask& mask) { return stdx::none_of(mask.lanes); }
  friend int count_of(const PacketMask& mask) { return stdx::popcount(mask.lanes); }
  friend bool lane(const PacketMask& mask, int i) { return mask.lanes[std::size_t(i)]; }
  friend void set_lane(PacketMask& mask, int i, bool value) { mask.lanes[std::size_t(i)] = value; }
  /// The first lane that is set; there is one.
  friend int first_of(const PacketMask& mask) { return stdx::find_first_set(mask.lanes); }
};

template <class T, int N>
struct Packet {
  using Mask = PacketMask<T, N>;
  using Unsigned = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  Simd<T, N> lanes;

  Packet() : lanes(T(0)) {}
  Packet(T all) : lanes(all) {}
  Packet(const Simd<T, N>& lanes) : lanes(lanes) {}

  Packet operator-() const { return -lanes; }
  friend Packet operator+(const Packet& a, const Packet& b) { return a.lanes + b.lanes; }
  friend Packet operator-(const Packet& a, const Packet& b) { return a.lanes - b.lanes; }
  friend Packet operator*(const Packet& a, const Packet& b) { return a.lanes * b.lanes; }
  friend Packet operator/(const Packet& a, const Packet& b) { return a.lanes / b.lanes; }
  Packet& operator+=(const Packet& b) { return lanes += b.lanes, *this; }

  friend Mask operator<(const Packet& a, const Packet& b) { return a.lanes < b.lanes; }
  friend Mask operator>(const Packet& a, const Packet& b) { return a.lanes > b.lanes; }
  friend Mask operator<=(const Packet& a, const Packet& b) { return a.lanes <= b.lanes; }
  friend Mask operator>=(const Packet& a, const Packet& b) { return a.lanes >= b.lanes; }
  friend Mask operator==(const Packet& a, const Packet& b) { return a.lanes == b.lanes; }
  friend Mask operator!=(const Packet& a, const Packet& b) { return a.lanes != b.lanes; }

  friend Packet operator&(const Packet& a, const Packet& b) { return a.lanes & b.lanes; }
  friend Packet operator|(const Packet& a, const Packet& b) { return a.lanes | b.lanes; }
  friend Packet operator<<(const Packet& a, int shift) { return a.lanes << shift; }
  friend Packet operator>>(const Packet& a, int shift) { return a.lanes >> shift; }

  friend Packet select(const Mask& mask, const Packet& a, const Packet& b) {
    Simd<T, N> result = b.lanes;
    stdx::where(mask.lanes, result) = a.lanes;
    return result;
  }
  friend Packet sqrt(const Packet& a) { return stdx::sqrt(a.lanes); }
  friend Packet fabs(const Packet& a) { return stdx::fabs(a.lanes); }
  friend Packet fma(const Packet& a, const Packet& b, const Packet& c) {
    return stdx::fma(a.lanes, b.lanes, c.lanes);
  }
  friend T lane(const Packet& a, int i) { return a.lanes[std::size_t(i)]; }
  friend void set_lane(Packet& a, int i, T value) { a.lanes[std::size_t(i)] = value; }
  /// A float's lanes as doubles, a double's as they are.
  friend Packet<double, N> widen(const Packet& a) {
    if constexpr (std::is_same_v<T, double>) {
      return a;
    } else {
      return stdx::static_simd_cast<Simd<double, N>>(a.lanes);
    }
  }

  friend Packet<Unsigned, N> bits_of(const Packet& a) {
    return std::bit_cast<Simd<Unsigned, N>>(a.lanes);
  }
  static Packet from_bits(const Packet<Unsigned, N>& bits) {
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

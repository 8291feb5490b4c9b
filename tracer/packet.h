// packet.h: several floats or doubles side by side, as a value that the kernel's formulas take.
//
// A thin cover of std::experimental::simd: it lives in this namespace, so that the formulas find
// its functions, and it has the few operations that they use. Every operation is one of IEEE 754,
// lane by lane, so a lane holds the bits that the same scalar operation gives.
#pragma once

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include <array>
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
  LITMUS_INLINE friend unsigned lanes_of(const PacketMask& mask) {
#ifdef __AVX2__
    if constexpr (sizeof(Lanes) == 32 && sizeof(T) == 8) {
      return unsigned(_mm256_movemask_pd(std::bit_cast<__m256d>(mask.lanes)));
    }
    if constexpr (sizeof(Lanes) == 32 && sizeof(T) == 4) {
      return unsigned(_mm256_movemask_ps(std::bit_cast<__m256>(mask.lanes)));
    }
#endif
    unsigned bits = 0;
    for (int i = 0; i < N; ++i) bits |= unsigned(lane(mask, i)) << i;
    return bits;
  }
};

#ifdef __AVX512DQ__
/// Whether the lanes fill a vector of AVX-512, whose masks are a bit a lane.
template <class T, int N>
concept FillsVector = std::is_floating_point_v<T> && N * sizeof(T) == 64;

/// The same as bits: one instruction where g++ 12 makes several of the library's masks.
template <class T, int N>
requires FillsVector<T, N>
struct PacketMask<T, N> {
  using Bits = std::conditional_t<N == 8, __mmask8, __mmask16>;
  Bits bits;

  LITMUS_INLINE PacketMask() : bits(0) {}
  LITMUS_INLINE PacketMask(bool all) : bits(all ? Bits(-1) : Bits(0)) {}
  LITMUS_INLINE static PacketMask of(Bits bits) {
    PacketMask mask;
    mask.bits = bits;
    return mask;
  }

  LITMUS_INLINE friend PacketMask operator&(const PacketMask& a, const PacketMask& b) {
    if constexpr (N == 8) return of(_kand_mask8(a.bits, b.bits));
    if constexpr (N == 16) return of(_kand_mask16(a.bits, b.bits));
  }
  LITMUS_INLINE friend PacketMask operator|(const PacketMask& a, const PacketMask& b) {
    if constexpr (N == 8) return of(_kor_mask8(a.bits, b.bits));
    if constexpr (N == 16) return of(_kor_mask16(a.bits, b.bits));
  }
  LITMUS_INLINE PacketMask operator!() const {
    if constexpr (N == 8) return of(_knot_mask8(bits));
    if constexpr (N == 16) return of(_knot_mask16(bits));
  }
  LITMUS_INLINE friend bool any_of(const PacketMask& mask) { return !none_of(mask); }
  LITMUS_INLINE friend bool all_of(const PacketMask& mask) {
    if constexpr (N == 8) return _kortestc_mask8_u8(mask.bits, mask.bits);
    if constexpr (N == 16) return _kortestc_mask16_u8(mask.bits, mask.bits);
  }
  LITMUS_INLINE friend bool none_of(const PacketMask& mask) {
    if constexpr (N == 8) return _kortestz_mask8_u8(mask.bits, mask.bits);
    if constexpr (N == 16) return _kortestz_mask16_u8(mask.bits, mask.bits);
  }
  LITMUS_INLINE friend int count_of(const PacketMask& mask) {
    return std::popcount(unsigned(mask.bits));
  }
  LITMUS_INLINE friend bool lane(const PacketMask& mask, int i) { return mask.bits >> i & 1; }
  LITMUS_INLINE friend void set_lane(PacketMask& mask, int i, bool value) {
    mask.bits = Bits((mask.bits & ~(1u << i)) | unsigned(value) << i);
  }
  LITMUS_INLINE friend int first_of(const PacketMask& mask) {
    return std::countr_zero(unsigned(mask.bits));
  }
  LITMUS_INLINE friend unsigned lanes_of(const PacketMask& mask) { return mask.bits; }
};
#endif

/// A comparison of IEEE 754, false where a number is none (NotEqual: true).
enum class Comparison { Less, LessOrEqual, Equal, NotEqual };

template <Comparison kWhich, class T, int N>
LITMUS_INLINE inline PacketMask<T, N> compare(const Simd<T, N>& a, const Simd<T, N>& b) {
#ifdef __AVX512DQ__
  if constexpr (FillsVector<T, N>) {
    constexpr int kPredicate = kWhich == Comparison::Less          ? _CMP_LT_OQ
                               : kWhich == Comparison::LessOrEqual ? _CMP_LE_OQ
                               : kWhich == Comparison::Equal       ? _CMP_EQ_OQ
                                                                   : _CMP_NEQ_UQ;
    if constexpr (N == 8) {
      return PacketMask<T, N>::of(
          _mm512_cmp_pd_mask(std::bit_cast<__m512d>(a), std::bit_cast<__m512d>(b), kPredicate));
    } else {
      return PacketMask<T, N>::of(
          _mm512_cmp_ps_mask(std::bit_cast<__m512>(a), std::bit_cast<__m512>(b), kPredicate));
    }
  } else
#endif
  {
    if constexpr (kWhich == Comparison::Less) return a < b;
    if constexpr (kWhich == Comparison::LessOrEqual) return a <= b;
    if constexpr (kWhich == Comparison::Equal) return a == b;
    if constexpr (kWhich == Comparison::NotEqual) return a != b;
  }
}

/// a where the mask is set, else b.
template <class T, int N>
LITMUS_INLINE inline Simd<T, N> blend(const PacketMask<T, N>& mask, const Simd<T, N>& a,
                                      const Simd<T, N>& b) {
#ifdef __AVX512DQ__
  if constexpr (FillsVector<T, N>) {
    if constexpr (N == 8) {
      return std::bit_cast<Simd<T, N>>(
          _mm512_mask_blend_pd(mask.bits, std::bit_cast<__m512d>(b), std::bit_cast<__m512d>(a)));
    } else {
      return std::bit_cast<Simd<T, N>>(
          _mm512_mask_blend_ps(mask.bits, std::bit_cast<__m512>(b), std::bit_cast<__m512>(a)));
    }
  } else
#endif
  {
    Simd<T, N> result = b;
    stdx::where(mask.lanes, result) = a;
    return result;
  }
}

/// The larger (or the smaller) of two; b where one of them is not a number: one instruction.
template <bool kLarger, class T, int N>
LITMUS_INLINE inline Simd<T, N> extreme(const Simd<T, N>& a, const Simd<T, N>& b) {
  [[maybe_unused]] constexpr std::size_t kBytes = N * sizeof(T);
#ifdef __AVX512DQ__
  if constexpr (kBytes == 64 && sizeof(T) == 8) {
    const auto x = std::bit_cast<__m512d>(a), y = std::bit_cast<__m512d>(b);
    return std::bit_cast<Simd<T, N>>(kLarger ? _mm512_max_pd(x, y) : _mm512_min_pd(x, y));
  } else
#endif
#ifdef __AVX2__
      if constexpr (kBytes == 32 && sizeof(T) == 8) {
    const auto x = std::bit_cast<__m256d>(a), y = std::bit_cast<__m256d>(b);
    return std::bit_cast<Simd<T, N>>(kLarger ? _mm256_max_pd(x, y) : _mm256_min_pd(x, y));
  } else if constexpr (kBytes == 32) {
    const auto x = std::bit_cast<__m256>(a), y = std::bit_cast<__m256>(b);
    return std::bit_cast<Simd<T, N>>(kLarger ? _mm256_max_ps(x, y) : _mm256_min_ps(x, y));
  } else
#endif
    return kLarger ? blend<T, N>(compare<Comparison::Less, T, N>(b, a), a, b)
                   : blend<T, N>(compare<Comparison::Less, T, N>(a, b), a, b);
}

/// a * b + c, rounded once. The library takes it lane by lane.
template <class T, int N>
LITMUS_INLINE inline Simd<T, N> multiply_add(const Simd<T, N>& a, const Simd<T, N>& b,
                                             const Simd<T, N>& c) {
#ifdef __AVX512DQ__
  if constexpr (N * sizeof(T) == 64 && sizeof(T) == 8) {
    return std::bit_cast<Simd<T, N>>(_mm512_fmadd_pd(
        std::bit_cast<__m512d>(a), std::bit_cast<__m512d>(b), std::bit_cast<__m512d>(c)));
  } else if constexpr (N * sizeof(T) == 64) {
    return std::bit_cast<Simd<T, N>>(_mm512_fmadd_ps(
        std::bit_cast<__m512>(a), std::bit_cast<__m512>(b), std::bit_cast<__m512>(c)));
  } else
#endif
#ifdef __AVX2__
      if constexpr (N * sizeof(T) == 32 && sizeof(T) == 8) {
    return std::bit_cast<Simd<T, N>>(_mm256_fmadd_pd(
        std::bit_cast<__m256d>(a), std::bit_cast<__m256d>(b), std::bit_cast<__m256d>(c)));
  } else if constexpr (N * sizeof(T) == 32) {
    return std::bit_cast<Simd<T, N>>(_mm256_fmadd_ps(
        std::bit_cast<__m256>(a), std::bit_cast<__m256>(b), std::bit_cast<__m256>(c)));
  } else
#endif
    return stdx::fma(a, b, c);
}

/// Writes x, y and z lane by lane: x0 y0 z0 x1 ...
template <class T, int N>
LITMUS_INLINE inline void interleave(const Simd<T, N>& x, const Simd<T, N>& y, const Simd<T, N>& z,
                                     T* to) {
#ifdef __AVX512DQ__
  if constexpr (FillsVector<T, N> && N == 8) {
    const auto a = std::bit_cast<__m512d>(x), b = std::bit_cast<__m512d>(y);
    const auto c = std::bit_cast<__m512d>(z);
    // 8 + i takes lane i of the second operand.
    const auto take = [](const __m512d& one, const __m512d& other, auto... lanes) {
      const std::array<long long, 8> which{lanes...};
      return _mm512_permutex2var_pd(one, std::bit_cast<__m512i>(which), other);
    };
    const __m512d low = take(take(a, b, 0, 8, 0, 1, 9, 0, 2, 10), c, 0, 1, 8, 3, 4, 9, 6, 7);
    const __m512d middle = take(take(a, b, 0, 3, 11, 0, 4, 12, 0, 5), c, 10, 1, 2, 11, 4, 5, 12, 7);
    const __m512d high = take(take(a, b, 13, 0, 6, 14, 0, 7, 15, 0), c, 0, 13, 2, 3, 14, 5, 6, 15);
    _mm512_storeu_pd(to, low), _mm512_storeu_pd(to + 8, middle), _mm512_storeu_pd(to + 16, high);
    return;
  }
#endif
  for (int i = 0; i < N; ++i) {
    const auto lane = std::size_t(i);
    to[3 * lane] = x[lane], to[3 * lane + 1] = y[lane], to[3 * lane + 2] = z[lane];
  }
}

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
    return compare<Comparison::Less, T, N>(a.lanes, b.lanes);
  }
  LITMUS_INLINE friend Mask operator>(const Packet& a, const Packet& b) {
    return compare<Comparison::Less, T, N>(b.lanes, a.lanes);
  }
  LITMUS_INLINE friend Mask operator<=(const Packet& a, const Packet& b) {
    return compare<Comparison::LessOrEqual, T, N>(a.lanes, b.lanes);
  }
  LITMUS_INLINE friend Mask operator>=(const Packet& a, const Packet& b) {
    return compare<Comparison::LessOrEqual, T, N>(b.lanes, a.lanes);
  }
  LITMUS_INLINE friend Mask operator==(const Packet& a, const Packet& b) {
    return compare<Comparison::Equal, T, N>(a.lanes, b.lanes);
  }
  LITMUS_INLINE friend Mask operator!=(const Packet& a, const Packet& b) {
    return compare<Comparison::NotEqual, T, N>(a.lanes, b.lanes);
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
    return blend<T, N>(mask, a.lanes, b.lanes);
  }
  LITMUS_INLINE friend Packet larger(const Packet& a, const Packet& b) {
    return extreme<true, T, N>(a.lanes, b.lanes);
  }
  LITMUS_INLINE friend Packet smaller(const Packet& a, const Packet& b) {
    return extreme<false, T, N>(a.lanes, b.lanes);
  }
  LITMUS_INLINE friend T largest_of(const Packet& a) { return stdx::hmax(a.lanes); }
  LITMUS_INLINE friend T smallest_of(const Packet& a) { return stdx::hmin(a.lanes); }
  LITMUS_INLINE friend Packet sqrt(const Packet& a) { return stdx::sqrt(a.lanes); }
  LITMUS_INLINE friend Packet fabs(const Packet& a) {
    return from_bits(bits_of(a) & Packet<Unsigned, N>(~(Unsigned(1) << (8 * sizeof(T) - 1))));
  }
  LITMUS_INLINE friend Packet fma(const Packet& a, const Packet& b, const Packet& c) {
    return multiply_add<T, N>(a.lanes, b.lanes, c.lanes);
  }
  LITMUS_INLINE friend T lane(const Packet& a, int i) { return a.lanes[std::size_t(i)]; }
  LITMUS_INLINE friend void set_lane(Packet& a, int i, T value) { a.lanes[std::size_t(i)] = value; }
  LITMUS_INLINE friend void copy_lanes(const Packet& a, T* to) {
    a.lanes.copy_to(to, stdx::element_aligned);
  }
  LITMUS_INLINE friend void copy_interleaved(const Packet& x, const Packet& y, const Packet& z,
                                             T* to) {
    interleave<T, N>(x.lanes, y.lanes, z.lanes, to);
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
  using Abreast = Packet<T, (N < 8 ? N : 8)>;
  static constexpr int kLanes = N;
  LITMUS_INLINE static Packet<T, N> load(const T* scalars) {
    return Simd<T, N>(scalars, stdx::element_aligned);
  }
};

/// As many lanes as a vector of the processor has that this file is compiled for.
template <class T>
using NativePacket = Packet<T, int(stdx::native_simd<T>::size())>;

}  // namespace litmus

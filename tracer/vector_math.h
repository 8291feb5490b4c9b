// vector_math.h: exp, expm1, log, log1p and atan2 for every Value, without branches.
//
// Scalars and packets of float and double go through the same operations, so they get the same
// bits; long double and Quad go to their own library. Each function reduces its argument as usual
// (Muller, Elementary Functions, 2016, chapters 5 and 11) and ends in a polynomial: Chebyshev
// interpolation in 50 digits, whose error is below 0.1 ulp. The bounds are tested against Quad.
#pragma once

#include <numbers>

#include "tracer/value.h"

namespace litmus {

/// The constants of float and double.
template <Real R>
struct MathConstants;

template <>
struct MathConstants<double> {
  static constexpr int kMantissa = 52, kBias = 1023;
  static constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;
  static constexpr double kExpLeast = -746, kExpMost = 710, kExpm1Least = -60;
  /// atan(1/2), pi/4, pi/2 and pi: rounded, and the rest.
  static constexpr double kAtanHalf[] = {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56};
  static constexpr double kQuarterPi[] = {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
  static constexpr double kHalfPi[] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
  static constexpr double kPi[] = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
  /// (2 artanh(s)/s - 2)/z, z = s^2.
  static constexpr double kLog[] = {
      0x1.5555555555558p-1, 0x1.99999999952d7p-2, 0x1.2492492df281ap-2, 0x1.c71c62e3f11e6p-3,
      0x1.7462b51cb66b1p-3, 0x1.39fe51a7c18f9p-3, 0x1.2b5900de53b32p-3};
  /// (exp(r) - 1 - r)/r^2.
  static constexpr double kExp[] = {
      0x1.0000000000000p-1,  0x1.5555555555557p-3,  0x1.5555555555556p-5,  0x1.11111111100bep-7,
      0x1.6c16c16c162c3p-10, 0x1.a01a01abf85abp-13, 0x1.a01a01a6e1e2ap-16, 0x1.71de01fdbf9cap-19,
      0x1.27e4db46cddd1p-22, 0x1.af4e554377204p-26, 0x1.1f7340dbc337ep-29};
  /// (atan(t)/t - 1)/z, z = t^2.
  static constexpr double kAtan[] = {
      -0x1.5555555555554p-2, 0x1.999999999885fp-3, -0x1.24924923b06cdp-3, 0x1.c71c7136517a9p-4,
      -0x1.745cff6136307p-4, 0x1.3b116171b0dd7p-4, -0x1.10ed1cedbec09p-4, 0x1.df0b70d0fde14p-5,
      -0x1.9c6054173be88p-5, 0x1.35da608772867p-5, -0x1.1f782b80bfd1ep-6};
};

template <>
struct MathConstants<float> {
  static constexpr int kMantissa = 23, kBias = 127;
  static constexpr float kLn2High = 0x1.62p-1f, kLn2Low = 0x1.c85fdf473de6bp-10f;
  static constexpr float kExpLeast = -104, kExpMost = 89, kExpm1Least = -30;
  static constexpr float kAtanHalf[] = {0x1.dac67p-2f, 0x1.586ed4p-28f};
  static constexpr float kQuarterPi[] = {0x1.921fb6p-1f, -0x1.777a5cp-26f};
  static constexpr float kHalfPi[] = {0x1.921fb6p+0f, -0x1.777a5cp-25f};
  static constexpr float kPi[] = {0x1.921fb6p+1f, -0x1.777a5cp-24f};
  static constexpr float kLog[] = {0x1.55555b800896ap-1f, 0x1.997c2ed527c68p-2f,
                                   0x1.2ee6559160a97p-2f};
  static constexpr float kExp[] = {0x1.0000000000000p-1f, 0x1.5554dc8961859p-3f,
                                   0x1.555518f5d1200p-5f, 0x1.120be1dcb42dcp-7f,
                                   0x1.6d117cc039048p-10f};
  static constexpr float kAtan[] = {-0x1.55555393e4c33p-2f, 0x1.999601722a51cp-3f,
                                    -0x1.23f978a594947p-3f, 0x1.b4f9582a5beb5p-4f,
                                    -0x1.fd2e59f69a429p-5f};
};

/// c[0] + c[1] x + ..., by Horner's rule.
template <Value V, class R, std::size_t N>
V polynomial(const V& x, const R (&c)[N]) {
  V sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + V(c[i]);
  return sum;
}

/// c[0] + ... + c[N - 1] x^(N - 1), where powers[k] is x^(2^k).
template <std::size_t N, Value V, class R>
V sum_by_halves(const V* powers, const R* c) {
  if constexpr (N == 1) {
    return V(c[0]);
  } else {
    constexpr int kLevel = std::bit_width(N - 1) - 1;
    constexpr std::size_t kLow = std::size_t(1) << kLevel;
    return sum_by_halves<kLow>(powers, c) +
           sum_by_halves<N - kLow>(powers, c + kLow) * powers[kLevel];
  }
}

/// The same polynomial by Estrin's scheme, whose halves do not wait for each other as the steps of
/// Horner's rule do; a little less exact.
template <Value V, class R, std::size_t N>
V polynomial_by_halves(const V& x, const R (&c)[N]) {
  V powers[std::bit_width(N - 1)] = {x};
  for (std::size_t k = 1; k < std::bit_width(N - 1); ++k) powers[k] = powers[k - 1] * powers[k - 1];
  return sum_by_halves<N>(powers, c);
}

// ---- Exponentials ----------------------------------------------------------------------------

/// 2^n of a whole number n for which that is a normal number.
template <Value V>
V power_of_two(const V& n) {
  using C = MathConstants<Scalar<V>>;
  // The sum's last bits are n in two's complement.
  constexpr Scalar<V> kShift = Scalar<V>(3) * two_to<Scalar<V>>(C::kMantissa - 1);
  return from_bits<V>((bits_of(V(n + kShift)) + Bits<V>(Scalar<Bits<V>>(C::kBias)))
                      << C::kMantissa);
}

/// x = n ln 2 + r with |r| <= ln(2)/2 and (exp(r) - 1).
template <Value V>
struct ReducedExponent {
  V n, expm1;
};

template <Value V>
ReducedExponent<V> reduce_exponent(const V& x) {
  using R = Scalar<V>;
  using C = MathConstants<R>;
  constexpr R kShift = R(3) * two_to<R>(C::kMantissa - 1);
  const V n = (x * std::numbers::log2e_v<R> + kShift) - kShift;
  const V high = x - n * C::kLn2High, low = n * C::kLn2Low;
  const V r = high - low;
  const V lost = (high - r) - low;
  return {n, r + (r * r * polynomial_by_halves(r, C::kExp) + lost)};
}

/// exp(x) to 1 ulp where it is a normal number; 0 and infinity past the ends.
template <Value V>
V exp_of(const V& x) {
  if constexpr (!kOwnMath<Scalar<V>>) {
    using std::exp;
    return exp(x);
  } else {
    using R = Scalar<V>;
    using C = MathConstants<R>;
    const V low = select(x < C::kExpLeast, V(C::kExpLeast), x);
    const ReducedExponent<V> e = reduce_exponent(select(low > C::kExpMost, V(C::kExpMost), low));
    // 2^n in two steps: n may lie outside of the normal exponents.
    constexpr R kShift = R(3) * two_to<R>(C::kMantissa - 1);
    const V half = (e.n * R(0.5) + kShift) - kShift;
    return (R(1) + e.expm1) * power_of_two(half) * power_of_two(V(e.n - half));
  }
}

/// exp(x) - 1 for x <= 0, to 1.2 ulp.
template <Value V>
V expm1_of(const V& x) {
  if constexpr (!kOwnMath<Scalar<V>>) {
    using std::expm1;
    return expm1(x);
  } else {
    using R = Scalar<V>;
    const R least = MathConstants<R>::kExpm1Least;
    const ReducedExponent<V> e = reduce_exponent(select(x < least, V(least), x));
    const V power = power_of_two(e.n);
    return power * e.expm1 + (power - R(1));
  }
}

// ---- Sums of two numbers ---------------------------------------------------------------------

/// A number as the nearest value and what that leaves out.
template <Value V>
struct Rounded {
  V value, rest;
};

/// a + b without error (Knuth).
template <Value V>
Rounded<V> exact_sum(const V& a, const V& b) {
  const V sum = a + b, more = sum - a;
  return {sum, (a - (sum - more)) + (b - more)};
}

/// The dot product as if in twice the digits (Ogita, Rump and Oishi 2005).
template <Value V>
Rounded<V> compensated_dot(const Vec<V>& a, const Vec<V>& b) {
  if constexpr (std::is_same_v<V, Quad>) {
    return {dot(a, b), V(0)};
  } else {
    using std::fma;
    const V x = a.x * b.x, y = a.y * b.y, z = a.z * b.z;
    const Rounded<V> two = exact_sum(x, y), three = exact_sum(two.value, z);
    const V rest = (fma(a.x, b.x, -x) + fma(a.y, b.y, -y)) + (fma(a.z, b.z, -z) + two.rest);
    return exact_sum(three.value, V(rest + three.rest));
  }
}

// ---- Logarithms ------------------------------------------------------------------------------

/// x = 2^exponent * m with m from sqrt(1/2) to sqrt(2), for a normal x.
template <Value V>
struct SplitNumber {
  V exponent, m;
};

template <Value V>
SplitNumber<V> split_number(const V& x) {
  using R = Scalar<V>;
  using C = MathConstants<R>;
  using B = Scalar<Bits<V>>;
  constexpr B kOne = B(C::kBias) << C::kMantissa, kMantissaBits = (B(1) << C::kMantissa) - 1;
  constexpr B kRootHalf = std::bit_cast<B>(std::numbers::sqrt2_v<R> / 2);
  constexpr R kShift = two_to<R>(C::kMantissa);
  const Bits<V> moved = bits_of(x) + Bits<V>(kOne - kRootHalf);
  const Bits<V> exponent = (moved >> C::kMantissa) | Bits<V>(std::bit_cast<B>(kShift));
  const Bits<V> mantissa = (moved & Bits<V>(kMantissaBits)) + Bits<V>(kRootHalf);
  return {from_bits<V>(exponent) - (kShift + R(C::kBias)), from_bits<V>(mantissa)};
}

/// exponent ln 2 + log(1 + f) + correction, |f| <= sqrt(2) - 1.
template <Value V>
V sum_logarithm(const V& exponent, const V& f, const V& correction) {
  using C = MathConstants<Scalar<V>>;
  const V half_square = Scalar<V>(0.5) * f * f;
  const V s = f / (Scalar<V>(2) + f);
  const V z = s * s;
  const V rest = s * (half_square + z * polynomial_by_halves(z, C::kLog));
  return exponent * C::kLn2High -
         ((half_square - (rest + (exponent * C::kLn2Low + correction))) - f);
}

/// log(x) for finite x >= 0, to 1 ulp; minus infinity for 0.
template <Value V>
V log_of(const V& x) {
  if constexpr (!kOwnMath<Scalar<V>>) {
    using std::log;
    return log(x);
  } else {
    using R = Scalar<V>;
    constexpr int kUp = MathConstants<R>::kMantissa + 1;
    const Mask<V> subnormal = x < std::numeric_limits<R>::min();
    const SplitNumber<V> split = split_number(select(subnormal, V(x * two_to<R>(kUp)), x));
    const V exponent = select(subnormal, V(split.exponent - R(kUp)), split.exponent);
    const V result = sum_logarithm(exponent, V(split.m - R(1)), V(R(0)));
    return select(x == R(0), V(-std::numeric_limits<R>::infinity()), result);
  }
}

/// log(1 + x) for x from -1 to 1, to 1 ulp; minus infinity for -1.
template <Value V>
V log1p_of(const V& x) {
  if constexpr (!kOwnMath<Scalar<V>>) {
    using std::log1p;
    return log1p(x);
  } else {
    using R = Scalar<V>;
    const V u = R(1) + x;
    const SplitNumber<V> split = split_number(u);
    const Mask<V> near = split.exponent == R(0);  // no digit of x is lost then
    const V f = select(near, x, V(split.m - R(1)));
    const V correction = all_of(near) ? V(R(0)) : select(near, V(R(0)), V((x - (u - R(1))) / u));
    const V result = sum_logarithm(split.exponent, f, correction);
    return select(u == R(0), V(-std::numeric_limits<R>::infinity()), result);
  }
}

/// log(x + low), low at most a unit in the last place of x > 0, to 1 ulp.
template <Value V>
V log_of_sum(const V& x, const V& low) {
  if constexpr (!kOwnMath<Scalar<V>>) {
    using std::log;
    return log(x) + low / x;
  } else {
    const SplitNumber<V> split = split_number(x);
    return sum_logarithm(split.exponent, V(split.m - Scalar<V>(1)), V(low / x));
  }
}

// ---- Arc tangent -----------------------------------------------------------------------------

/// The angle of (x, y) for finite y >= 0, from 0 to pi, to 1.4 ulp; 0 for (0, 0).
template <Value V>
V atan2_of(const V& y, const V& x) {
  if constexpr (!kOwnMath<Scalar<V>>) {
    using std::atan2;
    return atan2(y, x);
  } else {
    using std::fabs;
    using R = Scalar<V>;
    using C = MathConstants<R>;
    const V width = fabs(x);
    const Mask<V> steep = y > width;
    const V a = select(steep, y, width), b = select(steep, width, y);

    // The angle of b/a, 0 to pi/4, from that of 0, 1/2 or 1, whichever is near.
    const Mask<V> low = b < R(7.0 / 16) * a, middle = b < R(11.0 / 16) * a;
    const V near_half = R(2) * b - a, near_one = b - a;
    const V above = select(low, b, select(middle, near_half, near_one));
    const V below = select(low, a, select(middle, V(R(2) * a + b), V(a + b)));
    const V base = select(low, V(R(0)), select(middle, V(C::kAtanHalf[0]), V(C::kQuarterPi[0])));
    const V rest = select(low, V(R(0)), select(middle, V(C::kAtanHalf[1]), V(C::kQuarterPi[1])));
    const V t = above / below;
    const V z = t * t;
    const V tail = t * (z * polynomial(z, C::kAtan)) + rest;

    // Unfold: base + t + tail in the first octant, mirrored at pi/4 and at pi/2.
    const V octant = base + (t + tail);
    const V quarter =
        select(steep, V(C::kHalfPi[0] - (base + (t + (tail - C::kHalfPi[1])))), octant);
    const V obtuse = select(steep, V(C::kHalfPi[0] + (base + (t + (tail + C::kHalfPi[1])))),
                            V(C::kPi[0] - (base + (t + (tail - C::kPi[1])))));
    const V angle = select(x < R(0), obtuse, quarter);
    return select(a == R(0), V(R(0)), angle);
  }
}

}  // namespace litmus

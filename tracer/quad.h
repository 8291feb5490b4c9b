// quad.h: numbers of 113 bits (IEEE binary128), the oracle of the other precisions.
//
// g++'s own type behind the operators and functions that the kernel's formulas use of a number,
// so that they find them as they find those of double. The functions are libquadmath's.
#pragma once

#include <quadmath.h>

#include <compare>
#include <concepts>
#include <limits>
#include <type_traits>

namespace litmus {

/// Behaves as double does, but for conversions to other types, which must be asked for.
class Quad {
 public:
  Quad() = default;
  template <class T>
  requires(std::is_arithmetic_v<T> || std::same_as<T, __float128>) constexpr Quad(T value)
      : value_(value) {}

  /// Rounded to the nearest number of another type; of an integer, towards zero.
  template <class T>
  requires std::is_arithmetic_v<T>
  explicit constexpr operator T() const { return T(value_); }
  constexpr __float128 value() const { return value_; }

  constexpr Quad operator-() const { return -value_; }
  friend constexpr Quad operator+(const Quad& a, const Quad& b) { return a.value_ + b.value_; }
  friend constexpr Quad operator-(const Quad& a, const Quad& b) { return a.value_ - b.value_; }
  friend constexpr Quad operator*(const Quad& a, const Quad& b) { return a.value_ * b.value_; }
  friend constexpr Quad operator/(const Quad& a, const Quad& b) { return a.value_ / b.value_; }
  constexpr Quad& operator+=(const Quad& b) { return *this = *this + b; }
  constexpr Quad& operator*=(const Quad& b) { return *this = *this * b; }
  constexpr Quad& operator/=(const Quad& b) { return *this = *this / b; }

  friend constexpr bool operator==(const Quad& a, const Quad& b) { return a.value_ == b.value_; }
  friend constexpr std::partial_ordering operator<=>(const Quad& a, const Quad& b) {
    return a.value_ < b.value_    ? std::partial_ordering::less
           : a.value_ > b.value_  ? std::partial_ordering::greater
           : a.value_ == b.value_ ? std::partial_ordering::equivalent
                                  : std::partial_ordering::unordered;
  }

 private:
  __float128 value_ = 0;
};

inline Quad abs(const Quad& x) { return fabsq(x.value()); }
inline Quad fabs(const Quad& x) { return fabsq(x.value()); }
inline Quad sqrt(const Quad& x) { return sqrtq(x.value()); }
inline Quad cos(const Quad& x) { return cosq(x.value()); }
inline Quad sin(const Quad& x) { return sinq(x.value()); }
inline Quad tan(const Quad& x) { return tanq(x.value()); }
inline Quad exp(const Quad& x) { return expq(x.value()); }
inline Quad expm1(const Quad& x) { return expm1q(x.value()); }
inline Quad log(const Quad& x) { return logq(x.value()); }
inline Quad log1p(const Quad& x) { return log1pq(x.value()); }
inline Quad atan2(const Quad& y, const Quad& x) { return atan2q(y.value(), x.value()); }
inline Quad frexp(const Quad& x, int* exponent) { return frexpq(x.value(), exponent); }
inline Quad ldexp(const Quad& x, int exponent) { return ldexpq(x.value(), exponent); }

}  // namespace litmus

template <>
struct std::numeric_limits<litmus::Quad> {
  static constexpr bool is_specialized = true, is_signed = true, is_iec559 = true;
  static constexpr bool has_infinity = true, has_quiet_NaN = true;
  static constexpr bool is_integer = false, is_exact = false;
  static constexpr int radix = 2, digits = 113, min_exponent = -16381, max_exponent = 16384;
  static constexpr litmus::Quad epsilon() { return 0x1p-112L; }
  static constexpr litmus::Quad min() { return 0x1p-16382L; }
  static constexpr litmus::Quad max() { return litmus::Quad(0x1p16383L) * (2 - epsilon()); }
  static constexpr litmus::Quad lowest() { return -max(); }
  static constexpr litmus::Quad infinity() { return __builtin_huge_valq(); }
  static constexpr litmus::Quad quiet_NaN() { return __builtin_nanq(""); }
};

// value.h: the scalars that the kernel is written for, and vectors of them.
#pragma once

#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <type_traits>

namespace litmus {

using Quad = boost::multiprecision::float128;  ///< 113 bits: the oracle of the other three

/// float, double, long double or Quad.
template <class T>
concept Real = std::is_floating_point_v<T> || std::is_same_v<T, Quad>;

/// Where many terms meet: a float kernel adds up in double, every other one in its own type.
template <Real R>
using Sum = std::conditional_t<std::is_same_v<R, float>, double, R>;

/// Half the distance from 1 to the next number: the largest relative rounding error of one
/// operation.
template <Real R>
inline const R kUnit = std::numeric_limits<R>::epsilon() / 2;

/// Bound on the relative error of n rounded operations (Higham 2002, lemma 3.1).
template <Real R>
R gamma_bound(int n) {
  return R(n) * kUnit<R> / (1 - R(n) * kUnit<R>);
}

/// a*b - c*d to 1.5 ulp (Kahan; Jeannerod, Louvet and Muller 2013): the rounding error of c*d is
/// added back.
template <Real R>
R difference_of_products(R a, R b, R c, R d) {
  if constexpr (std::is_same_v<R, Quad>) {
    return a * b - c * d;
  } else {
    const R product = c * d;
    return std::fma(a, b, -product) + std::fma(-c, d, product);
  }
}

template <Real R>
struct Vec {
  R x{}, y{}, z{};

  Vec() = default;
  Vec(R x, R y, R z) : x(x), y(y), z(z) {}
  explicit Vec(const glm::dvec3& v) : x(R(v.x)), y(R(v.y)), z(R(v.z)) {}

  R operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Vec operator-() const { return {-x, -y, -z}; }
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(const Vec& a, const Vec& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Vec operator*(R s, const Vec& v) { return {s * v.x, s * v.y, s * v.z}; }
  friend Vec operator/(const Vec& v, R s) { return {v.x / s, v.y / s, v.z / s}; }
  friend bool operator==(const Vec&, const Vec&) = default;
};

template <Real R>
R dot(const Vec<R>& a, const Vec<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <Real R>
Vec<R> cross(const Vec<R>& a, const Vec<R>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// The largest absolute value of a component.
template <Real R>
R max_abs(const Vec<R>& v) {
  using std::fabs;
  const R x = fabs(v.x), y = fabs(v.y), z = fabs(v.z);
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

/// A vector as unit direction and length. A zero vector has length 0 and a zero direction.
template <Real R>
struct Direction {
  Vec<R> unit;
  R length{};
};

/// Splits a vector whose squared length may over- or underflow: it is then scaled by a power of two
/// first, which changes no digit of the result.
template <Real R>
Direction<R> direction_of(const Vec<R>& v) {
  using std::frexp, std::ldexp, std::sqrt;
  static const R kSmall = ldexp(R(1), std::numeric_limits<R>::min_exponent / 2);
  static const R kLarge = ldexp(R(1), std::numeric_limits<R>::max_exponent / 2);
  const R squared = dot(v, v);
  if (squared > kSmall && squared < kLarge) {
    const R length = sqrt(squared);
    return {v / length, length};
  }
  const R largest = max_abs(v);
  if (!(largest > 0) || !(largest <= std::numeric_limits<R>::max())) return {};
  int exponent = 0;
  frexp(largest, &exponent);
  const Vec<R> scaled{ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
  const R length = sqrt(dot(scaled, scaled));
  return {scaled / length, ldexp(length, exponent)};
}

template <Real R>
Vec<R> normalize(const Vec<R>& v) {
  return direction_of(v).unit;
}

}  // namespace litmus

// value.h: the numbers that the kernel is written for, and vectors of them.
//
// A Value is one scalar (Real) or a packet of scalars (packet.h) that are computed side by side. A
// formula written for Value has no branch on numbers: it computes both sides and selects, so that
// every lane of a packet gets the same bits as a scalar would.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <type_traits>

#include "tracer/quad.h"

namespace litmus {

/// Kept out of the code around it, which is faster without: for what is seldom called. Values are
/// passed to such a function by value; a reference would keep them in memory for the common case.
#define LITMUS_COLD [[gnu::noinline, gnu::cold]]

/// float, double, long double or Quad.
template <class T>
concept Real = std::is_floating_point_v<T> || std::is_same_v<T, Quad>;

/// What belongs to a value type; packet.h adds packets.
template <class V>
struct ValueTraits {
  using Scalar = V;  ///< of a lane
  using Mask = bool;
  using Index = int;  ///< a number of an object: an int, or a lane each
  using Bits = std::conditional_t<sizeof(V) == 4, std::uint32_t, std::uint64_t>;
  /// Where many terms meet: a float kernel adds up in double, every other one in its own type.
  using Sum = std::conditional_t<std::is_same_v<V, float>, double, V>;
  /// For eight scalars that are compared with one: as many of them as go side by side.
  using Abreast = V;
  static constexpr int kLanes = 1;
  static V load(const V* scalars) { return *scalars; }
};

template <class V>
using Scalar = typename ValueTraits<V>::Scalar;
template <class V>
using Mask = typename ValueTraits<V>::Mask;
template <class V>
using Index = typename ValueTraits<V>::Index;
template <class V>
using Bits = typename ValueTraits<V>::Bits;
template <class V>
using Sum = typename ValueTraits<V>::Sum;
template <class V>
using Abreast = typename ValueTraits<V>::Abreast;
template <class V>
inline constexpr int kLanes = ValueTraits<V>::kLanes;

/// A Real or a packet of float or double.
template <class V>
concept Value = Real<Scalar<V>>;

// ---- A scalar as a packet of one lane --------------------------------------------------------

/// a where the condition holds, else b; both are computed.
template <class T>
T select(bool condition, const T& a, const T& b) {
  return condition ? a : b;
}
inline bool any_of(bool mask) { return mask; }
inline bool all_of(bool mask) { return mask; }
inline bool none_of(bool mask) { return !mask; }
inline int count_of(bool mask) { return mask; }
/// A bit for each lane, the lowest for the first.
inline unsigned lanes_of(bool mask) { return mask; }

/// The largest and the smallest of all lanes.
template <Real R>
R largest_of(const R& a) {
  return a;
}
template <Real R>
R smallest_of(const R& a) {
  return a;
}

/// The larger and the smaller of two; b where one of them is not a number.
template <Real R>
R larger(const R& a, const R& b) {
  return a > b ? a : b;
}
template <Real R>
R smaller(const R& a, const R& b) {
  return a < b ? a : b;
}

/// One lane of a value, of a mask or of an index.
template <class T>
requires(Real<T> || std::is_integral_v<T>) T lane(const T& value, int) { return value; }
template <class T>
requires(Real<T> || std::is_integral_v<T>) void set_lane(T& value, int, const T& scalar) {
  value = scalar;
}

/// All lanes of a value, one after the other.
template <Real R>
void copy_lanes(const R& value, R* lanes) {
  *lanes = value;
}

/// All lanes of three values: x, y and z of the first, of the second and so on.
template <Real R>
void copy_interleaved(const R& x, const R& y, const R& z, R* lanes) {
  lanes[0] = x, lanes[1] = y, lanes[2] = z;
}

/// As many scalars, one after the other, as the value has lanes.
template <Value V>
V load_lanes(const Scalar<V>* scalars) {
  return ValueTraits<V>::load(scalars);
}

/// The value in the type that sums are made in.
template <Real R>
Sum<R> widen(const R& value) {
  return Sum<R>(value);
}

// ---- Bits ------------------------------------------------------------------------------------

/// Whether vector_math.h computes for R, rather than R's own library.
template <Real R>
inline constexpr bool kOwnMath = std::is_same_v<R, float> || std::is_same_v<R, double>;

inline std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }
inline std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value); }

template <Value V>
V from_bits(const Bits<V>& bits) {
  if constexpr (kLanes<V> == 1) {
    return std::bit_cast<V>(bits);
  } else {
    return V::from_bits(bits);
  }
}

// ---- Rounding --------------------------------------------------------------------------------

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
template <Value V>
V difference_of_products(const V& a, const V& b, const V& c, const V& d) {
  if constexpr (std::is_same_v<V, Quad>) {
    return a * b - c * d;
  } else {
    using std::fma;
    const V product = c * d;
    return fma(a, b, -product) + fma(-c, d, product);
  }
}

// ---- Vectors ---------------------------------------------------------------------------------

template <Value V>
struct Vec {
  V x{}, y{}, z{};

  Vec() = default;
  Vec(const V& x, const V& y, const V& z) : x(x), y(y), z(z) {}
  explicit Vec(const glm::dvec3& v) : x(Scalar<V>(v.x)), y(Scalar<V>(v.y)), z(Scalar<V>(v.z)) {}
  /// The same vector in every lane.
  template <class S>
  requires(!std::is_same_v<S, V> && std::is_same_v<S, Scalar<V>>) explicit Vec(const Vec<S>& v)
      : x(v.x), y(v.y), z(v.z) {}

  const V& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Vec operator-() const { return {-x, -y, -z}; }
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(const Vec& a, const Vec& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Vec operator*(const V& s, const Vec& v) { return {s * v.x, s * v.y, s * v.z}; }
  friend Vec operator/(const Vec& v, const V& s) { return {v.x / s, v.y / s, v.z / s}; }
  friend bool operator==(const Vec&, const Vec&) = default;
};

template <Value V>
requires(kLanes<V> > 1) Vec<V> select(const Mask<V>& mask, const Vec<V>& a, const Vec<V>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

template <Value V>
V dot(const Vec<V>& a, const Vec<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <Value V>
Vec<V> cross(const Vec<V>& a, const Vec<V>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// The largest absolute value of a component.
template <Value V>
V max_abs(const Vec<V>& v) {
  using std::fabs;
  const V x = fabs(v.x), y = fabs(v.y), z = fabs(v.z);
  const V xz = select(x > z, x, z), yz = select(y > z, y, z);
  return select(x > y, xz, yz);
}

/// 2^exponent; compiled away where the exponent is a constant.
template <Real R>
constexpr R two_to(int exponent) {
  R power = 1;
  for (; exponent > 0; --exponent) power *= 2;
  for (; exponent < 0; ++exponent) power /= 2;
  return power;
}

/// Powers of two around which direction_of() finds its way.
template <Real R>
struct SafeSquares {
  static constexpr int kMost = std::numeric_limits<R>::max_exponent;
  static constexpr int kLeast = std::numeric_limits<R>::min_exponent;
  static inline const R kSmall = two_to<R>(kLeast / 2), kLarge = two_to<R>(kMost / 2);
  static inline const R kShrink = two_to<R>(-kMost * 5 / 8), kGrow = two_to<R>(kMost * 11 / 16);
};

/// A vector as unit direction and length. A zero vector has length 0 and a zero direction.
template <Value V>
struct Direction {
  Vec<V> unit;
  V length{};
};

/// How a vector is divided by its length: each component, so that a vector along an axis stays
/// there to the last digit, or by one reciprocal, which costs half a unit in the last place and
/// saves two of the operations that the kernel spends most of its time on.
enum class Divide { Each, Once };

template <Divide kDivide, Value V>
Vec<V> divide(const Vec<V>& v, const V& length) {
  if constexpr (kDivide == Divide::Once) {
    return V(Scalar<V>(1) / length) * v;
  } else {
    return v / length;
  }
}

/// direction_of() where the squared length may over- or underflow: scaled by a power of two first,
/// which changes no digit of the result.
template <Divide kDivide, Value V>
LITMUS_COLD Direction<V> scaled_direction_of(Vec<V> v) {
  using std::sqrt;
  using R = Scalar<V>;
  const V largest = max_abs(v);
  const Mask<V> sound = (largest > R(0)) & (largest <= std::numeric_limits<R>::max());
  const Mask<V> large = largest > R(1);
  const V scale = select(large, V(SafeSquares<R>::kShrink), V(SafeSquares<R>::kGrow));
  const Vec<V> scaled = scale * v;
  const V length = sqrt(dot(scaled, scaled));
  return {select(sound, divide<kDivide>(scaled, length), Vec<V>{}),
          select(sound, V(length / scale), V(R(0)))};
}

/// Notes squares that may have over- or underflown, so that a result must be found with more care.
template <Value V>
class Doubt {
 public:
  void note(const V& squared) {
    if constexpr (kOwnMath<R>) sure_ = sure_ & (bits_of(squared) + Bits<V>(kStep));
  }

  /// Where one of the squares was not from 2^-511 to 2^513 (float: 2^-63 to 2^65).
  Mask<V> where() const {
    if constexpr (kOwnMath<R>) return from_bits<V>(sure_ & Bits<V>(kStep << 1)) == R(0);
    return true;
  }

 private:
  using R = Scalar<V>;
  using B = Scalar<Bits<V>>;
  /// Half of the highest bit of the exponent: added to the bits of a number, it leaves that bit set
  /// just where the two highest were different, which they are in the middle half of all exponents.
  static constexpr B kStep = B(1) << (8 * sizeof(B) - 3);
  Bits<V> sure_ = Bits<V>(B(-1));
};

/// Splits a vector into its direction and its length, both to a few ulp for any finite vector.
/// With `doubt`, only for vectors whose square neither over- nor underflows; it notes the others.
template <Divide kDivide = Divide::Each, Value V>
Direction<V> direction_of(const Vec<V>& v, Doubt<V>* doubt = nullptr) {
  using std::sqrt;
  using R = Scalar<V>;
  const V squared = dot(v, v);
  V length = sqrt(squared);
  Vec<V> unit = divide<kDivide>(v, length);
  if (doubt) {
    doubt->note(squared);
    return {unit, length};
  }
  // The same squares as a Doubt is sure of.
  const R least = SafeSquares<R>::kSmall / 2, most = SafeSquares<R>::kLarge * 2;
  const Mask<V> safe = (squared >= least) & (squared < most);
  if (!all_of(safe)) {
    const Direction<V> careful = scaled_direction_of<kDivide>(v);
    unit = select(safe, unit, careful.unit), length = select(safe, length, careful.length);
  }
  return {unit, length};
}

template <Divide kDivide = Divide::Each, Value V>
Vec<V> normalize(const Vec<V>& v) {
  return direction_of<kDivide>(v).unit;
}

}  // namespace litmus

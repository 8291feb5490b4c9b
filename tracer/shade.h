// shade.h: how a surface answers light (slide 5), as the slide's equation and as its sample code.
#pragma once

#include <bit>

#include "scene/scene.h"
#include "tracer/vector_math.h"

namespace litmus {

/// What a light does to a point apart from all colours: the factors of kd Id and of ks Is in
/// slide 5.
template <Value V>
struct Terms {
  V diffuse{};   ///< D = visibility * attenuation * (l.n)
  V specular{};  ///< S = visibility * attenuation * (h.n)^ns
};

/// h = normalize(l + e), slide 5, of two unit vectors, with the length of l + e; zero for e = -l.
template <Value V>
Direction<V> half_vector(const Vec<V>& l, const Vec<V>& e, Doubt<V>* doubt = nullptr) {
  return direction_of<Divide::Once>(l + e, doubt);
}

/// The largest shininess that is a power by multiplications; they take longer than the logarithm
/// and exponential of any power from there on.
inline constexpr int kMostWhole = 256;

/// A shininess ns >= 0, and what the power needs to know of it: asked once for many lights.
template <Value V>
struct Exponent {
  V value{};
  Mask<V> whole = false;  ///< a whole number from 1 to kMostWhole
  int shared = 0;         ///< the whole number that all lanes have; else 0
  bool broad = true;      ///< some lane is below 3

  Exponent() = default;
  /// One lane's for all of them.
  template <Real R>
  requires(kLanes<V> > 1) explicit Exponent(const Exponent<R>& one)
      : value(one.value), whole(one.whole), shared(one.shared), broad(one.broad) {}
  Exponent(const V& value) : value(value) {
    using R = Scalar<V>;
    broad = any_of(value < R(3));
    if constexpr (kOwnMath<R>) {
      // Adding this leaves no bit for a fraction.
      constexpr R kShift = R(3) * two_to<R>(std::numeric_limits<R>::digits - 2);
      whole = (value >= R(1)) & (value <= R(kMostWhole)) & ((value + kShift) - kShift == value);
      const R first = lane(value, 0);
      if (all_of(whole) && all_of(value == first)) shared = int(first);
    }
  }
};

/// a * b of two numbers known to twice their digits.
template <Value V>
Rounded<V> product(const Rounded<V>& a, const Rounded<V>& b) {
  using std::fma;
  const V value = a.value * b.value;
  return {value, fma(a.value, b.value, -value) + (a.value * b.rest + a.rest * b.value)};
}

template <Value V>
Rounded<V> squared(const Rounded<V>& a) {
  using std::fma;
  const V value = a.value * a.value;
  return {value, fma(a.value, a.value, -value) + (a.value + a.value) * a.rest};
}

/// x^n where n is whole, for an x known to twice its digits: by squaring, with the rounding error
/// of every product carried along, so that the last addition loses half a unit in the last place
/// and all before next to nothing.
template <Value V>
V whole_power(const Rounded<V>& x, const Exponent<V>& n) {
  using R = Scalar<V>;
  Rounded<V> square = x;
  if (n.shared > 0) {
    int bits = n.shared;
    for (; !(bits & 1); bits >>= 1) square = squared(square);
    Rounded<V> result = square;
    while (bits >>= 1) {
      square = squared(square);
      if (bits & 1) result = product(result, square);
    }
    return result.value + result.rest;
  } else {
    // The binary digits of n, from the highest down: exact in every rounding mode.
    constexpr int kDigits = std::bit_width(unsigned(kMostWhole));
    Mask<V> digits[kDigits];
    V left = select(n.whole, n.value, V(R(0)));
    int highest = 0;
    for (int k = kDigits - 1; k >= 0; --k) {
      digits[k] = left >= R(1 << k);
      left = left - select(digits[k], V(R(1 << k)), V(R(0)));
      if (highest == 0 && any_of(digits[k])) highest = k;
    }
    Rounded<V> result{V(R(1)), V(R(0))};
    for (int k = 0; k <= highest; ++k) {
      const Rounded<V> more = product(result, square);
      result = {select(digits[k], more.value, result.value),
                select(digits[k], more.rest, result.rest)};
      square = squared(square);
    }
    return result.value + result.rest;
  }
}

/// x^n of an x known to twice its digits, x <= 1; some finite number where x is not positive.
template <Value V>
V power_of(const Rounded<V>& x, const Exponent<V>& n) {
  using R = Scalar<V>;
  const auto general = [&] {
    const Mask<V> ahead = x.value >= std::numeric_limits<R>::min();
    const V value = select(ahead, x.value, V(R(1))), rest = select(ahead, x.rest, V(R(0)));
    return exp_of(V(n.value * log_of_sum(value, rest)));
  };
  if constexpr (kOwnMath<Scalar<V>>) {
    if (all_of(n.whole)) return whole_power(x, n);
    if (any_of(n.whole)) return select(n.whole, whole_power(x, n), general());
  }
  return general();
}

/// h.n of two unit vectors, known to twice its digits where the power asks for them. h.n is
/// 1 - |n - h|^2 / 2, whose digits last near the peak, where h.n itself has lost them; it is a
/// compensated product where a broad highlight is seen more than 60 degrees off its peak, where the
/// difference has lost them. (With ns from 3 on, nothing above 1/8 is so far off.)
template <Value V>
Rounded<V> cosine_of(const Vec<V>& h, const Vec<V>& n,
                     const std::type_identity_t<Exponent<V>>& shininess) {
  using R = Scalar<V>;
  const Vec<V> apart = n - h;
  const V shortfall = dot(apart, apart) * R(0.5);
  V cosine = R(1) - shortfall, rest = (R(1) - cosine) - shortfall;
  if (shininess.broad) {
    const Mask<V> far = (shortfall > R(0.5)) & (shininess.value < R(3));
    const Rounded<V> exact = compensated_dot(h, n);
    cosine = select(far, exact.value, cosine), rest = select(far, exact.rest, rest);
  }
  return {cosine, rest};
}

/// (h.n)^ns, never above 1; 0 where h.n <= 0, but for the rounding of h.n. The power is made of
/// multiplications for a whole ns up to kMostWhole, else by logarithm and exponential. With
/// cosine_of() at most 12 ulp from quad precision where it is above 1/7, for ns up to 1e6; up to 29
/// ulp where it is above 1/64.
template <Value V>
V power_of_cosine(const Rounded<V>& cosine, const std::type_identity_t<Exponent<V>>& shininess) {
  using R = Scalar<V>;
  const Mask<V> ahead = cosine.value >= std::numeric_limits<R>::min();
  const V power = power_of(cosine, shininess);
  return select(ahead, power, V(R(0)));
}

/// The same of the two unit vectors.
template <Value V>
V power_of_cosine(const Vec<V>& h, const Vec<V>& n,
                  const std::type_identity_t<Exponent<V>>& shininess) {
  return power_of_cosine(cosine_of(h, n, shininess), shininess);
}

/// h.n of slide 5 as cosine_of() gives it; 0 for e = -l. All vectors are unit. `doubt` as for
/// direction_of(): it knows of e = -l.
template <Value V>
Rounded<V> highlight_cosine(const Vec<V>& l, const Vec<V>& e, const Vec<V>& n,
                            const std::type_identity_t<Exponent<V>>& shininess,
                            Doubt<V>* doubt = nullptr) {
  using R = Scalar<V>;
  const Direction<V> h = half_vector(l, e, doubt);
  Rounded<V> cosine = cosine_of(h.unit, n, shininess);
  if (!doubt) cosine.value = select(h.length > R(0), cosine.value, V(R(0)));
  return cosine;
}

/// (h.n)^ns, slide 5; 0 where h.n <= 0 (but for its rounding) and for e = -l. All vectors are unit.
template <Value V>
V specular_power(const Vec<V>& l, const Vec<V>& e, const Vec<V>& n,
                 const std::type_identity_t<Exponent<V>>& shininess) {
  return power_of_cosine(highlight_cosine(l, e, n, shininess), shininess);
}

/// The equation's gate: a light behind the surface adds nothing, specular included. `l_dot_n` is
/// the light's cosine, `power` that of the highlight.
template <Value V>
Terms<V> equation_terms(const V& l_dot_n, const V& power, const V& intensity) {
  const V none = Scalar<V>(0);
  const Mask<V> faces = l_dot_n > none;
  return {select(faces, V(intensity * l_dot_n), none), select(faces, V(intensity * power), none)};
}

/// The same of vectors, without the gate, as smooth functions of l: D goes on below 0 where l.n
/// does.
template <Value V>
Terms<V> ungated_terms(const Vec<V>& l, const Vec<V>& e, const Vec<V>& n,
                       const std::type_identity_t<Exponent<V>>& shininess, const V& intensity,
                       bool wants_specular) {
  return {intensity * dot(l, n),
          wants_specular ? V(intensity * specular_power(l, e, n, shininess)) : V(Scalar<V>(0))};
}

/// The sample code's reading: the specular term is not gated on n.l. (`power` takes n.h clamped at
/// 0, so that it is finite.)
template <Value V>
Terms<V> sample_code_terms(const V& l_dot_n, const V& power, const V& intensity) {
  const V none = Scalar<V>(0);
  return {select(l_dot_n > none, V(intensity * l_dot_n), none), intensity * power};
}

/// One channel of a matte surface's answer to one light: kd Id D, slide 5.
template <Value V>
V reflected_diffusely(const Terms<V>& terms, const V& diffuse, const V& light_diffuse) {
  return diffuse * light_diffuse * terms.diffuse;
}

/// One channel of one light's answer: kd Id D + ks Is S, slide 5.
template <Value V>
V reflected(const Terms<V>& terms, const V& diffuse, const V& light_diffuse, const V& specular,
            const V& light_specular) {
  return reflected_diffusely(terms, diffuse, light_diffuse) +
         specular * light_specular * terms.specular;
}

}  // namespace litmus

// shade.h: how a surface answers light (slide 5), as the slide's equation and as its sample code.
#pragma once

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
Direction<V> half_vector(const Vec<V>& l, const Vec<V>& e) {
  return direction_of<Divide::Once>(l + e);
}

/// (h.n)^ns of two unit vectors with h.n > 0, never above 1. h.n is 1 - |n - h|^2 / 2, whose digits
/// last near the peak, where h.n itself has lost them; it is a compensated product where a broad
/// highlight is seen more than 60 degrees off its peak, where the difference has lost them. (With
/// ns from 3 on, nothing above 1/8 is so far off.) At most 12 ulp from quad precision where it is
/// above 1/7, for ns up to 1e6; up to 29 ulp where it is above 1/64.
template <Value V>
V power_of_cosine(const Vec<V>& h, const Vec<V>& n, const V& shininess) {
  using R = Scalar<V>;
  const Vec<V> apart = n - h;
  const V shortfall = dot(apart, apart) * R(0.5);
  V cosine = R(1) - shortfall, rest = (R(1) - cosine) - shortfall;
  const Mask<V> broad = (shortfall > R(0.5)) & (shininess < R(3));
  if (!none_of(broad)) {
    const Rounded<V> product = compensated_dot(h, n);
    cosine = select(broad, product.value, cosine), rest = select(broad, product.rest, rest);
  }
  const Mask<V> ahead = cosine >= std::numeric_limits<R>::min();
  const V logarithm = log_of_sum(select(ahead, cosine, V(R(1))), select(ahead, rest, V(R(0))));
  const V power = exp_of(V(shininess * logarithm));
  return select(ahead, power, V(R(0)));
}

/// (h.n)^ns, slide 5; 0 where h.n <= 0 and for e = -l. All vectors are unit.
template <Value V>
V specular_power(const Vec<V>& l, const Vec<V>& e, const Vec<V>& n, const V& shininess) {
  using R = Scalar<V>;
  const Vec<V> h = half_vector(l, e).unit;
  return select(dot(h, n) > R(0), power_of_cosine(h, n, shininess), V(R(0)));
}

/// The equation's gate: a light behind the surface adds nothing, specular included.
template <Value V>
Terms<V> equation_terms(const Vec<V>& l, const Vec<V>& e, const Vec<V>& n, const V& shininess,
                        const V& intensity, bool wants_specular) {
  using R = Scalar<V>;
  const V cosine = dot(l, n), none = R(0);
  const Mask<V> faces = cosine > R(0);
  Terms<V> terms{select(faces, V(intensity * cosine), none), none};
  if (wants_specular) {
    terms.specular = select(faces, V(intensity * specular_power(l, e, n, shininess)), none);
  }
  return terms;
}

/// The sample code's reading: the specular term is not gated on n.l. (n.h is clamped at 0 so that
/// it is finite.)
template <Value V>
Terms<V> sample_code_terms(const Vec<V>& l, const Vec<V>& e, const Vec<V>& n, const V& shininess,
                           const V& intensity, bool wants_specular) {
  using R = Scalar<V>;
  const V cosine = dot(l, n), none = R(0);
  return {select(cosine > R(0), V(intensity * cosine), none),
          wants_specular ? V(intensity * specular_power(l, e, n, shininess)) : none};
}

/// One channel of one light's answer: kd Id D + ks Is S, slide 5.
template <Value V>
V reflected(const Terms<V>& terms, const V& diffuse, const V& light_diffuse, const V& specular,
            const V& light_specular) {
  return diffuse * light_diffuse * terms.diffuse + specular * light_specular * terms.specular;
}

}  // namespace litmus

// shade.h: how a surface answers light (slide 5), as the slide's equation and as its sample code.
#pragma once

#include "scene/scene.h"
#include "tracer/value.h"

namespace litmus {

/// What a light does to a point apart from all colours: the factors of kd Id and of ks Is in
/// slide 5.
template <Real R>
struct Terms {
  R diffuse{};   ///< D = visibility * attenuation * (l.n)
  R specular{};  ///< S = visibility * attenuation * (h.n)^ns
};

/// h = normalize(l + e), slide 5, of two unit vectors, with the length of l + e; zero for e = -l.
template <Real R>
Direction<R> half_vector(const Vec<R>& l, const Vec<R>& e) {
  return direction_of(l + e);
}

/// (h.n)^ns of two unit vectors with h.n > 0, as exp(ns log1p(-|n - h|^2 / 2)), which never exceeds
/// 1 and keeps its digits for a large ns: near the peak h.n itself has lost them.
template <Real R>
R power_of_cosine(const Vec<R>& h, const Vec<R>& n, R shininess) {
  using std::exp, std::log1p;
  const Vec<R> apart = n - h;
  const R shortfall = dot(apart, apart) / 2;
  return shortfall < 1 ? R(exp(shininess * log1p(-shortfall))) : R(0);
}

/// (h.n)^ns, slide 5; 0 where h.n <= 0 and for e = -l. All vectors are unit.
template <Real R>
R specular_power(const Vec<R>& l, const Vec<R>& e, const Vec<R>& n, R shininess) {
  const Direction<R> half = half_vector(l, e);
  if (half.length == 0 || !(dot(half.unit, n) > 0)) return 0;
  return power_of_cosine(half.unit, n, shininess);
}

/// The equation's gate: a light behind the surface adds nothing, specular included.
template <Real R>
Terms<R> equation_terms(const Vec<R>& l, const Vec<R>& e, const Vec<R>& n, R shininess, R intensity,
                        bool wants_specular) {
  const R cosine = dot(l, n);
  if (!(cosine > 0)) return {};
  return {intensity * cosine,
          wants_specular ? R(intensity * specular_power(l, e, n, shininess)) : R(0)};
}

/// The sample code's reading: the specular term is not gated on n.l. (n.h is clamped at 0 so that
/// it is finite.)
template <Real R>
Terms<R> sample_code_terms(const Vec<R>& l, const Vec<R>& e, const Vec<R>& n, R shininess,
                           R intensity, bool wants_specular) {
  const R cosine = dot(l, n);
  return {cosine > 0 ? R(intensity * cosine) : R(0),
          wants_specular ? R(intensity * specular_power(l, e, n, shininess)) : R(0)};
}

/// One channel of one light's answer: kd Id D + ks Is S, slide 5.
template <Real R>
R reflected(const Terms<R>& terms, R diffuse, R light_diffuse, R specular, R light_specular) {
  return diffuse * light_diffuse * terms.diffuse + specular * light_specular * terms.specular;
}

}  // namespace litmus

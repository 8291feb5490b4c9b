// light_terms.h: what one light does to one hit, first apart from all colours, and where that may
// jump.
#pragma once

#include "scene/picture.h"
#include "tracer/shade.h"
#include "tracer/sum.h"
#include "tracer/visibility.h"

namespace litmus {

/// The terms of a light summed over its lamps, and everything discrete that went into them.
template <Real R>
struct LightTerms {
  Sum<R> diffuse{}, specular{};
  Sum<R> unoccluded{};          ///< lamps with nothing in between (the sample code's reading only)
  std::uint64_t signature = 0;  ///< changes with visibility, side and cone membership of any lamp
  std::uint8_t flags = 0;       ///< kLit, kPenumbra or kUmbra, and kHighlight (scene/picture.h)
};

/// Mixes a small number into a signature (the finaliser of splitmix64, Steele et al. 2014).
inline std::uint64_t mix(std::uint64_t signature, std::uint64_t value) {
  std::uint64_t z = signature * 0x9e3779b97f4a7c15u + value + 1;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// What one lamp does to a hit.
template <Real R>
struct LampTerms {
  Incident<R> light;
  bool faces = false, shades = false;  ///< the geometric, the shading normal is on the lamp's side
  bool reached = false;                ///< and there is light, if nothing is in its way
  bool lit = false;                    ///< and nothing is
  Terms<R> terms;                      ///< not yet shared among the lamps; 0 where not lit
};

/// D and S of one lamp at a hit seen from the direction `eye` (unit, towards the eye).
template <Real R>
LampTerms<R> lamp_terms(const Plan<R>& plan, const Lamp<R>& lamp, const Hit<R>& hit,
                        const Vec<R>& eye) {
  const Finish<R>& finish = plan.finishes[std::size_t(hit.object)];
  LampTerms<R> result;
  result.light = incident(lamp, hit.point);
  const Incident<R>& light = result.light;
  result.faces = dot(light.direction, hit.geometric) > 0;
  result.shades = dot(light.direction, hit.normal) > 0;
  result.reached = plan.sample_code || (result.faces && result.shades && light.intensity > 0);
  result.lit = result.reached && !(plan.shadows && occluded(plan, hit, light));
  if (!result.lit) return result;
  const auto answer = plan.sample_code ? sample_code_terms<R> : equation_terms<R>;
  result.terms =
      answer(light.direction, eye, hit.normal, finish.shininess, light.intensity, finish.shiny);
  return result;
}

/// D and S of one light at a hit seen from the direction `eye` (unit, towards the eye).
template <Real R>
LightTerms<R> light_terms(const Plan<R>& plan, const Source<R>& source, const Hit<R>& hit,
                          const Vec<R>& eye) {
  LightTerms<R> total;
  // Near a silhouette an interpolated normal may be turned the other way than the geometric one.
  total.signature = dot(hit.normal, hit.geometric) < 0;
  std::size_t reached = 0, lit = 0;
  Total<R> diffuse, specular;
  for (const Lamp<R>& lamp : source.lamps) {
    const LampTerms<R> one = lamp_terms(plan, lamp, hit, eye);
    reached += one.reached, lit += one.lit;
    if (one.terms.specular > one.light.intensity / 2) total.flags |= kHighlight;
    total.signature = mix(total.signature,
                          std::uint64_t(one.faces) | std::uint64_t(one.shades) << 1 |
                              std::uint64_t(one.light.in_cone) << 2 | std::uint64_t(one.lit) << 3);
    if (!one.lit) continue;
    diffuse.add(one.terms.diffuse);
    specular.add(one.terms.specular);
    if (plan.sample_code) total.unoccluded += 1;
  }
  if (reached > 0) total.flags |= lit == reached ? kLit : lit > 0 ? kPenumbra : kUmbra;
  total.diffuse = diffuse.value() * Sum<R>(source.weight);
  total.specular = specular.value() * Sum<R>(source.weight);
  return total;
}

/// Slide 5 for one light: kd Id D + ks Is S per channel; the sample code adds A for each lamp in
/// view and takes the light's diffuse colour for both terms.
template <Real R>
Vec<Sum<R>> light_color(const Plan<R>& plan, const Source<R>& source, const Finish<R>& finish,
                        const LightTerms<R>& terms) {
  const Terms<Sum<R>> factors{terms.diffuse, terms.specular};
  const Vec<R>& highlight = plan.sample_code ? source.diffuse : source.specular;
  const auto channel = [&](R kd, R id, R ks, R is, R ka, R ia) {
    const Sum<R> light = reflected<Sum<R>>(factors, Sum<R>(kd), Sum<R>(id), Sum<R>(ks), Sum<R>(is));
    return plan.sample_code ? light + terms.unoccluded * (Sum<R>(ka) * Sum<R>(ia)) : light;
  };
  const Vec<R>& a = finish.ambient;
  const Vec<R>& d = finish.diffuse;
  const Vec<R>& s = finish.specular;
  return {channel(d.x, source.diffuse.x, s.x, highlight.x, a.x, plan.ambient.x),
          channel(d.y, source.diffuse.y, s.y, highlight.y, a.y, plan.ambient.y),
          channel(d.z, source.diffuse.z, s.z, highlight.z, a.z, plan.ambient.z)};
}

}  // namespace litmus

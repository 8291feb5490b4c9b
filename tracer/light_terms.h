// light_terms.h: what one light does to one hit, apart from all colours, and where that may jump.
#pragma once

#include "tracer/shade.h"
#include "tracer/visibility.h"

namespace litmus {

/// The terms of a light summed over its lamps, and everything discrete that went into them.
template <Real R>
struct LightTerms {
  Sum<R> diffuse{}, specular{};
  Sum<R> unoccluded{};          ///< lamps with nothing in between (the sample code's reading only)
  std::uint64_t signature = 0;  ///< changes with visibility, side and cone membership of any lamp
};

/// Mixes a small number into a signature (the finaliser of splitmix64, Steele et al. 2014).
inline std::uint64_t mix(std::uint64_t signature, std::uint64_t value) {
  std::uint64_t z = signature * 0x9e3779b97f4a7c15u + value + 1;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// D and S of one light at a hit seen from the direction `eye` (unit, towards the eye).
template <Real R>
LightTerms<R> light_terms(const Plan<R>& plan, const Source<R>& source, const Hit<R>& hit,
                          const Vec<R>& eye) {
  const Finish<R>& finish = plan.finishes[std::size_t(hit.object)];
  LightTerms<R> total;
  // Near a silhouette an interpolated normal may be turned the other way than the geometric one.
  total.signature = dot(hit.normal, hit.geometric) < 0;
  for (const Lamp<R>& lamp : source.lamps) {
    const Incident<R> light = incident(lamp, hit.point);
    const bool faces = dot(light.direction, hit.geometric) > 0;
    const bool shades = dot(light.direction, hit.normal) > 0;
    bool lit = plan.sample_code || (faces && shades && light.intensity > 0);
    if (lit && plan.shadows) lit = !occluded(plan, hit, light);
    total.signature =
        mix(total.signature, std::uint64_t(faces) | std::uint64_t(shades) << 1 |
                                 std::uint64_t(light.in_cone) << 2 | std::uint64_t(lit) << 3);
    if (!lit) continue;
    const auto answer = plan.sample_code ? sample_code_terms<R> : equation_terms<R>;
    const Terms<R> terms =
        answer(light.direction, eye, hit.normal, finish.shininess, light.intensity, finish.shiny);
    total.diffuse += Sum<R>(terms.diffuse);
    total.specular += Sum<R>(terms.specular);
    if (plan.sample_code) total.unoccluded += 1;
  }
  total.diffuse = total.diffuse * Sum<R>(source.weight);
  total.specular = total.specular * Sum<R>(source.weight);
  return total;
}

}  // namespace litmus

// lamp_terms.h: what one lamp does to one hit, step by step.
#pragma once

#include <algorithm>

#include "tracer/shade.h"
#include "tracer/visibility.h"

namespace litmus {

/// The finish of what is hit, lane by lane; of the first object where nothing is.
template <Real R, Value V>
Finish<V> finish_of(const Plan<R>& plan, const Hit<V>& hit) {
  if constexpr (kLanes<V> == 1) {
    const Finish<R>& one = plan.finishes[std::size_t(std::max(hit.object, 0))];
    if constexpr (std::is_same_v<V, R>) return one;
    return {Vec<V>(one.ambient),
            Vec<V>(one.diffuse),
            Vec<V>(one.specular),
            Exponent<V>(V(one.shininess.value)),
            one.shiny,
            one.reflects};
  } else {
    const auto of_all = [](const Finish<R>& one) -> Finish<V> {
      return {Vec<V>(one.ambient),        Vec<V>(one.diffuse), Vec<V>(one.specular),
              Exponent<V>(one.shininess), one.shiny,           one.reflects};
    };
    if (!hit.mixed) return of_all(plan.finishes[std::size_t(std::max(hit.one.object, 0))]);
    Finish<V> all;
    const Mask<V> seen = seen_by(hit);
    // Lanes that see nothing take a shininess that is there: powers of one exponent are cheaper.
    V shininess = R(0);
    if (any_of(seen)) {
      const auto first = std::size_t(lane(hit.object, first_of(seen)));
      shininess = V(plan.finishes[first].shininess.value);
    }
    for (Mask<V> left = seen; any_of(left);) {
      const Scalar<V> object = lane(hit.object, first_of(left));
      const Finish<R>& one = plan.finishes[std::size_t(object)];
      const Mask<V> on = hit.object == Index<V>(object);
      if (all_of(on)) return of_all(one);
      all.ambient = select(on, Vec<V>(one.ambient), all.ambient);
      all.diffuse = select(on, Vec<V>(one.diffuse), all.diffuse);
      all.specular = select(on, Vec<V>(one.specular), all.specular);
      shininess = select(on, V(one.shininess.value), shininess);
      all.shiny = all.shiny | (on & one.shiny), all.reflects = all.reflects | (on & one.reflects);
      left = left & !on;
    }
    all.shininess = Exponent<V>(shininess);
    return all;
  }
}

/// What is asked for, and how it is found.
struct Task {
  static constexpr bool kBare = false;
  bool edges, everything, sample_code;  ///< as in the plan
  Counts* counts = nullptr;
};

/// Colours by the equation, the common case: the compiler leaves out all else, and squares that
/// over- or underflow are only noted.
struct BareTask {
  static constexpr bool kBare = true;
  static constexpr bool edges = false, everything = false, sample_code = false;
  static constexpr Counts* counts = nullptr;
};

template <Real R>
Task task_of(const Plan<R>& plan, Counts* counts = nullptr) {
  return {plan.edges, plan.everything, plan.sample_code, counts};
}

/// What one lamp sends to a hit, step by step.
template <Value V>
struct LampLight {
  Incident<V> light;                      ///< weakened where the lamp is on the right side
  V l_dot_n{};                            ///< cosine between the shading normal and the light
  Mask<V> faces = false, shades = false;  ///< the geometric, the shading normal is on its side
  Mask<V> open = false;                   ///< and the surface reflects at all
  Mask<V> reached = false;                ///< and there is light, if nothing is in its way
  Mask<V> lit = false;                    ///< and nothing is
  Rounded<V> h_dot_n{};                   ///< highlight_cosine(); unset where nothing shines
};

/// What one lamp does to a hit.
template <Value V>
struct LampTerms : LampLight<V> {
  Terms<V> terms;  ///< not yet shared among the lamps; 0 where not lit
};

/// Weakens a lamp's light at a point where `open` asks for it. A cosine settles most points outside
/// of a cone.
template <Real R, Value V>
void weaken(const Lamp<R>& lamp, const Vec<V>& point, const Mask<V>& open, Incident<V>& light,
            Counts* counts) {
  const bool cull = lamp.cone && !lamp.everything;
  const Mask<V> asked = cull ? open & may_be_in_cone(lamp, light) : open;
  if (cull && none_of(asked)) {
    light.in_cone = false, light.intensity = R(0);
    return;
  }
  if (lamp.attenuated) attenuate(lamp, light);
  if (lamp.cone) narrow(lamp, point, light);
  if (!counts) return;
  const std::uint64_t points = std::uint64_t(count_of(asked));
  if (lamp.linear != R(0) || lamp.everything) counts->linear += points;
  if (lamp.quadratic != R(0) || lamp.everything) counts->quadratic += points;
  if (lamp.cone) counts->cones += points;
}

/// Whether the light of one lamp reaches a hit, and how much of it, if nothing is in its way; lit
/// is left for see(), and a bare task does not ask for what leads to `reached`. `wanted` is where
/// it matters at all. `doubt` as for direction_of(). Written where it stays: a result that is
/// returned would be copied through memory, which took as long as to compute it.
template <Real R, Value V, class T>
void reach(const Plan<R>& plan, const Lamp<R>& lamp, const Hit<V>& hit, const Mask<V>& wanted,
           const T& task, LampLight<V>& result, Doubt<V>* doubt = nullptr) {
  // Which side is it on? The sample code does not ask.
  Incident<V> light = aim(lamp, hit.point, doubt);
  V cosine = dot(light.direction, hit.geometric);
  const Mask<V> faces = cosine > R(0);
  if (plan.smooth) cosine = dot(light.direction, hit.normal);
  const Mask<V> shades = cosine > R(0);
  const Mask<V> open = task.sample_code ? wanted : wanted & faces & shades;
  // How much of it arrives?
  Mask<V> reached = false;
  if (any_of(open) || task.everything) {
    weaken(lamp, hit.point, open, light, task.counts);
    reached = task.sample_code ? open : open & (light.intensity > R(0));
  }
  result.light = light, result.l_dot_n = cosine, result.reached = reached;
  if (!T::kBare) result.open = open, result.faces = faces, result.shades = shades;
}

/// occluded(), apart from the code around it: that need not keep room for what it does in there.
template <Real R, Value V>
[[gnu::noinline]] Mask<V> hidden_from(const Plan<R>& plan, const Hit<V>& hit,
                                      const Incident<V>& light, Mask<V> asked,
                                      const Suspects& suspects) {
  return occluded(plan, hit, light, asked, suspects);
}

/// Where nothing stands between a hit and a lamp that reaches it. Only the suspects can be in the
/// way, if there are any.
template <Real R, Value V, class T>
void see(const Plan<R>& plan, const Hit<V>& hit, const Suspects* suspects, const T& task,
         LampLight<V>& one) {
  one.lit = one.reached;
  if (!plan.shadows && !plan.idle_shadows) return;
  const Mask<V> asked = task.everything ? seen_by(hit) : one.reached;
  if (none_of(asked)) return;
  if (task.counts) task.counts->shadow_rays += std::uint64_t(count_of(asked));
  if (!suspects) return;
  const Mask<V> hidden = hidden_from(plan, hit, one.light, asked, *suspects);
  if (plan.shadows) one.lit = one.reached & !hidden;
}

/// Where a hit may shine in a lamp's light.
template <Value V, class T>
bool may_shine(const Finish<V>& finish, const T& task, const LampLight<V>& one) {
  return any_of(one.lit & finish.shiny) || task.everything;
}

/// Finds the half vector's cosine at a hit seen from the direction `eye` (unit, towards the eye).
/// `doubt` as for direction_of().
template <Real R, Value V, class T>
void halve(const Plan<R>& plan, const Hit<V>& hit, const Finish<V>& finish, const Vec<V>& eye,
           const T& task, LampLight<V>& one, Doubt<V>* doubt = nullptr) {
  if (!may_shine(finish, task, one)) return;
  one.h_dot_n = highlight_cosine(one.light.direction, eye, shading_normal(plan, hit),
                                 finish.shininess, doubt);
}

/// What the surface answers to a lamp's light, D and S.
template <Value V, class T>
Terms<V> answer(const Hit<V>& hit, const Finish<V>& finish, const T& task,
                const LampLight<V>& one) {
  const bool shines = may_shine(finish, task, one);
  if (task.counts && shines) {
    const Mask<V> asked = task.everything ? seen_by(hit) : one.lit & finish.shiny;
    task.counts->powers += std::uint64_t(count_of(asked));
  }
  const V intensity = select(one.lit, one.light.intensity, V(Scalar<V>(0)));
  V power = Scalar<V>(0);
  if (shines) power = select(finish.shiny, power_of_cosine(one.h_dot_n, finish.shininess), power);
  return task.sample_code ? sample_code_terms(one.l_dot_n, power, intensity)
                          : equation_terms(one.l_dot_n, power, intensity);
}

/// Where a hit asks for light. A surface that reflects nothing has edges all the same.
template <Value V, class T>
Mask<V> wanted_at(const Hit<V>& hit, const Finish<V>& finish, const T& task) {
  const Mask<V> seen = seen_by(hit);
  return task.edges ? seen : seen & finish.reflects;
}

/// D and S of one lamp at a hit seen from the direction `eye`, where anything may be in the way.
template <Real R>
LampTerms<R> lamp_terms(const Plan<R>& plan, const Lamp<R>& lamp, const Hit<R>& hit,
                        const Vec<R>& eye) {
  const Finish<R> finish = finish_of(plan, hit);
  const Task task = task_of(plan);
  LampTerms<R> one;
  reach(plan, lamp, hit, wanted_at(hit, finish, task), task, one);
  see(plan, hit, &kEverything, task, one);
  halve(plan, hit, finish, eye, task, one);
  one.terms = answer(hit, finish, task, one);
  return one;
}

}  // namespace litmus

// light_terms.h: what one light does to one hit, first apart from all colours, and where that may
// jump.
#pragma once

#include <algorithm>
#include <array>

#include "scene/picture.h"
#include "tracer/shade.h"
#include "tracer/sum.h"
#include "tracer/suspects.h"

namespace litmus {

/// A number for each lane of a value, which need not be one that fits into a packet.
template <class T, Value V>
using PerLane = std::conditional_t<kLanes<V> == 1, T, std::array<T, std::size_t(kLanes<V>)>>;

template <class T>
T& at_lane(T& one, int) {
  return one;
}
template <class T, std::size_t N>
T& at_lane(std::array<T, N>& all, int i) {
  return all[std::size_t(i)];
}
template <class T, std::size_t N>
const T& at_lane(const std::array<T, N>& all, int i) {
  return all[std::size_t(i)];
}

/// The terms of a light summed over its lamps, and everything discrete that went into them.
template <Value V>
struct LightTerms {
  Sum<V> diffuse{}, specular{};
  Sum<V> unoccluded{};  ///< lamps with nothing in between (the sample code's reading only)
  /// Changes with visibility, side and cone membership of any lamp.
  PerLane<std::uint64_t, V> signature{};
  /// kLit, kPenumbra or kUmbra, and kHighlight (scene/picture.h).
  PerLane<std::uint8_t, V> flags{};
};

/// Mixes a small number into a signature (the finaliser of splitmix64, Steele et al. 2014).
inline std::uint64_t mix(std::uint64_t signature, std::uint64_t value) {
  std::uint64_t z = signature * 0x9e3779b97f4a7c15u + value + 1;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

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
    if (hit.one.kind != Kind::None) return of_all(plan.finishes[std::size_t(hit.one.object)]);
    Finish<V> all;
    const Mask<V> seen = hit.object >= Index<V>(0);
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
  static constexpr bool kDoubts = false;  ///< squares that over- or underflow are only noted
  bool edges, everything, sample_code;    ///< as in the plan
  Counts* counts = nullptr;
};

/// Colours by the equation, the common case: the compiler leaves out all else.
struct BareTask {
  static constexpr bool kDoubts = true;
  static constexpr bool edges = false, everything = false, sample_code = false;
  static constexpr Counts* counts = nullptr;
};

template <Real R>
Task task_of(const Plan<R>& plan, Counts* counts = nullptr) {
  return {plan.edges, plan.everything, plan.sample_code, counts};
}

/// What one lamp does to a hit.
template <Value V>
struct LampTerms {
  Incident<V> light;                      ///< weakened where the lamp is on the right side
  Mask<V> faces = false, shades = false;  ///< the geometric, the shading normal is on its side
  Mask<V> open = false;                   ///< and the surface reflects at all
  Mask<V> reached = false;                ///< and there is light, if nothing is in its way
  Mask<V> lit = false;                    ///< and nothing is
  Terms<V> terms;                         ///< not yet shared among the lamps; 0 where not lit
};

/// Weakens a lamp's light where `open` asks for it. A cosine settles most points outside of a cone.
template <Real R, Value V>
void weaken(const Lamp<R>& lamp, const Mask<V>& open, Incident<V>& light, Counts* counts) {
  const bool cull = lamp.cone && !lamp.everything;
  const Mask<V> asked = cull ? open & may_be_in_cone(lamp, light) : open;
  if (cull && none_of(asked)) {
    light.in_cone = false, light.intensity = R(0);
    return;
  }
  if (lamp.attenuated) attenuate(lamp, light);
  if (lamp.cone) narrow(lamp, light);
  if (!counts) return;
  const std::uint64_t points = std::uint64_t(count_of(asked));
  if (lamp.linear != R(0) || lamp.everything) counts->linear += points;
  if (lamp.quadratic != R(0) || lamp.everything) counts->quadratic += points;
  if (lamp.cone) counts->cones += points;
}

/// occluded(), apart from the code around it: that need not keep room for what it does in there.
template <Real R, Value V>
[[gnu::noinline]] Mask<V> hidden_from(const Plan<R>& plan, const Hit<V>& hit, Incident<V> light,
                                      Mask<V> asked, const Suspects& suspects) {
  return occluded(plan, hit, light, asked, suspects);
}

/// Where nothing stands between a hit and a lamp that reaches it.
template <Real R, Value V, class T>
Mask<V> unhidden(const Plan<R>& plan, const Hit<V>& hit, const LampTerms<V>& one,
                 const Suspects* suspects, const T& task) {
  if (!plan.shadows && !plan.idle_shadows) return one.reached;
  const Mask<V> asked = task.everything ? hit.object >= Index<V>(0) : one.reached;
  if (none_of(asked)) return one.reached;
  if (task.counts) task.counts->shadow_rays += std::uint64_t(count_of(asked));
  if (!suspects) return one.reached;
  const Mask<V> hidden = hidden_from(plan, hit, one.light, asked, *suspects);
  return plan.shadows ? one.reached & !hidden : one.reached;
}

/// Whether the light of one lamp reaches a hit, and how much of it; no terms yet. Only the suspects
/// can be in the way, if there are any. `doubt` as for direction_of().
template <Real R, Value V, class T>
LampTerms<V> reach(const Plan<R>& plan, const Lamp<R>& lamp, const Hit<V>& hit,
                   const Mask<V>& reflects, const Suspects* suspects, const T& task,
                   Doubt<V>* doubt = nullptr) {
  const Mask<V> seen = hit.object >= Index<V>(0);
  // Which side is it on? The sample code does not ask.
  LampTerms<V> result;
  Incident<V>& light = result.light;
  light = aim(lamp, hit.point, doubt);
  result.faces = dot(light.direction, hit.geometric) > R(0);
  result.shades = plan.smooth ? dot(light.direction, hit.normal) > R(0) : result.faces;
  // A surface that reflects nothing has edges all the same.
  const Mask<V> wanted = task.edges ? seen : seen & reflects;
  if (task.counts) task.counts->lamps += std::uint64_t(count_of(seen));
  result.open = task.sample_code ? wanted : wanted & result.faces & result.shades;
  if (none_of(result.open) && !task.everything) return result;
  // How much of it arrives?
  weaken(lamp, result.open, light, task.counts);
  result.reached = task.sample_code ? result.open : result.open & (light.intensity > R(0));
  result.lit = unhidden(plan, hit, result, suspects, task);
  return result;
}

/// What the surface answers to a lamp's light: D and S at a hit seen from the direction `eye`
/// (unit, towards the eye).
template <Real R, Value V, class T>
void answer(const Plan<R>& plan, const Hit<V>& hit, const Finish<V>& finish, const Vec<V>& eye,
            const T& task, LampTerms<V>& one, Doubt<V>* doubt = nullptr) {
  const Vec<V>& normal = shading_normal(plan, hit);
  const Incident<V>& light = one.light;
  const Mask<V> shiny = one.lit & finish.shiny;
  const Exponent<V>& shininess = finish.shininess;
  const bool powers = any_of(shiny) || task.everything;
  if (none_of(one.lit) && !powers) return;
  if (task.counts && powers) {
    const Mask<V> asked = task.everything ? hit.object >= Index<V>(0) : shiny;
    task.counts->powers += std::uint64_t(count_of(asked));
  }
  const Terms<V> terms =
      task.sample_code
          ? sample_code_terms(light.direction, eye, normal, shininess, light.intensity, powers)
          : equation_terms(light.direction, eye, normal, shininess, light.intensity, powers, doubt);
  one.terms = {select(one.lit, terms.diffuse, V(R(0))), select(shiny, terms.specular, V(R(0)))};
}

/// D and S of one lamp at a hit seen from the direction `eye`, where anything may be in the way.
template <Real R>
LampTerms<R> lamp_terms(const Plan<R>& plan, const Lamp<R>& lamp, const Hit<R>& hit,
                        const Vec<R>& eye) {
  const Finish<R> finish = finish_of(plan, hit);
  const Task task = task_of(plan);
  LampTerms<R> one = reach(plan, lamp, hit, finish.reflects, &kEverything, task);
  answer(plan, hit, finish, eye, task, one);
  return one;
}

/// Collects what is discrete about the lamps of one light.
template <Value V>
struct Edges {
  Mask<V> reached = false, lit = false, hidden = false, highlight = false;
  PerLane<std::uint64_t, V> signature{};

  void start(const Vec<V>& normal, const Hit<V>& hit) {
    // Near a silhouette an interpolated normal may be turned the other way than the geometric one.
    const Mask<V> turned = dot(normal, hit.geometric) < Scalar<V>(0);
    for (int i = 0; i < kLanes<V>; ++i) at_lane(signature, i) = lane(turned, i);
  }

  void add(const LampTerms<V>& one) {
    reached = reached | one.reached, lit = lit | one.lit;
    hidden = hidden | (one.reached & !one.lit);
    highlight = highlight | (one.terms.specular > one.light.intensity * Scalar<V>(0.5));
    const Mask<V> inside = one.open & one.light.in_cone;
    for (int i = 0; i < kLanes<V>; ++i) {
      const std::uint64_t bits =
          std::uint64_t(lane(one.faces, i)) | std::uint64_t(lane(one.shades, i)) << 1 |
          std::uint64_t(lane(inside, i)) << 2 | std::uint64_t(lane(one.lit, i)) << 3;
      at_lane(signature, i) = mix(at_lane(signature, i), bits);
    }
  }

  /// kLit, kPenumbra or kUmbra, and kHighlight of a lane.
  std::uint8_t flags(int i) const {
    if (!lane(reached, i)) return 0;
    const std::uint8_t shade = !lane(hidden, i) ? kLit : lane(lit, i) ? kPenumbra : kUmbra;
    return lane(highlight, i) ? shade | kHighlight : shade;
  }
};

/// light_terms() of those lamps; with the task's own care, or with `doubt` (see direction_of()).
template <std::size_t kBatch, Real R, Value V, class T>
[[gnu::noinline, gnu::flatten]] LightTerms<V> terms_of_lamps(
    const Plan<R>& plan, const Source<R>& source, const Hit<V>& hit, const Finish<V>& finish,
    const Vec<V>& eye, const Suspects* suspects, const T& task, Doubt<V>* doubt) {
  LightTerms<V> total;
  Edges<V> edges;
  if (task.edges) edges.start(shading_normal(plan, hit), hit);
  Total<V> diffuse, specular;
  Doubt<V> doubtful = false;
  Doubt<V>* const doubts = T::kDoubts ? &doubtful : nullptr;
  // Several lamps step by step: the processor works on one while it waits for another.
  const Mask<V> reflects = finish.reflects;
  const std::size_t count = source.lamps.size();
  LampTerms<V> batch[kBatch];
  for (std::size_t first = 0; first < count; first += kBatch) {
    const std::size_t length = std::min(kBatch, count - first);
    for (std::size_t k = 0; k < length; ++k)
      batch[k] = reach(plan, source.lamps[first + k], hit, reflects, suspects, task, doubts);
    for (std::size_t k = 0; k < length; ++k) answer(plan, hit, finish, eye, task, batch[k], doubts);
    for (std::size_t k = 0; k < length; ++k) {
      // The sum of one is that one, for which nothing needs to be carried along.
      if (count > 1) {
        diffuse.add(batch[k].terms.diffuse);
        specular.add(batch[k].terms.specular);
      } else {
        total.diffuse = widen(batch[k].terms.diffuse);
        total.specular = widen(batch[k].terms.specular);
      }
      if (task.sample_code) total.unoccluded += widen(select(batch[k].lit, V(R(1)), V(R(0))));
      if (task.edges) edges.add(batch[k]);
    }
  }
  if (count > 1) {
    total.diffuse = diffuse.value() * Sum<V>(source.weight);
    total.specular = specular.value() * Sum<V>(source.weight);
  }
  if (task.edges) {
    total.signature = edges.signature;
    for (int i = 0; i < kLanes<V>; ++i) at_lane(total.flags, i) = edges.flags(i);
  }
  if (T::kDoubts) *doubt = doubtful;
  return total;
}

/// D and S of one light at a hit seen from the direction `eye` (unit, towards the eye), of whose
/// lamps only those nearby can be hidden from it.
template <Real R, Value V, class T>
LightTerms<V> light_terms(const Plan<R>& plan, const Source<R>& source, const Hit<V>& hit,
                          const Finish<V>& finish, const Vec<V>& eye, const Suspects& nearby,
                          const T& task) {
  // One look at all that may be in the way pays off for several lamps.
  const bool cull = plan.shadows && !task.everything && source.lamps.size() > 3;
  Suspects found;
  if (cull) find_suspects(plan, source, hit, hit.object >= Index<V>(0), nearby, found);
  const Suspects* suspects = cull ? &found : &nearby;
  if (suspects->empty()) suspects = nullptr;
  const auto all_lamps = [&]<std::size_t kBatch>(const auto& asked, Doubt<V>& doubt) {
    return terms_of_lamps<kBatch>(plan, source, hit, finish, eye, suspects, asked, &doubt);
  };
  Doubt<V> doubt = false;
  if constexpr (T::kDoubts) {
    const LightTerms<V> terms = source.lamps.size() > 1
                                    ? all_lamps.template operator()<8>(task, doubt)
                                    : all_lamps.template operator()<1>(task, doubt);
    if (none_of(doubt & (hit.object >= Index<V>(0)))) return terms;
    return all_lamps.template operator()<1>(task_of(plan), doubt);
  } else {
    return all_lamps.template operator()<1>(task, doubt);
  }
}

/// light_terms() of the finish that is hit, where anything may be in the way.
template <Real R>
LightTerms<R> light_terms(const Plan<R>& plan, const Source<R>& source, const Hit<R>& hit,
                          const Vec<R>& eye) {
  const Finish<R> finish = finish_of(plan, hit);
  return light_terms(plan, source, hit, finish, eye, kEverything, task_of(plan));
}

/// Slide 5 for one light: kd Id D + ks Is S per channel; the sample code adds A for each lamp in
/// view and takes the light's diffuse colour for both terms.
template <Real R, Value V, class T>
Vec<Sum<V>> light_color(const Plan<R>& plan, const Source<R>& source, const Finish<V>& finish,
                        const LightTerms<V>& terms, const T& task) {
  using S = Sum<V>;
  const Vec<V>& a = finish.ambient;
  const Vec<V>& d = finish.diffuse;
  const Vec<V>& s = finish.specular;
  const Terms<S> factors{terms.diffuse, terms.specular};
  if (!plan.specular && !task.sample_code && !task.everything) {
    const auto matte = [&](const V& kd, R id) {
      return reflected_diffusely<S>(factors, widen(kd), S(id));
    };
    return {matte(d.x, source.diffuse.x), matte(d.y, source.diffuse.y),
            matte(d.z, source.diffuse.z)};
  }
  const Vec<R>& highlight = task.sample_code ? source.diffuse : source.specular;
  const auto channel = [&](const V& kd, R id, const V& ks, R is, const V& ka, R ia) {
    const S light = reflected<S>(factors, widen(kd), S(id), widen(ks), S(is));
    return task.sample_code ? S(light + terms.unoccluded * (widen(ka) * S(ia))) : light;
  };
  return {channel(d.x, source.diffuse.x, s.x, highlight.x, a.x, plan.ambient.x),
          channel(d.y, source.diffuse.y, s.y, highlight.y, a.y, plan.ambient.y),
          channel(d.z, source.diffuse.z, s.z, highlight.z, a.z, plan.ambient.z)};
}

}  // namespace litmus

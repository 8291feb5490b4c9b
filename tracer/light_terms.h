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
/// it matters at all. `doubt` as for direction_of().
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
template <Real R, Value V, class T>
bool may_shine(const Finish<V>& finish, const T& task, const LampLight<V>& one) {
  return any_of(one.lit & finish.shiny) || task.everything;
}

/// Finds the half vector's cosine at a hit seen from the direction `eye` (unit, towards the eye).
template <Real R, Value V, class T>
void halve(const Plan<R>& plan, const Hit<V>& hit, const Finish<V>& finish, const Vec<V>& eye,
           const T& task, LampLight<V>& one, Doubt<V>* doubt = nullptr) {
  if (!may_shine<R>(finish, task, one)) return;
  one.h_dot_n = highlight_cosine(one.light.direction, eye, shading_normal(plan, hit),
                                 finish.shininess, doubt);
}

/// What the surface answers to a lamp's light, D and S.
template <Real R, Value V, class T>
Terms<V> answer(const Hit<V>& hit, const Finish<V>& finish, const T& task,
                const LampLight<V>& one) {
  const bool shines = may_shine<R>(finish, task, one);
  if (task.counts && shines) {
    const Mask<V> asked = task.everything ? seen_by(hit) : one.lit & finish.shiny;
    task.counts->powers += std::uint64_t(count_of(asked));
  }
  const V intensity = select(one.lit, one.light.intensity, V(R(0)));
  V power = R(0);
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
  one.terms = answer<R>(hit, finish, task, one);
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

  void add(const LampLight<V>& one, const Terms<V>& terms) {
    reached = reached | one.reached, lit = lit | one.lit;
    hidden = hidden | (one.reached & !one.lit);
    highlight = highlight | (terms.specular > one.light.intensity * Scalar<V>(0.5));
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

/// Room for values that are written before they are read.
template <class T, std::size_t N>
union Unset {
  T all[N];
  Unset() {}
};

/// light_terms() of those lamps; with the task's own care, or with `doubt` (see direction_of()).
template <std::size_t kBatch, Real R, Value V, class T>
[[gnu::noinline, gnu::flatten]] LightTerms<V> terms_of_lamps(
    const Plan<R>& plan, const Source<R>& source, const Hit<V>& hit, const Finish<V>& finish,
    const Vec<V>& eye, const Suspects* suspects, const T& task, Mask<V>* doubt) {
  LightTerms<V> total;
  Edges<V> edges;
  if (task.edges) edges.start(shading_normal(plan, hit), hit);
  Total<V> diffuse, specular;
  Doubt<V> doubtful;
  Doubt<V>* const doubts = T::kBare ? &doubtful : nullptr;
  // Several lamps step by step: the processor works on one while it waits for another.
  const Mask<V> wanted = wanted_at(hit, finish, task);
  const std::size_t count = source.lamps.size();
  if (task.counts) task.counts->lamps += count * std::uint64_t(count_of(seen_by(hit)));
  Unset<LampLight<V>, kBatch> room;
  LampLight<V>(&batch)[kBatch] = room.all;
  for (std::size_t first = 0; first < count; first += kBatch) {
    const std::size_t length = std::min(kBatch, count - first);
    for (std::size_t k = 0; k < length; ++k)
      reach(plan, source.lamps[first + k], hit, wanted, task, batch[k], doubts);
    for (std::size_t k = 0; k < length; ++k) see(plan, hit, suspects, task, batch[k]);
    for (std::size_t k = 0; k < length; ++k) halve(plan, hit, finish, eye, task, batch[k], doubts);
    for (std::size_t k = 0; k < length; ++k) {
      const Terms<V> terms = answer<R>(hit, finish, task, batch[k]);
      // The sum of one is that one, for which nothing needs to be carried along.
      if (count > 1) {
        diffuse.add(terms.diffuse);
        specular.add(terms.specular);
      } else {
        total.diffuse = widen(terms.diffuse);
        total.specular = widen(terms.specular);
      }
      if (task.sample_code) total.unoccluded += widen(select(batch[k].lit, V(R(1)), V(R(0))));
      if (task.edges) edges.add(batch[k], terms);
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
  if (T::kBare) *doubt = doubtful.where();
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
  if (cull) find_suspects(plan, source, hit, seen_by(hit), nearby, found);
  const Suspects* suspects = cull ? &found : &nearby;
  if (suspects->empty()) suspects = nullptr;
  const auto all_lamps = [&]<std::size_t kBatch>(const auto& asked, Mask<V>& doubt) {
    return terms_of_lamps<kBatch>(plan, source, hit, finish, eye, suspects, asked, &doubt);
  };
  Mask<V> doubt = false;
  if constexpr (T::kBare) {
    const LightTerms<V> terms = source.lamps.size() > 1
                                    ? all_lamps.template operator()<8>(task, doubt)
                                    : all_lamps.template operator()<1>(task, doubt);
    if (none_of(doubt & seen_by(hit))) return terms;
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

// light_terms.h: what one light does to one hit, first apart from all colours, and where that may
// jump.
#pragma once

#include <algorithm>
#include <array>

#include "scene/picture.h"
#include "tracer/lamp_terms.h"
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

/// light_terms() of those lamps. A bare task tells by `doubt` where a square may have over- or
/// underflown, so that Task has to be asked.
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
      const Terms<V> terms = answer(hit, finish, task, batch[k]);
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

// hit.h: what a ray from the eye hits first.
#pragma once

#include "tracer/plan.h"

namespace litmus {

enum class Kind { None, Sphere, Plane, Box, Triangle };

/// A Kind, or a lane each.
template <Value V>
using KindOf = std::conditional_t<kLanes<V> == 1, Kind, Index<V>>;

template <Value V>
KindOf<V> kind_value(Kind kind) {
  if constexpr (kLanes<V> == 1) {
    return kind;
  } else {
    return Index<V>(Scalar<V>(int(kind)));
  }
}

/// One surface: `kind` and `index` name the entry of the plan's list.
struct OneSurface {
  Kind kind = Kind::None;
  int index = -1, object = -1;
};

/// The point seen. Most packets see one surface alone, or nothing: then it is named once, and not
/// `mixed`. What the lanes see is asked of the functions below; where that is nothing, the rest has
/// no meaning. (1): a packet knows that only where shadow rays are traced.
template <Value V>
struct Hit {
  bool mixed = kLanes<V> == 1;                 ///< kind, index and object are set
  OneSurface one;                              ///< what every lane sees, unless mixed
  KindOf<V> kind = kind_value<V>(Kind::None);  ///< as in OneSurface
  Index<V> index = -1, face = 0, object = -1;  ///< `face` of a box
  V t = std::numeric_limits<Scalar<V>>::infinity();
  V u{}, v{}, w{};         ///< triangles: barycentric weights
  Vec<V> point;            ///< on the surface itself, not just on the ray
  V reach{};               ///< largest coordinate that the point was computed from (1)
  Vec<V> geometric;        ///< unit normal of the surface, turned towards the eye
  Vec<V> normal;           ///< unit normal for shading, turned by itself; see shading_normal()
  Mask<V> inside = false;  ///< of a sphere or a box, seen from within (1)
};

/// Sets kind, index and object.
template <Value V>
void mix_lanes(Hit<V>& hit) {
  if (hit.mixed) return;
  hit.kind = kind_value<V>(hit.one.kind);
  hit.index = Index<V>(hit.one.index), hit.object = Index<V>(hit.one.object);
  hit.mixed = true;
}

/// Where anything is seen.
template <Value V>
Mask<V> seen_by(const Hit<V>& hit) {
  return hit.mixed ? hit.object >= Index<V>(0) : Mask<V>(hit.one.kind != Kind::None);
}

/// Where an object is seen.
template <Value V>
Mask<V> sees(const Hit<V>& hit, int object) {
  return hit.mixed ? hit.object == Index<V>(object) : Mask<V>(hit.one.object == object);
}

/// Where a surface of that kind is seen.
template <Value V>
Mask<V> sees(const Hit<V>& hit, Kind kind) {
  return hit.mixed ? hit.kind == kind_value<V>(kind) : Mask<V>(hit.one.kind == kind);
}

/// What one lane sees.
template <Value V>
OneSurface surface_at(const Hit<V>& hit, int i) {
  if constexpr (kLanes<V> == 1) {
    return {hit.kind, hit.index, hit.object};
  } else {
    if (!hit.mixed) return hit.one;
    return {Kind(int(lane(hit.kind, i))), int(lane(hit.index, i)), int(lane(hit.object, i))};
  }
}

/// Hit::normal, which a packet has only where something in the scene is smooth: elsewhere it is the
/// surface's own.
template <Real R, Value V>
const Vec<V>& shading_normal(const Plan<R>& plan, const Hit<V>& hit) {
  return plan.smooth || kLanes<V> == 1 ? hit.normal : hit.geometric;
}

}  // namespace litmus

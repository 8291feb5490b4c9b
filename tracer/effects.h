// effects.h: which parts of the model a scene calls for, and how often a picture used them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace litmus {

/// A set of effects. The renderer evaluates, traces and allocates nothing for the others.
struct Effects {
  bool ambient = false;         ///< ka Ia is not 0 everywhere
  bool diffuse = false;         ///< some kd is not 0
  bool specular = false;        ///< some ks is not 0: half vectors and powers
  bool shadows = false;         ///< something may stand between a surface and a light
  bool linear = false;          ///< some light has L > 0
  bool quadratic = false;       ///< some light has Q > 0
  bool cone = false;            ///< some light is a spot
  bool area = false;            ///< some area light has more than one sample
  bool smooth_normals = false;  ///< some mesh has normals of its own
  bool supersampling = false;   ///< a pixel is the mean of several samples
  /// Evaluates them for every lamp and surface, with values that change nothing where a lamp or a
  /// surface does not have the effect, and culls nothing: what a renderer does that never asks.
  bool everywhere = false;

  friend bool operator==(const Effects&, const Effects&) = default;
};

/// What the scene calls for: rendering with these is, bit by bit, rendering with all of them.
Effects effects_of(const Scene& scene);

/// What one of the scene's lights calls for of shadows, linear, quadratic, cone and area; the rest
/// is as for the scene.
Effects effects_of(const Scene& scene, const Light& light);

/// Every effect, everywhere.
Effects all_effects();

struct EffectName {
  std::string_view name, meaning;
  bool Effects::*member;
};

/// The effects in the order of the model.
std::span<const EffectName> effect_names();

/// How often a picture evaluated what; a lane of a packet counts where its result was asked for.
struct Counts {
  std::uint64_t camera_rays = 0, shadow_rays = 0;
  std::uint64_t lamps = 0;  ///< direction and cosine of a lamp at a point
  std::uint64_t linear = 0, quadratic = 0, cones = 0, powers = 0;

  Counts& operator+=(const Counts& other);
  friend bool operator==(const Counts&, const Counts&) = default;
};

struct CountName {
  std::string_view name;
  std::uint64_t Counts::*member;
};

std::span<const CountName> count_names();

}  // namespace litmus

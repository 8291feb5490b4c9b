// effects.cpp: reading off a scene what it calls for.
#include "tracer/effects.h"

#include <algorithm>

namespace litmus {
namespace {

constexpr EffectName kEffects[] = {
    {"ambient", "ka Ia", &Effects::ambient},
    {"diffuse", "kd Id (l.n)", &Effects::diffuse},
    {"specular", "ks Is (h.n)^ns", &Effects::specular},
    {"shadows", "rays to the lights", &Effects::shadows},
    {"linear", "linear attenuation", &Effects::linear},
    {"quadratic", "quadratic attenuation", &Effects::quadratic},
    {"cone", "angle and decay of spots", &Effects::cone},
    {"area", "grids of area lights", &Effects::area},
    {"smooth", "interpolated normals", &Effects::smooth_normals},
    {"supersampling", "several samples a pixel", &Effects::supersampling},
};

constexpr CountName kCounts[] = {
    {"camera rays", &Counts::camera_rays},
    {"lamps", &Counts::lamps},
    {"linear", &Counts::linear},
    {"quadratic", &Counts::quadratic},
    {"cones", &Counts::cones},
    {"shadow rays", &Counts::shadow_rays},
    {"powers", &Counts::powers},
};

/// A flat surface alone cannot stand between itself and a light.
bool may_shadow(const Scene& scene) {
  if (!scene.shadows || scene.objects.empty()) return false;
  const auto& shape = scene.objects.front().shape;
  return scene.objects.size() > 1 ||
         !(std::holds_alternative<Plane>(shape) || std::holds_alternative<Triangle>(shape));
}

void add_light(Effects& effects, const Scene& scene, const Light& light) {
  // To the sample code a light of intensity 0 still brings ambient light, where nothing hides it.
  if (light.intensity == 0 && scene.shading == Shading::Equation) return;
  effects.shadows |= may_shadow(scene);
  const Attenuation attenuation = attenuation_of(light);
  effects.linear |= attenuation.linear != 0;
  effects.quadratic |= attenuation.quadratic != 0;
  effects.cone |= std::holds_alternative<SpotLight>(light.shape);
  const auto* area = std::get_if<AreaLight>(&light.shape);
  effects.area |= area && area->columns * area->rows > 1;
}

/// The effects that do not depend on the lights' shapes.
Effects effects_without_lights(const Scene& scene) {
  Effects effects;
  bool ambient = scene.ambient != Color(0), lit = false;
  for (const Light& light : scene.lights) {
    lit |= light.intensity != 0;
    ambient |= light.intensity != 0 && light.ambient != Color(0);
  }
  for (const Object& object : scene.objects) {
    const Material& material = scene.materials[std::size_t(object.material)];
    effects.ambient |= ambient && material.ambient != Color(0);
    effects.diffuse |= lit && material.diffuse != Color(0);
    effects.specular |= lit && material.specular != Color(0);
    const auto* mesh = std::get_if<Mesh>(&object.shape);
    effects.smooth_normals |= mesh && !mesh->normals.empty();
  }
  effects.supersampling = scene.samples > 1;
  return effects;
}

}  // namespace

Effects effects_of(const Scene& scene) {
  Effects effects = effects_without_lights(scene);
  for (const Light& light : scene.lights) add_light(effects, scene, light);
  return effects;
}

Effects effects_of(const Scene& scene, const Light& light) {
  Effects effects = effects_without_lights(scene);
  add_light(effects, scene, light);
  return effects;
}

Effects all_effects() {
  Effects effects;
  for (const EffectName& effect : kEffects) effects.*effect.member = true;
  effects.everywhere = true;
  return effects;
}

std::span<const EffectName> effect_names() { return kEffects; }
std::span<const CountName> count_names() { return kCounts; }

Counts& Counts::operator+=(const Counts& other) {
  for (const CountName& count : kCounts) this->*count.member += other.*count.member;
  return *this;
}

}  // namespace litmus

// scene.cpp: what the kinds of light have in common.
#include "scene/scene.h"

namespace litmus {

std::string_view light_type(const Light& light) {
  static constexpr std::string_view kNames[] = {"directional", "point", "spot", "area"};
  return kNames[light.shape.index()];
}

Attenuation attenuation_of(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light.shape)) return point->attenuation;
  if (const auto* spot = std::get_if<SpotLight>(&light.shape)) return spot->point.attenuation;
  if (const auto* area = std::get_if<AreaLight>(&light.shape)) return area->point.attenuation;
  return {};
}

}  // namespace litmus

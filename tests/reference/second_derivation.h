// second_derivation.h: what second derivations of the oracles have in common.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "exporters/area_grid.h"
#include "reference/closed_form.h"
#include "scene/expect.h"
#include "scene/load.h"

namespace litmus {

inline const std::vector<Scene>& canonical() {
  static const std::vector<Scene> scenes = load_canonical_scenes().scenes;
  return scenes;
}

inline bool names(const Scene& scene, Oracle oracle) {
  return std::ranges::find(scene.expect, oracle) != scene.expect.end();
}

inline std::vector<const Scene*> naming(Oracle oracle) {
  std::vector<const Scene*> scenes;
  for (const Scene& scene : canonical())
    if (names(scene, oracle)) scenes.push_back(&scene);
  EXPECT_FALSE(scenes.empty()) << name_of(oracle);
  return scenes;
}

/// The lamps of a light in double, an area light's by the exporters' own grid.
struct PlainLamp {
  bool sun = false;
  ExactVec place{0};
};
inline std::vector<PlainLamp> plain_lamps(const Light& light) {
  if (const auto* sun = std::get_if<DirectionalLight>(&light.shape))
    return {{true, glm::normalize(-ExactVec(sun->direction))}};
  if (const auto* point = std::get_if<PointLight>(&light.shape))
    return {{false, ExactVec(point->origin)}};
  if (const auto* spot = std::get_if<SpotLight>(&light.shape))
    return {{false, ExactVec(spot->point.origin)}};
  std::vector<PlainLamp> lamps;
  for (const Point& place : area_samples(std::get<AreaLight>(light.shape)))
    lamps.push_back({false, ExactVec(place)});
  return lamps;
}

}  // namespace litmus

// controls.cpp: the table of known mistakes.
#include "reports/controls.h"

#include <algorithm>
#include <numbers>

namespace litmus {
namespace {

/// Calls change(PointLight&) for each light that has a place, and its kind's own change where one
/// is given.
template <class Change>
void for_each_placed(Scene& scene, Change change) {
  for (Light& light : scene.lights) {
    if (auto* point = std::get_if<PointLight>(&light.shape)) change(*point);
    if (auto* spot = std::get_if<SpotLight>(&light.shape)) change(spot->point);
    if (auto* area = std::get_if<AreaLight>(&light.shape)) change(area->point);
  }
}

void sharpen(Scene& scene, RenderOptions&) {
  for (Material& material : scene.materials) material.shininess *= 1.03;
}

void brighten(Scene& scene, RenderOptions&) {
  for (Light& light : scene.lights) light.intensity *= 1.01;
}

void swap_attenuation(Scene& scene, RenderOptions&) {
  for_each_placed(scene, [](PointLight& light) {
    std::swap(light.attenuation.linear, light.attenuation.quadratic);
  });
}

void widen_cone(Scene& scene, RenderOptions&) {
  for (Light& light : scene.lights) {
    if (auto* spot = std::get_if<SpotLight>(&light.shape)) {
      spot->cutoff = std::min(spot->cutoff + 0.5 * std::numbers::pi / 180, std::numbers::pi);
    }
  }
}

void swap_placement(Scene& scene, RenderOptions&) {
  for (Light& light : scene.lights) {
    if (auto* area = std::get_if<AreaLight>(&light.shape)) {
      area->placement =
          area->placement == Placement::Centres ? Placement::Corners : Placement::Centres;
    }
  }
}

void shift_camera(Scene&, RenderOptions& options) { options.shift_x = 0.5; }

void move_light(Scene& scene, RenderOptions&) {
  for_each_placed(scene, [](PointLight& light) { light.origin.x += 0.01; });
}

constexpr Control kControls[] = {
    {"shininess", "every shininess 3 % too high", sharpen},
    {"intensity", "every light 1 % too bright", brighten},
    {"attenuation", "linear and quadratic attenuation swapped", swap_attenuation},
    {"cutoff", "every spot's cutoff 0.5 degrees too wide", widen_cone},
    {"placement", "area samples at the corners for those at the centres, and the reverse",
     swap_placement},
    {"half-pixel", "the camera half a pixel to the right", shift_camera},
    {"light-moved", "every light that has a place 0.01 units along x", move_light},
};

}  // namespace

std::span<const Control> controls() { return kControls; }

const Control* find_control(std::string_view name) {
  const auto found = std::find_if(std::begin(kControls), std::end(kControls),
                                  [&](const Control& control) { return control.name == name; });
  return found == std::end(kControls) ? nullptr : &*found;
}

}  // namespace litmus

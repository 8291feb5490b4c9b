// controls.cpp: the table of known mistakes.
#include "reports/controls.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/bands.h"
#include "scene/overload.h"
#include "tracer/explain.h"

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

// ---- Misreadings of the slides ---------------------------------------------------------------

void halve_cone(Scene& scene, RenderOptions&) {
  for (Light& light : scene.lights)
    if (auto* spot = std::get_if<SpotLight>(&light.shape)) spot->cutoff /= 2;
}

void repeat_ambient(Scene& scene, RenderOptions&) {
  const double times = std::max<double>(1, double(scene.lights.size()));
  scene.ambient *= times;
  for (Light& light : scene.lights) light.ambient *= times;
}

void swap_colors(Scene& scene, RenderOptions&) {
  for (Light& light : scene.lights) std::swap(light.diffuse, light.specular);
}

/// The image of a shape in the lamp, shrunk so much that it is in no other light's way: from a
/// surface, the line to the lamp passes through it exactly where, prolonged, it meets the shape.
decltype(Object::shape) behind(const decltype(Object::shape)& shape, const Point& lamp) {
  constexpr double kShrunk = 1e-3;
  const auto image = [&](const Point& p) { return lamp - (p - lamp) * kShrunk; };
  return std::visit(Overload{[&](const Sphere& s) -> decltype(Object::shape) {
                               return Sphere{image(s.center), s.radius * kShrunk};
                             },
                             [&](const Box& b) -> decltype(Object::shape) {
                               return Box{image(b.max), image(b.min)};
                             },
                             [&](const Triangle& t) -> decltype(Object::shape) {
                               return Triangle{image(t.a), image(t.b), image(t.c)};
                             },
                             [&](const Mesh& m) -> decltype(Object::shape) {
                               Mesh mirrored{{}, {}, m.triangles};
                               for (const Point& vertex : m.vertices)
                                 mirrored.vertices.push_back(image(vertex));
                               return mirrored;
                             },
                             [&](const Plane& p) -> decltype(Object::shape) {
                               return Plane{image(p.point), p.normal};
                             }},
                    shape);
}

/// Planes are left out: the image of a floor in a lamp above it would be a ceiling for other lamps.
void look_behind_lights(Scene& scene, RenderOptions&) {
  std::vector<Object> images;
  for (const Light& light : scene.lights) {
    const auto* point = std::get_if<PointLight>(&light.shape);
    const auto* spot = std::get_if<SpotLight>(&light.shape);
    if (!point && !spot) continue;
    const Point lamp = point ? point->origin : spot->point.origin;
    for (const Object& object : scene.objects)
      if (!std::holds_alternative<Plane>(object.shape))
        images.push_back({object.name + " behind " + light.name, behind(object.shape, lamp),
                          object.material, false});
  }
  scene.objects.insert(scene.objects.end(), images.begin(), images.end());
}

/// What (r.v)^ns would add to a light's layer in place of (h.n)^ns, with r the mirrored l.
double mirrored_excess(const LightExplanation& light, const Explanation& pixel) {
  double excess = 0;
  for (const LampExplanation& lamp : light.lamps) {
    if (lamp.gate != Gate::Open) continue;
    const glm::dvec3 r = 2 * lamp.l_dot_n * pixel.normal - lamp.l;
    const double cosine = std::max(0.0, glm::dot(r, pixel.e));
    excess += lamp.visibility * lamp.intensity * std::pow(cosine, pixel.material.shininess) -
              lamp.specular;
  }
  return excess * light.weight;
}

void use_mirrored_ray(const Scene& scene, Layers& layers) {
  const auto shiny = [](const Material& material) { return material.specular != Color(0); };
  if (scene.samples > 1 || std::none_of(scene.materials.begin(), scene.materials.end(), shiny))
    return;
  const Explainer at = explainer(scene);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const Explanation pixel = at(x, y);
      if (!pixel.hit || !shiny(pixel.material)) continue;
      for (std::size_t k = 0; k < pixel.lights.size(); ++k) {
        layers[k + 1].picture.at(x, y) += pixel.material.specular * pixel.lights[k].light_specular *
                                          mirrored_excess(pixel.lights[k], pixel);
      }
    }
}

void leave_alone(Scene&, RenderOptions&) {}

constexpr Control kControls[] = {
    {"shininess", "every shininess 3 % too high", sharpen},
    {"intensity", "every light 1 % too bright", brighten},
    {"attenuation", "linear and quadratic attenuation swapped", swap_attenuation},
    {"cutoff", "every spot's cutoff 0.5 degrees too wide", widen_cone},
    {"placement", "area samples at the corners for those at the centres, and the reverse",
     swap_placement},
    {"half-pixel", "the camera half a pixel to the right", shift_camera},
    {"light-moved", "every light that has a place 0.01 units along x", move_light},
    {"full-angle", "every spot's cutoff read as the cone's full angle", halve_cone},
    {"ambient-per-light", "ambient light added once for each light", repeat_ambient},
    {"colors", "every light's diffuse and specular colour swapped", swap_colors},
    {"mirrored-ray", "highlights by (r.v)^ns for (h.n)^ns", leave_alone, use_mirrored_ray},
    {"behind-the-light", "what is behind a point or spot light casts shadows, too",
     look_behind_lights},
};

}  // namespace

std::span<const Control> controls() { return kControls; }

const Control* find_control(std::string_view name) {
  const auto found = std::find_if(std::begin(kControls), std::end(kControls),
                                  [&](const Control& control) { return control.name == name; });
  return found == std::end(kControls) ? nullptr : &*found;
}

BandRendering render_with(const Control* control, Scene& scene, RenderOptions& options) {
  if (control) control->apply(scene, options);
  BandRendering bands = render_bands(scene, options, KeepBands::Layers);
  if (!control || !control->alter) return bands;
  Rendering& rendering = bands.rendering;
  if (scene.spectra) {
    const std::vector<Scene> threes = band_scenes(scene);
    for (std::size_t p = 0; p < threes.size(); ++p) control->alter(threes[p], bands.pictures[p]);
    rendering.layers = srgb_layers(*scene.spectra, bands.pictures);
  } else {
    control->alter(scene, rendering.layers);
  }
  rendering.whole = sum(rendering.layers);
  return bands;
}

}  // namespace litmus

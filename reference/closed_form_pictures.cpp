// closed_form_pictures.cpp: colours on surfaces, shells and darkness.
#include "reference/closed_form_pictures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "reference/closed_form_surfaces.h"
#include "scene/bands.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

glm::dvec3 rounded(const ExactVec& v) { return {double(v.x), double(v.y), double(v.z)}; }

/// Sets pixel `index` of every layer to what slide 5 makes of the terms, in one set of colours.
void paint(const Scene& scene, const PixelTerms& terms, std::size_t index,
           std::vector<ExpectedLayer>& layers) {
  const Material& material = scene.materials[std::size_t(terms.object->material)];
  ExactVec ambient(scene.ambient);
  for (const Light& light : scene.lights)
    ambient += Exact(light.intensity) * ExactVec(light.ambient);
  layers[0].picture.pixels[index] = rounded(ExactVec(material.ambient) * ambient);
  layers[0].known[index] = 1;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const Light& light = scene.lights[k];
    const ExactVec lit =
        ExactVec(material.diffuse) * ExactVec(light.diffuse) * terms.lights[k].diffuse +
        ExactVec(material.specular) * ExactVec(light.specular) * terms.lights[k].specular;
    layers[k + 1].picture.pixels[index] = rounded(Exact(light.intensity) * lit);
    layers[k + 1].known[index] = terms.lights[k].sure;
  }
}

void paint(const PixelTerms& terms, std::size_t index, Canvas& canvas) {
  if (terms.sees == PixelTerms::Sees::Unknown) return;
  for (std::size_t p = 0; p < canvas.pictures.size(); ++p) {
    if (terms.sees == PixelTerms::Sees::Surface)
      paint(canvas.colors[p], terms, index, canvas.pictures[p]);
    else
      for (ExpectedLayer& layer : canvas.pictures[p]) layer.known[index] = 1;
  }
}

bool no_ambient(const Scene& scene) {
  return scene.ambient == Color(0) &&
         std::all_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
           return light.intensity * light.ambient == Color(0);
         });
}

}  // namespace

Canvas canvas_of(const Scene& scene) {
  Canvas canvas;
  canvas.colors = scene.spectra ? band_scenes(scene) : std::vector<Scene>{scene};
  const ExpectedLayer unknown{
      Picture(scene.width, scene.height),
      std::vector<std::uint8_t>(std::size_t(scene.width) * std::size_t(scene.height))};
  canvas.pictures.assign(canvas.colors.size(),
                         std::vector<ExpectedLayer>(1 + scene.lights.size(), unknown));
  return canvas;
}

void expect_surfaces(const Scene& scene, std::span<const Oracle> oracles, Canvas& canvas) {
  const SurfaceOracle surfaces(scene, oracles);
  tbb::parallel_for(0, scene.height, [&](int y) {
    for (int x = 0; x < scene.width; ++x)
      paint(surfaces.at(x, y), std::size_t(y) * std::size_t(scene.width) + std::size_t(x), canvas);
  });
}

void expect_shell(const Scene& scene, Canvas& canvas) {
  const auto* sphere =
      scene.objects.size() == 1 ? std::get_if<Sphere>(&scene.objects[0].shape) : nullptr;
  if (!sphere || glm::distance(scene.camera.eye, sphere->center) >= sphere->radius ||
      scene.materials[std::size_t(scene.objects[0].material)].specular != Color(0))
    throw Refusal(scene.name + ": expect: \"shell\" needs one matte sphere around the eye");
  // Seen from the centre, any point of the shell will do.
  const ExactVec out(0, 0, 1);
  const SeenPoint seen{ExactVec(sphere->center) + Exact(sphere->radius) * out, -out, -out,
                       &scene.objects[0]};
  PixelTerms terms{PixelTerms::Sees::Surface, seen.object, {}};
  for (const ExactLight& light : exact_lights(scene)) {
    for (const ExactLamp& lamp : light.lamps)
      if (lamp.sun || lamp.cone || lamp.place != ExactVec(sphere->center))
        throw Refusal(scene.name + ": expect: \"shell\" needs its lights at the sphere's centre");
    terms.lights.push_back(
        terms_at(seen, light, scene.materials[std::size_t(seen.object->material)]));
  }
  const std::size_t pixels = std::size_t(scene.width) * std::size_t(scene.height);
  for (std::size_t index = 0; index < pixels; ++index) paint(terms, index, canvas);
}

void expect_darkness(Canvas& canvas) {
  for (std::size_t p = 0; p < canvas.pictures.size(); ++p)
    for (std::size_t k = 0; k < canvas.pictures[p].size(); ++k)
      if (std::vector<std::uint8_t>& known = canvas.pictures[p][k].known;
          k > 0 || no_ambient(canvas.colors[p]))
        std::fill(known.begin(), known.end(), 1);
}

}  // namespace litmus

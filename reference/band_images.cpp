// band_images.cpp: a spectral scene's references, three bands a picture.
#include "reference/band_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scene/bands.h"

namespace litmus {
namespace {

std::string layer_name(const Scene& scene, const std::string& light, std::size_t picture) {
  return fmt::format("{} {}", light, band_range(*scene.spectra, int(picture)));
}

Layers lights_of(const Scene& scene) {
  Layers layers{{"ambient", "ambient", {}}};
  for (const Light& light : scene.lights)
    layers.push_back({light.name, std::string(light_type(light)), {}});
  return layers;
}

/// Takes a part of a scene over into the whole.
void add(ObtainedReference& whole, ObtainedReference& part, const Scene& scene,
         std::size_t picture) {
  whole.seconds += part.seconds;
  whole.rendered_now |= part.rendered_now;
  whole.version = part.version;
  if (whole.command.empty()) whole.command = part.command;
  if (!whole.failure.empty() || !whole.skipped.empty()) return;
  whole.failure = part.failure, whole.skipped = part.skipped, whole.log = part.log;
  whole.source = part.source;
  if (part.source.empty()) whole.layers.clear();
  for (Layer& layer : part.layers) {
    layer.light = layer_name(scene, layer.light, picture);
    whole.layers.push_back(std::move(layer));
  }
}

}  // namespace

Layers expected_layers(const Scene& scene) {
  const Layers lights = lights_of(scene);
  if (!scene.spectra) return lights;
  Layers layers;
  for (int picture = 0; picture < band_pictures(*scene.spectra); ++picture)
    for (Layer layer : lights) {
      layer.light = layer_name(scene, layer.light, std::size_t(picture));
      layers.push_back(std::move(layer));
    }
  return layers;
}

std::vector<Scene> renderable(std::span<const Scene> scenes) {
  std::vector<Scene> all;
  for (const Scene& scene : scenes) {
    if (!scene.spectra) {
      all.push_back(scene);
      continue;
    }
    for (Scene& three : band_scenes(scene)) all.push_back(std::move(three));
  }
  return all;
}

std::vector<ObtainedReference> gathered(std::span<const Scene> scenes,
                                        std::vector<ObtainedReference> parts) {
  std::vector<ObtainedReference> results;
  std::size_t next = 0;
  for (const Scene& scene : scenes) {
    if (!scene.spectra) {
      results.push_back(std::move(parts.at(next++)));
      continue;
    }
    ObtainedReference whole;
    whole.scene = scene.name;
    whole.reference = parts.at(next).reference;
    for (int picture = 0; picture < band_pictures(*scene.spectra); ++picture)
      add(whole, parts.at(next++), scene, std::size_t(picture));
    results.push_back(std::move(whole));
  }
  return results;
}

std::vector<Layers> band_layers(const Scene& scene, const Layers& layers) {
  const Layers lights = lights_of(scene);
  const std::size_t pictures = std::size_t(band_pictures(*scene.spectra));
  if (layers.size() != pictures * lights.size())
    throw std::invalid_argument(fmt::format("{} layers of bands where there must be {}",
                                            layers.size(), pictures * lights.size()));
  std::vector<Layers> bands(pictures, lights);
  for (std::size_t i = 0; i < layers.size(); ++i)
    bands[i / lights.size()][i % lights.size()].picture = layers[i].picture;
  return bands;
}

Layers colors_of(const Scene& scene, const Layers& layers) {
  return scene.spectra ? srgb_layers(*scene.spectra, band_layers(scene, layers)) : layers;
}

}  // namespace litmus

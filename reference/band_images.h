// band_images.h: what renderers of red, green and blue make of the wavelength bands of a scene.
#pragma once

#include <span>
#include <vector>

#include "reference/obtain.h"

namespace litmus {

/// The layers that a reference of this scene has, without pixels: "ambient", then each light in
/// order. Of a spectral scene those of all its band scenes (scene/bands.h), one after another,
/// the band range behind each light's name, so that no two are alike.
Layers expected_layers(const Scene& scene);

/// What a renderer can render: the scenes, with each spectral one replaced by its band scenes.
std::vector<Scene> renderable(std::span<const Scene> scenes);

/// One result per scene from those of renderable(scenes): layers one after another, seconds added
/// up; the first failure or refusal counts.
std::vector<ObtainedReference> gathered(std::span<const Scene> scenes,
                                        std::vector<ObtainedReference> parts);

/// The layers of a spectral scene as its band scenes have them, out of expected_layers' order.
std::vector<Layers> band_layers(const Scene& scene, const Layers& layers);

/// The layers in linear RGB: of a spectral scene what the observer sees, else as they are.
Layers colors_of(const Scene& scene, const Layers& layers);

}  // namespace litmus

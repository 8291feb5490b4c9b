// band_answers.h: what a surface answers to a light in each wavelength band.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// Three bands a picture; those beyond the last band, which fill up the last picture, are 0.
using ThreeBands = std::vector<glm::dvec3>;

/// What an object and a layer give per band for each unit of D, of S and of lamps in view, and what
/// the observer sees of that, in linear sRGB. Of the ambient layer `in_view` is all there is.
struct BandAnswer {
  ThreeBands diffuse, specular, in_view;
  glm::dmat3 colors{0};  ///< one column each
};

/// The answers of all objects of a spectral scene, layer by layer: object * layers + layer, where
/// layer 0 is ambient and the others are the lights.
std::vector<BandAnswer> band_answers(const Scene& scene);

/// Leaves the ambient layer black, for whoever asks for a picture without that effect.
void leave_out_ambient(std::vector<BandAnswer>& answers, std::size_t layers);

}  // namespace litmus

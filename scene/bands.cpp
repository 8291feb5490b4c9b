// bands.cpp: three bands for r, g and b, and XYZ from them.
#include "scene/bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <stdexcept>

#include "scene/observer.h"

namespace litmus {

int band_pictures(const Spectra& spectra) { return (spectra.bands + 2) / 3; }

Color three_bands(const std::vector<double>& bands, int picture) {
  Color color(0);
  for (int c = 0; c < 3; ++c)
    if (const std::size_t band = std::size_t(3 * picture + c); band < bands.size())
      color[c] = bands[band];
  return color;
}

std::string band_range(const Spectra& spectra, int picture) {
  const double width = (kLastWavelength - kFirstWavelength) / spectra.bands;
  const int end = std::min(3 * picture + 3, spectra.bands);
  return fmt::format("{:.4g}-{:.4g} nm", kFirstWavelength + 3 * picture * width,
                     kFirstWavelength + end * width);
}

std::vector<double> band_centres(const Spectra& spectra) {
  std::vector<double> centres;
  for (int b = 0; b < spectra.bands; ++b)
    centres.push_back(kFirstWavelength +
                      (b + 0.5) * (kLastWavelength - kFirstWavelength) / spectra.bands);
  return centres;
}

std::vector<Scene> band_scenes(const Scene& scene) {
  const Spectra& spectra = *scene.spectra;
  Scene plain = scene;
  plain.spectra.reset();
  std::vector<Scene> scenes;
  for (int picture = 0; picture < band_pictures(spectra); ++picture) {
    Scene one = plain;
    one.name = fmt::format("{}-{:02}", scene.name, picture);
    one.ambient = three_bands(spectra.ambient, picture);
    const auto paint = [&](auto& target, const BandColors& colors) {
      target.ambient = three_bands(colors.ambient, picture);
      target.diffuse = three_bands(colors.diffuse, picture);
      target.specular = three_bands(colors.specular, picture);
    };
    for (std::size_t i = 0; i < one.materials.size(); ++i)
      paint(one.materials[i], spectra.materials[i]);
    for (std::size_t i = 0; i < one.lights.size(); ++i) paint(one.lights[i], spectra.lights[i]);
    scenes.push_back(std::move(one));
  }
  return scenes;
}

void add_xyz(const Spectra& spectra, int picture, const Picture& three, Picture& xyz) {
  glm::dmat3 of_channels(0);
  for (int c = 0; c < 3; ++c)
    if (const std::size_t band = std::size_t(3 * picture + c); band < spectra.xyz.size())
      of_channels[c] = spectra.xyz[band];
  for (std::size_t i = 0; i < xyz.pixels.size(); ++i)
    xyz.pixels[i] += of_channels * three.pixels[i];
}

Layers srgb_layers(const Spectra& spectra, std::span<const Layers> pictures) {
  if (int(pictures.size()) != band_pictures(spectra))
    throw std::invalid_argument(fmt::format("{} pictures of bands where there must be {}",
                                            pictures.size(), band_pictures(spectra)));
  Layers layers = pictures.front();
  for (std::size_t k = 0; k < layers.size(); ++k) {
    Picture& colors = layers[k].picture;
    colors = Picture(colors.width, colors.height);
    for (std::size_t p = 0; p < pictures.size(); ++p) {
      if (pictures[p].size() != layers.size() ||
          pictures[p][k].picture.pixels.size() != colors.pixels.size())
        throw std::invalid_argument("pictures of bands have different layers");
      add_xyz(spectra, int(p), pictures[p][k].picture, colors);
    }
    for (glm::dvec3& pixel : colors.pixels) pixel = linear_srgb(pixel);
  }
  return layers;
}

}  // namespace litmus

// bands.h: a spectral scene as RGB scenes of three wavelength bands each, and the way back to
// colours.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

/// RGB pictures that hold the bands of a spectral scene, 3 each: (bands + 2) / 3. The last one's
/// channels beyond the last band are 0.
int band_pictures(const Spectra& spectra);

/// Three neighbouring bands of a colour as r, g, b; `picture` counts from 0.
Color three_bands(const std::vector<double>& bands, int picture);

/// "580-610 nm": what a picture's channels cover.
std::string band_range(const Spectra& spectra, int picture);

/// The middle wavelength of each band, nm.
std::vector<double> band_centres(const Spectra& spectra);

/// A spectral scene as RGB scenes, each with three neighbouring bands for its r, g and b. They
/// differ in colours alone; their names are the scene's with the band range behind it.
std::vector<Scene> band_scenes(const Scene& scene);

/// Adds what one picture of three bands shows to a picture of XYZ (both of one size).
void add_xyz(const Spectra& spectra, int picture, const Picture& three_bands, Picture& xyz);

/// The layers of a spectral scene in linear sRGB, from those of its band scenes, in order. Throws
/// std::invalid_argument unless there are band_pictures of them with equal layers.
Layers srgb_layers(const Spectra& spectra, std::span<const Layers> pictures);

}  // namespace litmus

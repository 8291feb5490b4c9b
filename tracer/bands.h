// bands.h: a spectral scene, traced once for all wavelengths (slides 2-5).
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "tracer/render.h"

namespace litmus {

/// What is kept of the bands besides the colours made of them.
enum class KeepBands { None, Layers };

struct BandRendering {
  Rendering rendering;  ///< in linear sRGB (scene/observer.h)
  /// As scene/bands.h describes: for every three bands the layers.
  std::vector<Layers> pictures;
  /// Products of a light's term and a colour, per pixel: of each band if bands are kept, and of the
  /// three of the picture, in which the bands' colours have been added up before.
  std::int64_t products = 0;
};

/// Renders a scene per wavelength band. Where light goes does not depend on the wavelength: D and S
/// of each light and the object seen are rendered once, by render(), as the colours of a scene made
/// for it, and the bands are multiply-adds. The XYZ of the bands, added up per object and light,
/// make linear sRGB. A scene without spectra is rendered as it is, with no products.
BandRendering render_bands(const Scene& scene, const RenderOptions& options = {},
                           KeepBands keep = KeepBands::None);

/// Takes some rows of a picture per wavelength, from row `first` on: of each pixel R, G and B, then
/// every band, in single precision.
using BandRows = std::function<void(int first, std::span<const float> values)>;

/// Renders the same, with the bands of the whole picture handed over in order, a few rows at a
/// time: memory that is new costs more time than what is written into it. `pictures` stays empty,
/// `seconds` does not count what `take` does. Throws std::invalid_argument for a scene without
/// spectra.
BandRendering render_band_rows(const Scene& scene, const RenderOptions& options,
                               const BandRows& take);

/// As probe(), of a spectral scene, in linear sRGB.
Probe probe_bands(const Scene& scene, const RenderOptions& options = {});

}  // namespace litmus

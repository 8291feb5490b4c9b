// band_rows.h: a spectral scene in the study: compared band by band, shown in its colours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/study.h"
#include "tracer/bands.h"
#include "tracer/render.h"

namespace litmus {

/// Our side of a spectral scene, three bands a picture.
struct BandSide {
  Spectra spectra;
  std::vector<Layers> pictures;
  std::vector<Probe> probes;  ///< one per picture
};

/// Takes over the pictures of render_bands(..., KeepBands::Layers); nothing for a scene without
/// spectra.
std::optional<BandSide> band_side(const Scene& scene, const RenderOptions& options,
                                  BandRendering& rendering);

/// compare_layer() for each picture of three bands; of each region the row of the worst picture:
/// one that fails, then the one with the largest difference. `bands` says which. `layer` gives the
/// edges and flags, `index` the layer (the one behind the last light is the whole), `theirs` has
/// the pictures of band_layers (reference/band_images.h).
std::vector<Comparison> compare_bands(const CaseLayer& layer, std::size_t index,
                                      const BandSide& ours, const std::vector<Layers>& theirs,
                                      const std::string& reference);

}  // namespace litmus

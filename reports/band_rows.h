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

/// The layer of a picture of three bands; behind the last one the whole.
Picture band_layer(const Layers& three, std::size_t index);

/// Keeps of each row that of the worst bands so far: one that fails, then the one with the largest
/// difference. Both have the same regions, those of the edges and flags; `worst` may be empty yet.
void keep_worst(std::vector<Comparison>& worst, std::vector<Comparison> rows);

/// compare_layer() for each picture of three bands; of each region the row of the worst picture,
/// which `bands` names. `layer` gives the edges and flags, `index` the layer (the one behind the
/// last light is the whole), `theirs` has the pictures of band_layers (reference/band_images.h).
std::vector<Comparison> compare_bands(const CaseLayer& layer, std::size_t index,
                                      const BandSide& ours, const std::vector<Layers>& theirs,
                                      const std::string& reference);

}  // namespace litmus

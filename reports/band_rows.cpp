// band_rows.cpp: rows of the worst three of a spectral scene's bands.
#include "reports/band_rows.h"

#include <tuple>

#include "reports/rows.h"
#include "scene/bands.h"

namespace litmus {
namespace {

bool worse(const Comparison& a, const Comparison& b) {
  const auto rank = [](const Comparison& row) {
    return std::tuple(row.verdict == "fail", row.nonfinite, row.max_abs);
  };
  return rank(a) > rank(b);
}

}  // namespace

Picture band_layer(const Layers& three, std::size_t index) {
  return index < three.size() ? three[index].picture : sum(three);
}

void keep_worst(std::vector<Comparison>& worst, std::vector<Comparison> rows) {
  if (worst.empty()) worst = rows;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (worse(rows[i], worst[i])) worst[i] = std::move(rows[i]);
}

std::optional<BandSide> band_side(const Scene& scene, const RenderOptions& options,
                                  BandRendering& rendering) {
  if (!scene.spectra) return std::nullopt;
  BandSide side{*scene.spectra, std::move(rendering.pictures), {}};
  for (const Scene& three : band_scenes(scene)) side.probes.push_back(probe(three, options));
  return side;
}

std::vector<Comparison> compare_bands(const CaseLayer& layer, std::size_t index,
                                      const BandSide& ours, const std::vector<Layers>& theirs,
                                      const std::string& reference) {
  std::vector<Comparison> worst;
  for (std::size_t p = 0; p < ours.pictures.size(); ++p) {
    CaseLayer three{
        layer.light, layer.light_type, band_layer(ours.pictures[p], index), layer.edge, {},
        {},          layer.flags};
    std::vector<Comparison> rows =
        compare_layer(three, index, band_layer(theirs[p], index), reference, ours.probes[p]);
    for (Comparison& row : rows) row.bands = band_range(ours.spectra, int(p));
    keep_worst(worst, std::move(rows));
  }
  return worst;
}

}  // namespace litmus

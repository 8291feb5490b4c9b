// compare_scene.cpp: from the pictures of one scene to its rows.
#include "reports/compare_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/regions.h"
#include "compare/tolerances.h"
#include "reference/band_images.h"
#include "reference/closed_form.h"
#include "reports/alignment.h"
#include "reports/band_rows.h"
#include "reports/blame.h"
#include "reports/closed_form_rows.h"
#include "reports/plain_text.h"
#include "reports/rows.h"
#include "reports/suspects.h"
#include "reports/triage_rows.h"

namespace litmus {
namespace {

/// The layers, and as the last one their whole.
std::vector<CaseLayer> own_layers(Rendering rendering) {
  std::vector<CaseLayer> layers;
  std::vector<std::uint8_t> any(rendering.whole.pixels.size());
  for (std::size_t k = 0; k < rendering.layers.size(); ++k) {
    Layer& layer = rendering.layers[k];
    std::vector<std::uint8_t> edge = edge_mask(rendering.signatures[k]);
    for (std::size_t i = 0; i < edge.size(); ++i) any[i] |= edge[i];
    layers.push_back({layer.light,
                      layer.light_type,
                      std::move(layer.picture),
                      std::move(edge),
                      {},
                      {},
                      std::move(rendering.flags[k])});
  }
  layers.push_back({"all", "all", std::move(rendering.whole), std::move(any), {}, {}});
  return layers;
}

/// Our side of a comparison, and the means to look again.
struct OurSide {
  const Scene& scene;
  const RenderOptions& options;
  Probe probe;
  const BandSide* bands = nullptr;  ///< of a spectral scene
};

/// One sigma of what an encoding's rounding does to the sum of some layers.
double noise_of(const Encoding& encoding, std::size_t layers) {
  return half_step(0.5, encoding) / std::sqrt(3.0) * std::sqrt(double(layers));
}

/// A row that stands for a layer with nothing to compare with.
Comparison empty_row(const ObtainedReference& reference) {
  Comparison row;
  row.region = "all";
  row.verdict = reference.failure.empty() ? "skipped" : "fail";
  row.reason = reference.failure.empty() ? reference.skipped : reference.failure;
  return row;
}

void add_reason(std::vector<Comparison>& rows, const std::string& note) {
  if (note.empty()) return;
  for (Comparison& row : rows) row.reason += (row.reason.empty() ? "" : "; ") + note;
}

/// Of a spectral scene: with the layers in linear sRGB in place of those per band.
ObtainedReference in_colors(const Scene& scene, ObtainedReference reference) {
  reference.layers = colors_of(scene, reference.layers);
  return reference;
}

void compare_with(Case& entry, const ObtainedReference& reference, const OurSide& side,
                  std::vector<Comparison>& comparisons, const ExtraSource* extra = nullptr) {
  entry.references.push_back({reference.reference, reference.source, reference.version,
                              reference.command, reference.seconds, reference.failure,
                              reference.log});
  const Encoding encoding = extra ? extra->encoding : Encoding{};
  const bool spectral = side.bands && !reference.source.empty();
  const std::vector<Layers> bands =
      spectral ? band_layers(side.scene, reference.layers) : std::vector<Layers>{};
  const ObtainedReference colors =
      spectral ? in_colors(side.scene, reference) : ObtainedReference{};
  const ObtainedReference& shown = spectral ? colors : reference;
  if (spectral) entry.references.back().bands = reference.layers;
  const std::string tolerances_of = extra ? kToleranceOfCandidates : reference.reference;
  const std::size_t first_row = comparisons.size();
  for (std::size_t k = 0; k < entry.layers.size(); ++k) {
    CaseLayer& layer = entry.layers[k];
    std::vector<Comparison> rows;
    if (reference.source.empty()) {
      rows.push_back(empty_row(reference));
      layer.theirs.push_back({reference.reference, "", {}});
    } else {
      const Picture theirs = theirs_beyond_rounding(layer.ours, shown, k, encoding);
      rows = spectral ? compare_bands(layer, k, *side.bands, bands, tolerances_of)
                      : compare_layer(layer, k, theirs, tolerances_of, side.probe);
      add_reason(rows, rounding_note(reference, k, encoding));
      layer.theirs.push_back({reference.reference, reference.source, theirs});
    }
    for (Comparison& row : rows) {
      row.scene = entry.scene, row.reference = reference.reference, row.source = reference.source;
      row.light = layer.light, row.light_type = layer.light_type;
      comparisons.push_back(std::move(row));
    }
  }
  if (reference.source.empty()) return;
  Registration& registration = entry.references.back().registration;
  registration = align(side.scene, side.options, entry, sum(shown.layers),
                       noise_of(encoding, reference.layers.size()));
  blame_the_camera(std::span(comparisons).subspan(first_row), registration);
}

/// Each layer of a source against that of each reference, for information.
void compare_with_references(const Case& entry, const ObtainedReference& images,
                             const ExtraSource& extra, std::size_t references, const Probe& probe,
                             std::vector<Comparison>& rows) {
  if (images.source.empty()) return;
  for (std::size_t k = 0; k < entry.layers.size(); ++k) {
    const CaseLayer& layer = entry.layers[k];
    for (std::size_t r = 0; r < references; ++r) {
      const CaseLayer::Theirs& reference = layer.theirs[r];
      if (reference.source.empty()) continue;
      const CaseLayer between{layer.light, layer.light_type, reference.picture, layer.edge, {}, {}};
      const Picture theirs = theirs_beyond_rounding(reference.picture, images, k, extra.encoding);
      for (Comparison& row : compare_layer(between, k, theirs, kToleranceOfCandidates, probe)) {
        row.scene = entry.scene, row.reference = extra.name, row.source = images.source;
        row.light = layer.light, row.light_type = layer.light_type;
        row.against = reference.reference;
        rows.push_back(std::move(row));
      }
    }
  }
}

/// A candidate or native export: judged rows go to the comparisons, pictures to the other ones.
void compare_with_extra(Case& entry, const ExtraSource& extra, std::size_t scene,
                        std::size_t references, const OurSide& side, Study& study) {
  const ObtainedReference& images = extra.results[scene];
  compare_with(entry, images, side, extra.judged ? study.comparisons : study.informative, &extra);
  if (!extra.native && !side.bands)
    compare_with_references(entry, images, extra, references, side.probe, study.informative);
  if (extra.judged) return;
  for (CaseLayer& layer : entry.layers) {
    layer.aside.push_back(std::move(layer.theirs.back()));
    layer.theirs.pop_back();
  }
}

bool wants_closed_forms(const std::vector<std::string>& names) {
  return names.empty() || std::find(names.begin(), names.end(), kClosedForm) != names.end();
}

Case case_of(RenderedScene& ours, const std::string& control) {
  const Scene& scene = ours.scene;
  Rendering& rendering = ours.bands.rendering;
  Case entry{scene.name,
             nearby(scene.file),
             scene.about,
             scene.tags,
             scene.warnings,
             scene.width,
             scene.height,
             rendering.seconds,
             {},
             own_layers(std::move(rendering))};
  entry.control = control;
  return entry;
}

}  // namespace

Study compare_scene(const Scene& scene, RenderedScene ours, const SceneSources& sources,
                    const StudyOptions& options) {
  const std::optional<BandSide> bands = band_side(ours.scene, ours.options, ours.bands);
  Study study;
  study.cases.push_back(case_of(ours, options.control));
  Case& entry = study.cases.back();
  const OurSide side{ours.scene, ours.options, probe(ours.scene, ours.options),
                     bands ? &*bands : nullptr};
  for (const ObtainedReference& reference : sources.references)
    compare_with(entry, reference, side, study.comparisons);
  if (wants_closed_forms(options.references))
    compare_with_closed_form(scene, entry, side.bands, study);
  compare_references(entry, study);
  for (const ExtraSource& extra : sources.extras)
    compare_with_extra(entry, extra, sources.index, sources.references.size(), side, study);
  name_suspects(study);
  add_triage(study);
  add_blame(study, {&scene, 1});
  return study;
}

}  // namespace litmus

// study.cpp: walks from scenes through pictures and differences to verdicts. It computes nothing
// itself.
#include "reports/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "compare/difference.h"
#include "compare/regions.h"
#include "compare/verdict.h"
#include "reports/boundary.h"
#include "reports/controls.h"
#include "reports/provenance.h"
#include "reports/triage_rows.h"
#include "scene/refusal.h"
#include "tracer/render.h"

namespace litmus {
namespace {

constexpr std::size_t kListedPixels = 50;  // causes per row
constexpr int kUnknownCauses = 5;  // after that many, a row is a failure and needs no more words

std::vector<const Driver*> chosen_drivers(const std::vector<std::string>& names) {
  std::vector<const Driver*> chosen;
  for (const Driver& driver : drivers()) {
    if (names.empty() || std::find(names.begin(), names.end(), driver.name) != names.end()) {
      chosen.push_back(&driver);
    }
  }
  for (const std::string& name : names) {
    if (!find_driver(name))
      throw Refusal(fmt::format("reference \"{}\": there are povray and blender", name));
  }
  return chosen;
}

/// One row of results per scene for each driver, all drivers at the same time.
std::vector<std::vector<ObtainedReference>> obtain_all(std::span<const Scene> scenes,
                                                       std::span<const Driver* const> drivers,
                                                       const ObtainOptions& options) {
  std::vector<std::future<std::vector<ObtainedReference>>> running;
  for (const Driver* driver : drivers) {
    running.push_back(
        std::async(std::launch::async, [=] { return obtain(scenes, *driver, options); }));
  }
  std::vector<std::vector<ObtainedReference>> results;
  for (auto& each : running) results.push_back(each.get());
  return results;
}

/// The layers, and as the last one their whole.
std::vector<CaseLayer> own_layers(Rendering rendering) {
  std::vector<CaseLayer> layers;
  std::vector<std::uint8_t> any(rendering.whole.pixels.size());
  for (std::size_t k = 0; k < rendering.layers.size(); ++k) {
    Layer& layer = rendering.layers[k];
    std::vector<std::uint8_t> edge = edge_mask(rendering.signatures[k]);
    for (std::size_t i = 0; i < edge.size(); ++i) any[i] |= edge[i];
    layers.push_back(
        {layer.light, layer.light_type, std::move(layer.picture), std::move(edge), {}});
  }
  layers.push_back({"all", "all", std::move(rendering.whole), std::move(any), {}});
  return layers;
}

Comparison row_of(const Difference& d, Region region, const Tolerance& tolerance) {
  Comparison row;
  row.region = name_of(region);
  row.pixels = d.pixels, row.nonfinite = d.nonfinite, row.over_tolerance = d.over_tolerance;
  row.bias = d.bias, row.mean_abs = d.mean_abs, row.max_abs = d.max_abs, row.max_at = d.max_at;
  row.rmse = d.rmse, row.p50 = d.p50, row.p95 = d.p95, row.p99 = d.p99, row.p999 = d.p999;
  row.max_relative = d.max_relative;
  row.tolerance = tolerance.max_abs, row.mean_tolerance = tolerance.mean_abs;
  return row;
}

std::string cause_of(const Difference::Pixel& pixel, std::optional<double> distance) {
  return distance ? fmt::format(
                        "({}, {}) differs by {:.3g}: a boundary passes within {:.1g} px of the "
                        "pixel's centre, and there our value is theirs",
                        pixel.x, pixel.y, pixel.max_abs, *distance)
                  : fmt::format("({}, {}) differs by {:.3g}: no boundary within {} px explains it",
                                pixel.x, pixel.y, pixel.max_abs, kBoundaryPixels);
}

/// Names the cause of each edge pixel over the tolerance, and counts those with a known one.
void explain(Comparison& row, const Difference& d, const Probe& probe, std::size_t layer,
             const Picture& theirs) {
  int unknown = 0;
  for (const Difference::Pixel& pixel : d.over) {
    if (row.causes.size() == kListedPixels || unknown == kUnknownCauses) break;
    const auto distance = boundary_distance(probe, pixel.x, pixel.y, layer,
                                            theirs.at(pixel.x, pixel.y), row.tolerance);
    distance ? ++row.explained : ++unknown;
    row.causes.push_back(cause_of(pixel, distance));
  }
}

/// Three rows: interior, edge and all, each with its verdict.
std::vector<Comparison> compare_layer(const CaseLayer& layer, std::size_t index,
                                      const Picture& theirs, const std::string& reference,
                                      const Probe& probe) {
  const Tolerance inside = find_tolerance(reference, Region::Interior);
  const Tolerance border = find_tolerance(reference, Region::Edge);
  const auto measure = [&](Region region, const Tolerance& tolerance) {
    return difference(layer.ours, theirs, layer.edge, region, tolerance.max_abs);
  };
  const Difference interior = measure(Region::Interior, inside),
                   edge = measure(Region::Edge, border);
  std::vector<Comparison> rows{row_of(interior, Region::Interior, inside),
                               row_of(edge, Region::Edge, border),
                               row_of(measure(Region::All, border), Region::All, border)};
  explain(rows[1], edge, probe, index, theirs);
  rows[2].explained = rows[1].explained;
  const Verdict first = judge(interior, inside), second = judge(edge, border, rows[1].explained);
  const Verdict verdicts[] = {first, second, combine(first, second)};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].verdict = verdicts[i].pass ? "pass" : "fail";
    rows[i].reason = verdicts[i].reason;
  }
  return rows;
}

/// A row that stands for a layer with nothing to compare with.
Comparison empty_row(const ObtainedReference& reference) {
  Comparison row;
  row.region = "all";
  row.verdict = reference.failure.empty() ? "skipped" : "fail";
  row.reason = reference.failure.empty() ? reference.skipped : reference.failure;
  return row;
}

void compare_with(Case& entry, const ObtainedReference& reference, const Probe& probe,
                  std::vector<Comparison>& comparisons) {
  entry.references.push_back({reference.reference, reference.source, reference.version,
                              reference.command, reference.seconds, reference.failure,
                              reference.log});
  const Picture whole = sum(reference.layers);
  for (std::size_t k = 0; k < entry.layers.size(); ++k) {
    CaseLayer& layer = entry.layers[k];
    std::vector<Comparison> rows;
    if (reference.source.empty()) {
      rows.push_back(empty_row(reference));
      layer.theirs.push_back({reference.reference, "", {}});
    } else {
      const Picture& theirs = k < reference.layers.size() ? reference.layers[k].picture : whole;
      rows = compare_layer(layer, k, theirs, reference.reference, probe);
      layer.theirs.push_back({reference.reference, reference.source, theirs});
    }
    for (Comparison& row : rows) {
      row.scene = entry.scene, row.reference = reference.reference, row.source = reference.source;
      row.light = layer.light, row.light_type = layer.light_type;
      comparisons.push_back(std::move(row));
    }
  }
}

}  // namespace

Study run_study(std::span<const Scene> scenes, const StudyOptions& options) {
  const std::vector<const Driver*> drivers = chosen_drivers(options.references);
  const Control* control = options.control.empty() ? nullptr : find_control(options.control);
  if (!options.control.empty() && !control) {
    throw Refusal(
        fmt::format("--control: there is no \"{}\"; see litmus run --help", options.control));
  }
  const auto obtained = obtain_all(scenes, drivers, options.obtain);
  Study study;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    Scene ours = scenes[i];
    RenderOptions render_options;
    render_options.threads = options.threads;
    if (control) control->apply(ours, render_options);
    Rendering rendering = render(ours, render_options);

    Case entry{ours.name,
               ours.file.string(),
               ours.about,
               ours.tags,
               ours.warnings,
               ours.width,
               ours.height,
               rendering.seconds,
               {},
               own_layers(std::move(rendering))};
    const Probe around = probe(ours, render_options);
    for (const auto& references : obtained)
      compare_with(entry, references[i], around, study.comparisons);
    study.cases.push_back(std::move(entry));
  }
  add_triage(study);
  study.provenance = provenance_of(drivers);
  return study;
}

std::string overall_verdict(const Study& study) {
  const auto any = [&](std::string_view verdict) {
    return std::any_of(study.comparisons.begin(), study.comparisons.end(),
                       [&](const Comparison& row) { return row.verdict == verdict; });
  };
  for (const Case& entry : study.cases) {
    for (const CaseReference& reference : entry.references) {
      if (!reference.failure.empty()) return "broken";
    }
  }
  if (any("fail")) return "fail";
  return any("skipped") || study.comparisons.empty() ? "incomplete" : "pass";
}

}  // namespace litmus

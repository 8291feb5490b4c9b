// migration.cpp: finds what another version of a renderer changed, and puts figures on it.
#include "reports/migration.h"

#include <algorithm>
#include <array>

#include "compare/difference.h"
#include "compare/verdict.h"
#include "reference/band_images.h"
#include "reference/stored_images.h"
#include "reports/overview.h"

namespace litmus {
namespace {

/// By the gates for interior and edge; causes of edge pixels are not looked for.
std::string verdict_on(const CaseLayer& layer, const Picture& theirs,
                       const std::string& reference) {
  std::array<RegionVerdict, 2> verdicts{RegionVerdict{Region::Interior, {}},
                                        RegionVerdict{Region::Edge, {}}};
  for (RegionVerdict& one : verdicts) {
    const Tolerance tolerance = find_tolerance(reference, one.region);
    one.verdict =
        judge(difference(layer.ours, theirs, layer.edge, one.region, tolerance.max_abs), tolerance);
  }
  return combine(verdicts).pass ? "pass" : "fail";
}

MigrationLayer side_by_side(const Study& study, const Case& one, const CaseLayer& layer,
                            const CaseLayer::Theirs& now, const Picture& before) {
  MigrationLayer result{layer.light, layer.light_type, before, now.picture};
  result.allowed = find_tolerance(now.reference, Region::Interior).max_abs;
  const Difference was = difference(layer.ours, before, layer.edge, Region::All, 0);
  const Difference is = difference(layer.ours, now.picture, layer.edge, Region::All, 0);
  result.old_max = was.max_abs, result.old_mean = was.mean_abs;
  result.new_max = is.max_abs, result.new_mean = is.mean_abs;
  result.apart = difference(before, now.picture, layer.edge, Region::All, 0).max_abs;
  result.old_verdict = verdict_on(layer, before, now.reference);
  const Comparison* row = find_row(study, one.scene, layer.light, now.reference, "all");
  result.new_verdict = row ? row->verdict : "";
  return result;
}

/// The live picture beside the stored one, of each layer.
std::vector<MigrationLayer> beside_stored(const Study& study, const Case& one,
                                          const std::string& reference, Layers stored) {
  stored.push_back({"all", "all", sum(stored)});
  std::vector<MigrationLayer> layers;
  for (std::size_t k = 0; k < std::min(one.layers.size(), stored.size()); ++k)
    for (const CaseLayer::Theirs& theirs : one.layers[k].theirs)
      if (theirs.reference == reference && theirs.picture.width == stored[k].picture.width)
        layers.push_back(side_by_side(study, one, one.layers[k], theirs, stored[k].picture));
  return layers;
}

/// The figures now beside the baseline's.
std::vector<MigrationLayer> beside_baseline(const Study& study, const Case& one,
                                            const std::string& reference, const Study& baseline) {
  std::vector<MigrationLayer> layers;
  for (const CaseLayer& layer : one.layers) {
    const Comparison* now = find_row(study, one.scene, layer.light, reference, "all");
    const Comparison* was = find_row(baseline, one.scene, layer.light, reference, "all");
    if (!now || !was) continue;
    MigrationLayer result{layer.light, layer.light_type, {}, {}};
    result.allowed = now->tolerance;
    result.old_max = was->max_abs, result.old_mean = was->mean_abs;
    result.new_max = now->max_abs, result.new_mean = now->mean_abs;
    result.old_verdict = was->verdict, result.new_verdict = now->verdict;
    layers.push_back(std::move(result));
  }
  return layers;
}

std::string version_in(const Study& study, const std::string& scene, const std::string& reference) {
  for (const Case& one : study.cases)
    if (one.scene == scene)
      for (const CaseReference& each : one.references)
        if (each.reference == reference) return each.version;
  return "";
}

}  // namespace

std::vector<Migration> migrations(const Study& study, std::span<const Scene> scenes,
                                  const Study* baseline, const std::filesystem::path& images) {
  std::vector<Migration> found;
  for (std::size_t i = 0; i < std::min(scenes.size(), study.cases.size()); ++i) {
    const Case& one = study.cases[i];
    for (const CaseReference& now : one.references) {
      if (now.source.empty() || find_driver(now.reference) == nullptr) continue;
      Migration migration{one.scene, now.reference, "", now.version};
      if (now.source == "live") {
        migration.old_version = stored_version(scenes[i], now.reference, images);
        if (!migration.old_version.empty() && migration.old_version != now.version)
          if (StoredLookup stored = load_stored(scenes[i], now.reference, images); stored.images)
            migration.layers =
                beside_stored(study, one, now.reference, colors_of(scenes[i], stored.images->layers));
      }
      if (migration.layers.empty() && baseline) {
        migration.old_version = version_in(*baseline, one.scene, now.reference);
        migration.pictures = false;
        if (!migration.old_version.empty() && migration.old_version != now.version)
          migration.layers = beside_baseline(study, one, now.reference, *baseline);
      }
      if (!migration.layers.empty()) found.push_back(std::move(migration));
    }
  }
  return found;
}

}  // namespace litmus

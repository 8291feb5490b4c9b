// blame.cpp: asks quad precision about the pixels that differ most.
#include "reports/blame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <numbers>
#include <optional>

#include "compare/regions.h"
#include "reference/drivers.h"
#include "reports/boundary.h"
#include "reports/plain_text.h"
#include "tracer/exact_probe.h"

namespace litmus {
namespace {

constexpr std::size_t kWitnesses = 6;  // per row
constexpr int kPlacesAround = 8;

/// The largest difference of a channel; not a number if any is.
double distance_between(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = glm::abs(a - b);
  return std::isnan(d.x + d.y + d.z) ? std::nan("") : std::max({d.x, d.y, d.z});
}

/// A scene's pixels in quad precision, each computed once, at its centre and around it.
class Truth {
 public:
  explicit Truth(const Scene& scene) : scene_(scene) {}

  /// The centre first, then kPlacesAround places within kBoundaryPixels; of a layer, or of all.
  std::vector<glm::dvec3> around(int x, int y, std::size_t layer) {
    const auto [place, is_new] = seen_.try_emplace({x, y});
    if (is_new) {
      if (!probe_) probe_ = exact_probe(scene_);
      place->second.push_back(probe_(x + 0.5, y + 0.5));
      for (int i = 0; i < kPlacesAround; ++i) {
        const double angle = 2 * std::numbers::pi * i / kPlacesAround;
        place->second.push_back(probe_(x + 0.5 + kBoundaryPixels * std::cos(angle),
                                       y + 0.5 + kBoundaryPixels * std::sin(angle)));
      }
    }
    std::vector<glm::dvec3> values;
    for (const std::vector<glm::dvec3>& colors : place->second) {
      glm::dvec3 value{0};
      for (std::size_t k = 0; k < colors.size(); ++k)
        if (layer == k || layer >= colors.size()) value += colors[k];
      values.push_back(value);
    }
    return values;
  }

 private:
  const Scene& scene_;
  Probe probe_;
  std::map<std::pair<int, int>, std::vector<std::vector<glm::dvec3>>> seen_;
};

/// The pixels over the tolerance in a row's region, worst first.
std::vector<Difference::Pixel> differing(const CaseLayer& layer, const Picture& theirs,
                                         const Comparison& row) {
  for (const Region region : {Region::Interior, Region::Edge, Region::All})
    if (row.region == name_of(region))
      return difference(layer.ours, theirs, layer.edge, region, row.tolerance).over;
  for (const Region region : kLightRegions) {
    if (row.region != name_of(region) || layer.flags.empty()) continue;
    const auto members = region_mask(layer.flags, layer.edge, region);
    return difference(layer.ours, theirs, members, row.tolerance).over;
  }
  return {};
}

Witness witness_of(const CaseLayer& layer, const Picture& theirs, Truth& truth,
                   std::size_t layer_index, const Difference::Pixel& pixel, double tolerance) {
  const std::vector<glm::dvec3> values = truth.around(pixel.x, pixel.y, layer_index);
  Witness witness{layer.ours.at(pixel.x, pixel.y), theirs.at(pixel.x, pixel.y), values[0], false};
  // A jump next to the pixel's centre that leads to both values: neither is wrong.
  const auto shown = [&](const glm::dvec3& value) {
    return std::any_of(values.begin(), values.end(), [&](const glm::dvec3& one) {
      return distance_between(one, value) <= tolerance;
    });
  };
  witness.ill_conditioned = shown(witness.ours) && shown(witness.theirs);
  return witness;
}

void add_blame(Comparison& row, const Case& entry, Truth& truth) {
  for (std::size_t k = 0; k < entry.layers.size(); ++k) {
    const CaseLayer& layer = entry.layers[k];
    if (layer.light != row.light) continue;
    for (const CaseLayer::Theirs& theirs : layer.theirs) {
      if (theirs.reference != row.reference || !same_size(theirs.picture, layer.ours)) continue;
      std::vector<Witness> witnesses;
      for (const Difference::Pixel& pixel : differing(layer, theirs.picture, row)) {
        if (witnesses.size() == kWitnesses) break;
        witnesses.push_back(witness_of(layer, theirs.picture, truth, k, pixel, row.tolerance));
      }
      if (!witnesses.empty()) row.blame = judge_witnesses(witnesses);
    }
  }
}

}  // namespace

Blame judge_witnesses(std::span<const Witness> witnesses) {
  Blame blame;
  for (const Witness& witness : witnesses) {
    ++blame.pixels;
    if (witness.ill_conditioned) {
      ++blame.ill_conditioned;
      continue;
    }
    const double ours = distance_between(witness.ours, witness.truth);
    const double theirs = distance_between(witness.theirs, witness.truth);
    // Written so that a value that is not a number is its owner's error.
    ++(ours <= theirs || std::isnan(theirs) ? blame.theirs : blame.ours);
    if (std::isfinite(ours)) blame.our_error = std::max(blame.our_error, ours);
    if (std::isfinite(theirs)) blame.their_error = std::max(blame.their_error, theirs);
  }
  blame.verdict = blame.ours == 0 && blame.theirs == 0 ? "ill-conditioned"
                  : blame.ours >= blame.theirs         ? "ours"
                                                       : "the reference's";
  return blame;
}

void add_blame(Study& study, std::span<const Scene> scenes) {
  for (std::size_t i = 0; i < study.cases.size() && i < scenes.size(); ++i) {
    // The figures of a spectral scene's rows are of bands; the truth is of colours.
    if (scenes[i].spectra) continue;
    Truth truth(scenes[i]);
    for (Comparison& row : study.comparisons)
      if (row.scene == study.cases[i].scene && row.verdict == "fail" && row.over_tolerance > 0 &&
          find_driver(row.reference))
        add_blame(row, study.cases[i], truth);
  }
}

std::string blame_sentence(const Blame& blame, const std::string& reference_title) {
  const std::string pixels = counted(blame.pixels, "pixel", "pixels");
  if (blame.verdict == "ill-conditioned")
    return fmt::format("ill-conditioned: in {}, quad precision shows both values within {} px",
                       pixels, kBoundaryPixels);
  const bool ours = blame.verdict == "ours";
  return fmt::format(
      "{}: in {} of {}, quad precision is nearer to {} (ours is off by {}, theirs by {})",
      ours ? "ours" : reference_title + "'s", ours ? blame.ours : blame.theirs, pixels,
      ours ? reference_title + "'s value" : "ours", short_number(blame.our_error),
      short_number(blame.their_error));
}

}  // namespace litmus

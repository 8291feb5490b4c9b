// closed_form_rows.cpp: pictures, claims and figures of closed forms, as rows with verdicts.
#include "reports/closed_form_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/difference.h"
#include "compare/fit.h"
#include "compare/regions.h"
#include "compare/verdict.h"
#include "reference/closed_form.h"
#include "reports/band_rows.h"
#include "reports/rows.h"
#include "reports/suspects.h"
#include "scene/bands.h"
#include "scene/expect.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

using PixelMask = std::vector<std::uint8_t>;

/// The pixels of a region, whether known or not.
PixelMask members_of(const CaseLayer& layer, Region region) {
  PixelMask members = layer.edge;
  if (region == Region::Edge) return members;
  if (region == Region::Interior) {
    for (std::uint8_t& member : members) member = !member;
    return members;
  }
  if (region == Region::All || layer.flags.empty())
    return PixelMask(members.size(), region == Region::All);
  return region_mask(layer.flags, layer.edge, region);
}

void restrict(PixelMask& members, const PixelMask& known) {
  for (std::size_t i = 0; i < members.size(); ++i) members[i] &= known[i];
}

bool any(const PixelMask& members) {
  return std::find(members.begin(), members.end(), 1) != members.end();
}

/// What the pixels without a closed form may not be asked about.
PixelMask edge_or_unknown(const CaseLayer& layer, const PixelMask& known) {
  PixelMask mask = layer.edge;
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] |= !known[i];
  return mask;
}

/// The rows of one layer's pixels in our picture of it; none where nothing is known.
std::vector<Comparison> pixel_rows(const CaseLayer& layer, const Picture& ours,
                                   const ExpectedLayer& expected) {
  std::vector<Comparison> rows;
  std::vector<RegionVerdict> verdicts;
  for (const Region region : {Region::Interior, Region::Lit, Region::Penumbra, Region::Umbra,
                              Region::Highlight, Region::Edge, Region::All}) {
    PixelMask members = members_of(layer, region);
    restrict(members, expected.known);
    const Tolerance tolerance = find_tolerance(kClosedForm, region);
    const Difference d = difference(ours, expected.picture, members, tolerance.max_abs);
    if (d.pixels == 0) continue;
    const Verdict verdict = region == Region::All ? combine(verdicts) : judge(d, tolerance);
    Comparison& row = rows.emplace_back(row_of(d, name_of(region), tolerance));
    row.verdict = verdict.pass ? "pass" : "fail";
    row.reason = verdict.reason;
    if (region != Region::All) verdicts.push_back({region, verdict});
  }
  const bool fails = !rows.empty() && rows.back().verdict == "fail";
  const std::string hint =
      fails ? explain_units(ours, expected.picture, edge_or_unknown(layer, expected.known)) : "";
  for (Comparison& row : rows)
    if (row.verdict == "fail") row.hint = hint;
  return rows;
}

/// The sum of the layers, known where all of them are.
ExpectedLayer whole_of(const std::vector<ExpectedLayer>& layers) {
  ExpectedLayer whole = layers.front();
  for (std::size_t k = 1; k < layers.size(); ++k)
    for (std::size_t i = 0; i < whole.known.size(); ++i) {
      whole.known[i] &= layers[k].known[i];
      whole.picture.pixels[i] += layers[k].picture.pixels[i];
    }
  return whole;
}

/// Those of a spectral scene: of each region the row of the worst three bands.
std::vector<Comparison> band_pixel_rows(const CaseLayer& layer, std::size_t index,
                                        const BandSide& ours, const ClosedForm& known) {
  std::vector<Comparison> worst;
  for (std::size_t p = 0; p < known.bands.size(); ++p) {
    std::vector<Comparison> rows =
        pixel_rows(layer, band_layer(ours.pictures[p], index), known.bands[p][index]);
    for (Comparison& row : rows) row.bands = band_range(ours.spectra, int(p));
    keep_worst(worst, std::move(rows));
  }
  return worst;
}

Comparison claim_row(const Claim& claim, const Picture& ours) {
  Comparison row;
  row.region = name_of(claim.oracle);
  for (int y = 0; y < ours.height; ++y)
    for (int x = 0; x < ours.width; ++x) {
      const std::optional<bool> holds = claim.holds(x, y, ours.at(x, y));
      if (!holds) continue;
      ++row.pixels;
      if (*holds) continue;
      if (row.over_tolerance++ == 0) row.max_at = {x, y};
    }
  const bool pass = row.pixels > 0 && row.over_tolerance == 0;
  row.verdict = pass ? "pass" : "fail";
  if (row.pixels == 0)
    row.reason = "the closed form says nothing of any pixel, so nothing was compared";
  else if (!pass)
    row.reason =
        fmt::format("{} of {} pixels are not as the closed form says, the first is ({}, {})",
                    row.over_tolerance, row.pixels, row.max_at[0], row.max_at[1]);
  return row;
}

Comparison figure_row(const Figure& figure, const Picture& ours) {
  Comparison row;
  row.region = name_of(figure.oracle);
  row.pixels = std::int64_t(ours.pixels.size());
  row.tolerance = row.mean_tolerance = figure.tolerance;
  const double measured = figure.measure(ours);
  const bool finite = std::isfinite(measured);
  row.nonfinite = !finite;
  row.max_abs = row.mean_abs = finite ? std::fabs(measured - figure.exact) : 0;
  row.bias = finite ? measured - figure.exact : 0;
  row.verdict = finite && row.max_abs <= row.tolerance ? "pass" : "fail";
  row.reason =
      fmt::format("{:.6g} measured, {:.6g} exact ({})", measured, figure.exact, figure.unit);
  return row;
}

/// Gives a row its names and files it.
void add(Study& study, const Case& entry, const CaseLayer& layer, Comparison row) {
  row.scene = entry.scene, row.reference = kClosedForm;
  row.source = row.verdict == "skipped" ? "" : "computed";
  row.light = layer.light, row.light_type = layer.light_type;
  study.comparisons.push_back(std::move(row));
}

void add_skipped(Study& study, const Case& entry, const std::string& reason) {
  for (const CaseLayer& layer : entry.layers) {
    Comparison row;
    row.region = "all", row.verdict = "skipped", row.reason = reason;
    add(study, entry, layer, std::move(row));
  }
}

}  // namespace

void compare_with_closed_form(const Scene& scene, Case& entry, const BandSide* bands,
                              Study& study) {
  if (scene.expect.empty()) return;
  ClosedForm known;
  try {
    known = closed_form(scene);
  } catch (const Refusal& wrong) {
    return add_skipped(study, entry, wrong.what());
  }
  if (!known.layers.empty()) known.layers.push_back(whole_of(known.layers));
  for (std::vector<ExpectedLayer>& three : known.bands) three.push_back(whole_of(three));
  for (std::size_t k = 0; k < entry.layers.size(); ++k) {
    CaseLayer& layer = entry.layers[k];
    if (!known.layers.empty()) {
      for (Comparison& row : bands ? band_pixel_rows(layer, k, *bands, known)
                                   : pixel_rows(layer, layer.ours, known.layers[k]))
        add(study, entry, layer, std::move(row));
      compare_pairs(entry, layer, {kClosedForm, "computed", known.layers[k].picture},
                    edge_or_unknown(layer, known.layers[k].known), study.pairs);
      if (any(known.layers[k].known)) layer.exact = std::move(known.layers[k]);
    }
    for (const Claim& claim : known.claims)
      if (claim.layer == k) add(study, entry, layer, claim_row(claim, layer.ours));
    for (const Figure& figure : known.figures)
      if (figure.layer == k) add(study, entry, layer, figure_row(figure, layer.ours));
  }
}

}  // namespace litmus

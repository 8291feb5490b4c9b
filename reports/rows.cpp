// rows.cpp: differences, causes and verdicts of one layer, region by region.
#include "reports/rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/difference.h"
#include "compare/fit.h"
#include "compare/regions.h"
#include "compare/verdict.h"
#include "reports/boundary.h"

namespace litmus {
namespace {

constexpr std::size_t kListedPixels = 50;  // causes per row
constexpr int kUnknownCauses = 5;  // after that many, a row is a failure and needs no more words

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

void set_verdict(Comparison& row, const Verdict& verdict) {
  row.verdict = verdict.pass ? "pass" : "fail";
  row.reason = verdict.reason;
}

/// Collects rows and their verdicts.
struct Judged {
  std::vector<Comparison> rows;
  std::vector<RegionVerdict> verdicts;

  void add(const Difference& d, Region region, const Tolerance& tolerance) {
    rows.push_back(row_of(d, name_of(region), tolerance));
    conclude(region, judge(d, tolerance));
  }
  void conclude(Region region, Verdict verdict) {
    set_verdict(rows.back(), verdict);
    verdicts.push_back({region, std::move(verdict)});
  }
};

void add_light_regions(Judged& judged, const CaseLayer& layer, const Picture& theirs,
                       const std::string& reference) {
  if (layer.flags.empty() || layer.light == "ambient" || layer.light == "all") return;
  for (const Region region : kLightRegions) {
    const std::vector<std::uint8_t> members = region_mask(layer.flags, layer.edge, region);
    const Tolerance tolerance = find_tolerance(reference, region);
    const Difference d = difference(layer.ours, theirs, members, tolerance.max_abs);
    if (d.pixels > 0) judged.add(d, region, tolerance);
  }
}

}  // namespace

Comparison row_of(const Difference& d, std::string_view region, const Tolerance& tolerance) {
  Comparison row;
  row.region = region;
  row.pixels = d.pixels, row.nonfinite = d.nonfinite, row.over_tolerance = d.over_tolerance;
  row.bias = d.bias, row.mean_abs = d.mean_abs, row.max_abs = d.max_abs, row.max_at = d.max_at;
  row.rmse = d.rmse, row.p50 = d.p50, row.p95 = d.p95, row.p99 = d.p99, row.p999 = d.p999;
  row.max_relative = d.max_relative;
  row.tolerance = tolerance.max_abs, row.mean_tolerance = tolerance.mean_abs;
  return row;
}

std::vector<Comparison> compare_layer(const CaseLayer& layer, std::size_t layer_index,
                                      const Picture& theirs, const std::string& reference,
                                      const Probe& probe) {
  const Tolerance inside = find_tolerance(reference, Region::Interior);
  const Tolerance border = find_tolerance(reference, Region::Edge);
  const auto measure = [&](Region region, const Tolerance& tolerance) {
    return difference(layer.ours, theirs, layer.edge, region, tolerance.max_abs);
  };
  Judged judged;
  judged.add(measure(Region::Interior, inside), Region::Interior, inside);
  add_light_regions(judged, layer, theirs, reference);

  const Difference edge = measure(Region::Edge, border);
  Comparison& edge_row = judged.rows.emplace_back(row_of(edge, name_of(Region::Edge), border));
  explain(edge_row, edge, probe, layer_index, theirs);
  const std::int64_t explained = edge_row.explained;
  judged.conclude(Region::Edge, judge(edge, border, explained));

  Comparison& all =
      judged.rows.emplace_back(row_of(measure(Region::All, border), name_of(Region::All), border));
  all.explained = explained;
  set_verdict(all, combine(judged.verdicts));
  if (all.verdict == "pass") return std::move(judged.rows);
  const std::string hint = explain_units(layer.ours, theirs, layer.edge);
  for (Comparison& row : judged.rows)
    if (row.verdict == "fail") row.hint = hint;
  return std::move(judged.rows);
}

}  // namespace litmus

// sample_study.h: a small study by hand, with each kind of row, for the tests of the writers.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "compare/difference.h"
#include "compare/verdict.h"
#include "reports/study.h"

namespace litmus {

inline constexpr const char* kHostile = "<img src=x onerror=alert(1)>\"'&{{x}}|`\x1b[31m";

/// A lit ball before a floor.
inline Picture ball(int width, int height, double radius, double gain) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (2 * x + 1.0 - width) / height, v = (height - 2 * y - 1.0) / height;
      const double z2 = radius * radius - u * u - v * v;
      const double lit = z2 > 0 ? std::max(0.0, 0.4 * u + 0.5 * v + 0.77 * std::sqrt(z2)) / radius
                                : 0.25 + 0.1 * v;
      picture.at(x, y) = gain * lit * (z2 > 0 ? glm::dvec3(0.9, 0.55, 0.3) : glm::dvec3(1));
    }
  return picture;
}

/// 1 beside the ball's outline.
inline std::vector<std::uint8_t> outline(int width, int height, double radius) {
  std::vector<std::uint8_t> edge;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (2 * x + 1.0 - width) / height, v = (height - 2 * y - 1.0) / height;
      edge.push_back(std::abs(std::hypot(u, v) - radius) < 3.0 / height);
    }
  return edge;
}

/// The picture with an error that varies from pixel to pixel; `on_edge` more on edges.
inline Picture disturbed(const Picture& picture, const std::vector<std::uint8_t>& edge,
                         double inside, double on_edge) {
  Picture result = picture;
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    const double wave = std::sin(0.37 * double(i % std::size_t(picture.width)) + 0.011 * double(i));
    result.pixels[i] += wave * (edge[i] ? on_edge : inside);
  }
  return result;
}

/// Adds the rows of a layer against one of its references, as a study would.
inline void add_rows(Study& study, const Case& one, const CaseLayer& layer,
                     const CaseLayer::Theirs& theirs) {
  Verdict verdicts[2];
  for (const Region region : {Region::Interior, Region::Edge, Region::All}) {
    const Tolerance tolerance = find_tolerance(theirs.reference, region);
    const Difference d =
        difference(layer.ours, theirs.picture, layer.edge, region, tolerance.max_abs);
    Comparison row;
    for (std::size_t i = 0; i < kMetrics<Difference>.size(); ++i)
      row.*kMetrics<Comparison>[i].member = d.*kMetrics<Difference>[i].member;
    row.scene = one.scene;
    row.reference = theirs.reference;
    row.source = theirs.source;
    row.light = layer.light;
    row.light_type = layer.light_type;
    row.region = name_of(region);
    row.pixels = d.pixels;
    row.nonfinite = d.nonfinite;
    row.max_at = d.max_at;
    row.over_tolerance = d.over_tolerance;
    row.tolerance = tolerance.max_abs;
    row.mean_tolerance = tolerance.mean_abs;
    const Verdict verdict =
        region == Region::All ? combine(verdicts[0], verdicts[1]) : judge(d, tolerance);
    if (region != Region::All) verdicts[region == Region::Edge] = verdict;
    row.verdict = verdict.pass ? "pass" : "fail";
    row.reason = verdict.reason;
    if (region == Region::Edge)
      for (const Difference::Pixel& pixel : d.over)
        row.causes.push_back("(" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) +
                             ") lies on a boundary");
    study.comparisons.push_back(row);
  }
}

struct SampleCase {
  std::string scene, light, light_type;
  double povray = 1.2e-7, blender = 6e-7;  ///< errors inside
  bool blender_skipped = false, nan = false;
};

/// One scene of ambient, one light and "all", with all its rows.
inline void add_case(Study& study, const SampleCase& sample, int width = 64, int height = 48) {
  Case one;
  one.scene = sample.scene;
  one.file = "scene/canonical/" + sample.scene + ".toml";
  one.about = "A ball before a floor: what one " + sample.light_type + " light does to it.";
  one.tags = {sample.light_type, "sphere"};
  one.width = width;
  one.height = height;
  one.seconds = 0.012;
  const std::string blender = sample.blender_skipped ? "" : "stored";
  one.references = {
      {"povray", "live", "3.7.0.10", "povray +Iscene.pov +W64 +H48 +FN16 File_Gamma=1.0", 0.9, "",
       ""},
      {"blender", blender, "3.4.1", "blender -b --factory-startup -P x.py", 1.5, "", ""}};
  const std::vector<std::uint8_t> edge = outline(width, height, 0.8);
  const Picture ambient = ball(width, height, 0.8, 0.1), lit = ball(width, height, 0.8, 0.9);
  Picture whole = ambient;
  for (std::size_t i = 0; i < whole.pixels.size(); ++i) whole.pixels[i] += lit.pixels[i];
  one.layers = {{"ambient", "ambient", ambient, edge, {}, {}},
                {sample.light, sample.light_type, lit, edge, {}, {}},
                {"all", "all", whole, edge, {}, {}}};
  for (CaseLayer& layer : one.layers) {
    const bool is_ambient = layer.light == "ambient";
    Picture povray = disturbed(layer.ours, edge, is_ambient ? 1e-8 : sample.povray, 1e-7);
    if (sample.nan && !is_ambient) povray.at(20, 12).y = std::numeric_limits<double>::quiet_NaN();
    layer.theirs.push_back({"povray", "live", povray});
    add_rows(study, one, layer, layer.theirs.back());
    if (sample.blender_skipped) {
      layer.theirs.push_back({"blender", "", {}});
      Comparison row;
      row.scene = one.scene, row.reference = "blender", row.light = layer.light;
      row.light_type = layer.light_type, row.region = "all", row.verdict = "skipped";
      row.reason = "Blender is not installed and there is no stored image; apt install blender";
      study.comparisons.push_back(row);
    } else {
      layer.theirs.push_back(
          {"blender", "stored",
           disturbed(layer.ours, edge, is_ambient ? 2e-8 : sample.blender, 4e-6)});
      add_rows(study, one, layer, layer.theirs.back());
    }
  }
  study.cases.push_back(std::move(one));
}

inline Study with_provenance() {
  Study study;
  Provenance& p = study.provenance;
  p.litmus_version = "0.1.0", p.commit = "0123abc", p.compiler = "GNU 12.2.0", p.flags = "-O3";
  p.cpu = "A processor", p.system = "Debian 12", p.command = "litmus run";
  p.started = "2020-02-03 04:05 UTC", p.threads = 2, p.seconds = 12.5;
  p.versions = {{"POV-Ray", "3.7.0.10"}, {"Blender Cycles", "3.4.1"}};
  return study;
}

/// Every row passes.
inline Study passing_study() {
  Study study = with_provenance();
  add_case(study, {"d1-sun-floor", "sun", "directional"});
  add_case(study, {"p4-point-both", "lamp", "point"});
  add_case(study, {"s3-spot-cone", "spot", "spot"});
  return study;
}

/// A failure inside, a NaN, skipped rows, a renderer that failed and hostile text, beside passes.
inline Study mixed_study() {
  Study study = passing_study();
  add_case(study, {"r1-failing", "grid", "area", 3e-4});
  add_case(study, {"r2-nan", "grid", "area", 1.2e-7, 6e-7, false, true});
  add_case(study, {"r3-skipped", "grid", "area", 1.2e-7, 6e-7, true});
  add_case(study, {kHostile, kHostile, "point"});
  Case& hostile = study.cases.back();
  hostile.about = hostile.file = kHostile;
  hostile.tags = hostile.warnings = {kHostile};
  hostile.references[0].command = kHostile;
  hostile.references[0].log = "</script><script>alert(1)</script>";
  study.comparisons.back().reason = kHostile;
  study.comparisons.back().causes = {kHostile};
  study.provenance.command = kHostile;
  return study;
}

}  // namespace litmus

// compare.cpp: litmus compare, two image files without any scene.
#include <fmt/format.h>

#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/compare_samples.h"
#include "compare/difference.h"
#include "compare/image_io.h"
#include "compare/triage.h"
#include "compare/verdict.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

struct CompareArguments {
  std::filesystem::path ours, theirs;
  std::vector<std::string> samples;
  double tolerance = 1e-5;
  bool json = false;
};

struct Row {
  std::string layer;
  Difference difference;
  Verdict verdict;
  std::optional<Triage> triage;
};

/// FLIP takes 1 s or so for so many pixels; larger pictures do without.
constexpr std::size_t kTriagePixels = 2'000'000;

/// Part by part if both files have the same parts, else the first pictures.
std::vector<Row> compare(const CompareArguments& options) {
  const Tolerance tolerance{options.tolerance, options.tolerance, "the caller's", false};
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, const Picture& a, const Picture& b) {
    const Difference d = difference(a, b, {}, Region::All, options.tolerance);
    rows.push_back({name, d, judge(d, tolerance),
                    a.pixels.size() <= kTriagePixels ? std::optional(triage(a, b)) : std::nullopt});
  };
  const bool layered = !read_metadata(options.ours).empty() && options.ours.extension() == ".exr" &&
                       options.theirs.extension() == ".exr";
  Layers ours, theirs;
  if (layered) ours = read_layers(options.ours), theirs = read_layers(options.theirs);
  if (ours.size() < 2 || ours.size() != theirs.size()) {
    add("picture", read_picture(options.ours), read_picture(options.theirs));
    return rows;
  }
  for (std::size_t i = 0; i < ours.size(); ++i)
    add(ours[i].light, ours[i].picture, theirs[i].picture);
  add("all", sum(ours), sum(theirs));
  return rows;
}

void print_json(const std::vector<Row>& rows, double tolerance) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    const Difference& d = row.difference;
    nlohmann::ordered_json entry{{"layer", row.layer},
                                 {"pixels", d.pixels},
                                 {"nonfinite", d.nonfinite},
                                 {"max_at", d.max_at},
                                 {"over_tolerance", d.over_tolerance},
                                 {"tolerance", tolerance}};
    for (const auto& metric : kMetrics<Difference>)
      entry[std::string(metric.name)] = d.*metric.member;
    if (row.triage)
      entry["triage"] = {{"ldr_flip", row.triage->ldr_flip},
                         {"hdr_flip", row.triage->hdr_flip},
                         {"ssim", row.triage->ssim}};
    entry["verdict"] = row.verdict.pass ? "pass" : "fail";
    entry["reason"] = row.verdict.reason;
    list.push_back(entry);
  }
  std::cout << list.dump(2) << '\n';
}

void print_table(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    fmt::print("{}: {}\n", row.layer, row.verdict.pass ? "pass" : "FAIL, " + row.verdict.reason);
    const Difference& d = row.difference;
    fmt::print("  {:<10} {} pixels, {} not finite, {} over the tolerance\n", "", d.pixels,
               d.nonfinite, d.over_tolerance);
    for (const auto& metric : kMetrics<Difference>) {
      fmt::print("  {:<10} {:<12.4g} {}\n", metric.title, d.*metric.member, metric.meaning);
    }
    if (!row.triage) continue;
    const Triage& t = *row.triage;
    fmt::print("  {:<10} {:<12.4g} how visible, 0..1, shown as it is (no gate)\n", "LDR-FLIP",
               t.ldr_flip);
    fmt::print("  {:<10} {:<12.4g} how visible, 0..1, at the worst exposure (no gate)\n",
               "HDR-FLIP", t.hdr_flip);
    fmt::print("  {:<10} {:<12.6g} structural similarity, 1 is equal (no gate)\n", "SSIM", t.ssim);
  }
}

int run_compare(const CompareArguments& options) {
  if (!options.samples.empty())
    return compare_sample_files(options.samples, options.tolerance, options.json);
  if (options.theirs.empty()) throw Refusal("compare: give two image files, or --samples");
  const std::vector<Row> rows = compare(options);
  options.json ? print_json(rows, options.tolerance) : print_table(rows);
  for (const Row& row : rows) {
    if (!row.verdict.pass) return kOutOfTolerance;
  }
  return kPass;
}

}  // namespace

void add_compare(Program& program) {
  auto options = std::make_shared<CompareArguments>();
  Subcommand command = program.add("compare",
                                   "Compare two image files pixel by pixel, or two "
                                   "noisy renderers");
  command.option("ours", options->ours, "EXR, PFM or PNG (PNG as linear code values)");
  command.option("theirs", options->theirs, "The other one; the sign is ours - theirs");
  command
      .option("--samples", options->samples,
              "Pairs of quoted patterns: files of one renderer with different seeds, and of the "
              "other (8 or more each): are they the same but for noise?")
      .at_least(2);
  command
      .option("--tolerance", options->tolerance,
              "On the largest difference; with --samples, a difference that is none")
      .between(0, std::numeric_limits<double>::max())
      .with_default();
  command.flag("--json", options->json, "For machines");
  command.footer(
      "Example: litmus compare mine.exr theirs.exr --tolerance 1e-4\n"
      "         litmus compare --samples 'mine_*.exr' 'theirs_*.exr'");
  command.on_run([options] { return run_compare(*options); });
}

}  // namespace litmus

// compare_samples.cpp: files to stacks of seeds, tests, words.
#include "cli/compare_samples.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "compare/image_io.h"
#include "compare/statistics.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const std::string& pattern) {
  glob_t found;
  std::vector<fs::path> files;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);  // sorted
  globfree(&found);
  if (files.empty())
    throw Refusal(fmt::format("--samples: no file matches '{}'; quote the pattern", pattern));
  return files;
}

/// The parts of a file, or its only picture.
Layers layers_of(const fs::path& file) {
  if (file.extension() == ".exr" && !read_metadata(file).empty()) {
    Layers layers = read_layers(file);
    if (layers.size() > 1) {
      layers.push_back({"all", "all", sum(layers)});
      return layers;
    }
  }
  return {{"picture", "", read_picture(file)}};
}

/// One layer on one side: its seeds.
struct Seeds {
  std::string layer;
  std::vector<Picture> pictures;
};

std::vector<Seeds> seeds_of(const std::string& pattern) {
  const std::vector<fs::path> files = files_of(pattern);
  std::vector<Seeds> result;
  for (const fs::path& file : files) {
    Layers layers = layers_of(file);
    if (result.empty()) {
      for (const Layer& layer : layers) result.push_back({layer.light, {}});
      const double bytes = double(sizeof(glm::dvec3)) * double(layers[0].picture.pixels.size()) *
                           double(layers.size() * files.size());
      if (bytes > kMaximumSampleBytes)
        throw Refusal(fmt::format("--samples: {} files like {} need {:.1f} GB; use fewer or crop",
                                  files.size(), file.string(), bytes / 1e9));
    }
    if (layers.size() != result.size())
      throw Refusal(fmt::format("--samples: {} has {} parts, {} has {}; give files of one kind",
                                files[0].string(), result.size(), file.string(), layers.size()));
    for (std::size_t i = 0; i < layers.size(); ++i)
      result[i].pictures.push_back(std::move(layers[i].picture));
  }
  return result;
}

struct SampleRow {
  std::string ours, theirs, layer;
  SampleComparison comparison;
  double p = 1;  ///< after Holm
  bool different() const { return p <= kAlpha || comparison.nonfinite > 0; }
};

/// Shuffles that let the pixel test reject among so many comparisons.
int shuffles_for(std::size_t comparisons) {
  return int(std::min<std::size_t>(20000, 999 * comparisons));
}

std::vector<SampleRow> compare_all(std::span<const std::string> patterns, double negligible) {
  std::vector<SampleRow> rows;
  for (std::size_t i = 0; i < patterns.size(); i += 2) {
    const std::vector<Seeds> ours = seeds_of(patterns[i]), theirs = seeds_of(patterns[i + 1]);
    if (ours.size() != theirs.size())
      throw Refusal(fmt::format("--samples: the files of '{}' have {} parts, those of '{}' {}",
                                patterns[i], ours.size(), patterns[i + 1], theirs.size()));
    SampleOptions options;
    options.negligible = negligible;
    options.shuffles = shuffles_for(ours.size() * patterns.size() / 2);
    for (std::size_t k = 0; k < ours.size(); ++k)
      rows.push_back({patterns[i], patterns[i + 1], ours[k].layer,
                      compare_samples(ours[k].pictures, theirs[k].pictures, options)});
  }
  std::vector<double> p;
  for (const SampleRow& row : rows) p.push_back(row.comparison.p);
  p = holm(p);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].p = p[i];
  return rows;
}

constexpr const char* kChannels[] = {"red", "green", "blue"};

void print_samples(const std::vector<SampleRow>& rows) {
  for (const SampleRow& row : rows) {
    const SampleComparison& c = row.comparison;
    fmt::print("{} ({} seeds) against {} ({} seeds), {}: {}\n", row.ours, c.ours, row.theirs,
               c.theirs, row.layer, row.different() ? "DIFFERENT" : "no difference found");
    if (c.nonfinite > 0) fmt::print("  {} pixels are NaN or infinite in some seed\n", c.nonfinite);
    const auto line = [](const char* test, const Finding& f, const std::string& place) {
      fmt::print("  {:<6} p {:<9.3g} difference {:<+11.4g} {}\n", test, f.p, f.difference,
                 fmt::format("{}{}", kChannels[f.channel], place));
    };
    const auto at = [](const Finding& f) { return fmt::format(" at ({}, {})", f.at[0], f.at[1]); };
    line("mean", c.mean, "");
    line("tile", c.tile, at(c.tile));
    line("pixel", c.pixel, at(c.pixel));
    fmt::print("  together p {:.3g}, among {} comparison{} {:.3g}; different at {} or less\n", c.p,
               rows.size(), rows.size() == 1 ? "" : "s", row.p, kAlpha);
  }
  fmt::print("How often these tests call simulated pictures different:\n");
  for (const MeasuredRate& rate : measured_rates())
    fmt::print("  {:<46} {:5.1f} %  ({} runs, {} seeds a side, {} x {})\n", rate.what,
               100 * rate.rate, rate.runs, rate.seeds, rate.size, rate.size);
}

void print_samples_json(const std::vector<SampleRow>& rows, double negligible) {
  using nlohmann::ordered_json;
  const auto finding = [](const Finding& f) {
    return ordered_json{
        {"p", f.p}, {"difference", f.difference}, {"channel", kChannels[f.channel]}, {"at", f.at}};
  };
  ordered_json list = ordered_json::array(), measured = ordered_json::array();
  for (const SampleRow& row : rows) {
    const SampleComparison& c = row.comparison;
    list.push_back({{"ours", row.ours},
                    {"theirs", row.theirs},
                    {"layer", row.layer},
                    {"seeds", {c.ours, c.theirs}},
                    {"nonfinite", c.nonfinite},
                    {"mean", finding(c.mean)},
                    {"tile", finding(c.tile)},
                    {"pixel", finding(c.pixel)},
                    {"p", c.p},
                    {"p_holm", row.p},
                    {"verdict", row.different() ? "fail" : "pass"}});
  }
  for (const MeasuredRate& rate : measured_rates())
    measured.push_back({{"what", std::string(rate.what)},
                        {"seeds", rate.seeds},
                        {"size", rate.size},
                        {"runs", rate.runs},
                        {"rate", rate.rate}});
  const ordered_json all{
      {"alpha", kAlpha}, {"negligible", negligible}, {"comparisons", list}, {"measured", measured}};
  std::cout << all.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace

int compare_sample_files(std::span<const std::string> patterns, double negligible, bool json) {
  if (patterns.empty() || patterns.size() % 2 != 0)
    throw Refusal("--samples: give pairs of patterns: 'ours_*.exr' 'theirs_*.exr'");
  const std::vector<SampleRow> rows = compare_all(patterns, negligible);
  for (const SampleRow& row : rows)
    if (std::min(row.comparison.ours, row.comparison.theirs) < kEnoughSeeds)
      fmt::print(stderr,
                 "warning: {}, {}: fewer than {} seeds a side find little, and their verdict on "
                 "single pixels holds for normal noise only\n",
                 row.ours, row.layer, kEnoughSeeds);
  json ? print_samples_json(rows, negligible) : print_samples(rows);
  const bool different =
      std::any_of(rows.begin(), rows.end(), [](auto& r) { return r.different(); });
  return different ? kOutOfTolerance : kPass;
}

}  // namespace litmus

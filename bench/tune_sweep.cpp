// tune_sweep.cpp: what `litmus render --max-error` chooses, beside the cheapest of all settings.
//
// ninja -C build litmus_tune_sweep && build/litmus_tune_sweep [--width 48] [--error E ...] [SCENE
// ...]
//
// Every number of samples of each sampler is tried, on one thread, until a picture costs 1.6 times
// the cheapest known that keeps the error. The choice and the cheapest are then timed in turns, the
// least of nine each. Errors are those against a far finer picture.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

#include "scene/load.h"
#include "tracer/area_sampling.h"
#include "tracer/autotune.h"
#include "tracer/cpu_clock.h"
#include "tracer/pixel_lattice.h"

namespace litmus {
namespace {

constexpr double kTooDear = 1.6;
constexpr int kTurns = 9;
constexpr int kTruthSamples = 150;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Settings of one sampler and precision, each costlier than the one before.
using Ladder = std::vector<TuneSettings>;

std::vector<Ladder> area_ladders(int pixel_samples) {
  Ladder in_float, in_double, gauss, certified;
  for (int n = 1; n <= 64; ++n) {
    in_float.push_back({Sampler::Centres, n, pixel_samples, Precision::Float});
    in_double.push_back({Sampler::Centres, n, pixel_samples, Precision::Double});
    gauss.push_back({Sampler::Gauss, n, pixel_samples, Precision::Double});
  }
  for (int n = 1; n <= 128; n *= 2) {
    certified.push_back({Sampler::Certified, n, pixel_samples, Precision::Double});
    if (n > 1)
      certified.push_back({Sampler::Certified, n + n / 2, pixel_samples, Precision::Double});
  }
  return {certified, in_float, in_double, gauss};
}

std::vector<Ladder> pixel_ladders() {
  Ladder in_float, in_double;
  for (int n = 1; n <= 128; ++n) {
    in_float.push_back({Sampler::Scene, 0, n, Precision::Float});
    in_double.push_back({Sampler::Scene, 0, n, Precision::Double});
  }
  return {in_float, in_double};
}

double seconds_of(const Scene& scene, const TuneSettings& settings) {
  const double start = cpu_seconds();
  render(scene, settings, 1, true);
  return cpu_seconds() - start;
}

/// One setting as it was found.
struct Found {
  TuneSettings settings;
  double seconds = kInfinity, error = 0;
};

/// The cheapest setting on the ladders that keeps the error; none if there is none.
std::optional<Found> cheapest(const Scene& scene, const std::vector<Ladder>& ladders,
                              const Picture& truth, double max_error, double known) {
  std::optional<Found> best;
  for (const Ladder& ladder : ladders) {
    for (const TuneSettings& settings : ladder) {
      const double dear = kTooDear * std::min(known, best ? best->seconds : kInfinity);
      const double start = cpu_seconds();
      const Picture picture = render(scene, settings, 1, true).whole;
      double seconds = cpu_seconds() - start;
      if (seconds > dear) seconds = std::min(seconds, seconds_of(scene, settings));
      const bool too_dear = seconds > dear;
      const double error = error_of(pixel_errors(picture, truth), ErrorMetric::Max);
      if (error <= max_error) {
        for (int repeat = 0; repeat < 2; ++repeat)
          seconds = std::min(seconds, seconds_of(scene, settings));
        if (!best || seconds < best->seconds) best = Found{settings, seconds, error};
      }
      if (too_dear) break;
    }
  }
  return best;
}

/// How many times as long the first takes as the second.
double ratio(const Scene& scene, const TuneSettings& first, const TuneSettings& second) {
  double least_first = kInfinity, least_second = kInfinity;
  for (int turn = 0; turn < kTurns; ++turn) {
    least_first = std::min(least_first, seconds_of(scene, first));
    least_second = std::min(least_second, seconds_of(scene, second));
  }
  return least_first / least_second;
}

void print_row(const Scene& scene, double max_error) {
  const Tuned tuned = tune(scene, {.max_error = max_error, .threads = 1});
  const bool area = integrates_area_lights(scene);
  const int samples = tuned.settings.pixel_samples;
  // Not the lattice that the tuner may have judged by.
  const Picture truth = area ? render(scene, {Sampler::Certified, 256, samples}, 0, true).whole
                             : lattice_mean(scene, kTruthSamples, 0);
  const std::optional<Found> best =
      cheapest(scene, area ? area_ladders(samples) : pixel_ladders(), truth, max_error,
               tuned.met ? tuned.seconds : kInfinity);
  const std::string chosen = tuned.met ? words(tuned.settings) : "nothing keeps it";
  if (!best || !tuned.met) {
    fmt::print("{:<24} {:<7g} {:<40} {}\n", scene.name, max_error, chosen,
               best ? words(best->settings) : "nothing keeps it");
  } else {
    fmt::print("{:<24} {:<7g} {:<40} {:<40} {:.2f}\n", scene.name, max_error, chosen,
               words(best->settings), ratio(scene, tuned.settings, best->settings));
  }
  std::fflush(stdout);
}

/// With area lights or several samples a pixel; all others have the precision alone to choose.
bool has_a_choice(const Scene& scene) { return scene.samples > 1 || integrates_area_lights(scene); }

void sweep(const std::vector<std::string>& names, int width, const std::vector<double>& errors) {
  std::vector<Scene> scenes;
  for (const std::string& name : names) scenes.push_back(load_scene(find_scene(name)));
  if (names.empty()) scenes = load_canonical_scenes().scenes;
  fmt::print("{:<24} {:<7} {:<40} {:<40} {}\n", "scene", "error", "chosen", "cheapest", "ratio");
  for (Scene& scene : scenes) {
    if (!has_a_choice(scene)) continue;
    scene.height = std::max(1, width * scene.height / scene.width), scene.width = width;
    for (const double error : errors) print_row(scene, error);
  }
}

}  // namespace
}  // namespace litmus

int main(int argc, char** argv) {
  std::vector<std::string> scenes;
  std::vector<double> errors{1e-2, 1e-3, 1e-4};
  int width = 48;
  CLI::App app("The settings that --max-error chooses, beside the cheapest of an exhaustive sweep");
  app.add_option("scene", scenes, "Scenes; default: all canonical ones with more than one setting");
  app.add_option("--width", width, "Pixels across")
      ->capture_default_str()
      ->check(CLI::Range(1, 4096));
  app.add_option("--error", errors, "Errors to keep, the largest of all pixels");
  CLI11_PARSE(app, argc, argv);
  try {
    litmus::sweep(scenes, width, errors);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}

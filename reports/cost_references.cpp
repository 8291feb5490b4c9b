// cost_references.cpp: many settings of one renderer as many scenes of one batch.
#include "reports/cost_references.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "reference/native_drivers.h"

namespace litmus {
namespace {

/// One setting of a renderer.
struct Setting {
  double knob;
  std::string words;
  Scene scene;
};

Scene with_grid(const Scene& scene, int n) {
  Scene result = scene;
  for (Light& light : result.lights)
    if (AreaLight* area = std::get_if<AreaLight>(&light.shape)) area->columns = area->rows = n;
  return result;
}

/// What a batch gave: a result per scene, in their order.
std::vector<ReferenceResult> run(const Driver& driver, const Installation& installed,
                                 std::vector<Scene> scenes, const CostOptions& options) {
  for (std::size_t i = 0; i < scenes.size(); ++i) scenes[i].name = fmt::format("{}", i);
  std::vector<ReferenceResult> results(scenes.size());
  ReferenceOptions reference;
  reference.work = options.work / driver.name;
  reference.threads = 1;
  driver.render(installed, scenes, reference, [&](ReferenceResult result) {
    const auto at = std::size_t(std::stoul(result.scene));
    results[at] = std::move(result);
  });
  return results;
}

/// Renders all settings of a series, again and again.
void add_series(CostSeries series, const Driver& driver, const std::vector<Setting>& settings,
                const CostTruth& truth, const CostOptions& options, CostTopic& topic,
                CostStudy& study) {
  const auto miss = [&](const std::string& why) {
    const std::string line = fmt::format("{}: {}", series.title, why);
    if (std::find(study.missing.begin(), study.missing.end(), line) == study.missing.end())
      study.missing.push_back(line);
  };
  const std::optional<Installation> installed = driver.find();
  if (!installed) return miss(fmt::format("not installed (apt-get install {})", driver.package));
  if (options.progress) options.progress(series.title);
  std::vector<Scene> scenes;
  for (const Setting& setting : settings) scenes.push_back(setting.scene);
  std::vector<std::vector<double>> seconds(settings.size());
  for (int repeat = 0; repeat < (options.quick ? kFewCostRepeats : kCostRepeats); ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<ReferenceResult> results = run(driver, *installed, scenes, options);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    double rendering = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!results[i].failure.empty() || results[i].layers.empty()) {
        return miss(results[i].failure.empty() ? results[i].skipped : results[i].failure);
      }
      seconds[i].push_back(results[i].seconds);
      rendering += results[i].seconds;
      if (repeat > 0) continue;
      series.points.push_back(
          {settings[i].knob, settings[i].words, figures(sum(results[i].layers), truth), {}});
    }
    double& start_up = study.start_up[series.renderer];
    const double rest = std::max(0.0, wall.count() - rendering);
    start_up = start_up == 0 ? rest : std::min(start_up, rest);
  }
  for (std::size_t i = 0; i < settings.size(); ++i) series.points[i].time = time_of(seconds[i]);
  topic.series.push_back(std::move(series));
}

std::vector<Setting> grids(const Scene& scene, const std::vector<int>& sides,
                           std::string_view what) {
  std::vector<Setting> settings;
  for (const int n : sides)
    settings.push_back({double(n), fmt::format("{} {} x {}", what, n, n), with_grid(scene, n)});
  return settings;
}

/// A setting that needs a driver of its own.
struct DriverSetting {
  Driver driver;
  double knob;
  std::string words;
  Scene scene;
};

template <class Make>
void add_driver_series(const CostSeries& head, const std::vector<int>& knobs, const Make& make,
                       const CostTruth& truth, const CostOptions& options, CostTopic& topic,
                       CostStudy& study) {
  CostTopic alone;
  for (const int knob : knobs) {
    const DriverSetting one = make(knob);
    const std::size_t before = alone.series.size();
    add_series(head, one.driver, {{one.knob, one.words, one.scene}}, truth, options, alone, study);
    if (alone.series.size() == before) return;
  }
  CostSeries series = head;
  for (const CostSeries& one : alone.series) series.points.push_back(one.points[0]);
  topic.series.push_back(std::move(series));
}

}  // namespace

void add_area_references(const Scene& scene, const CostTruth& truth, const CostOptions& options,
                         CostTopic& topic, CostStudy& study) {
  const std::vector<int> sides =
      options.quick ? std::vector<int>{1, 2, 4, 8} : std::vector<int>{1, 2, 4, 8, 16};
  const std::string side = "samples a side";
  add_series({"povray-grid", "povray", "POV-Ray, grid of lamps", side}, *find_driver("povray"),
             grids(scene, sides, "lamps"), truth, options, topic, study);
  add_series({"povray-area", "povray", "POV-Ray, its area_light", side, false}, native_drivers()[0],
             grids(scene, sides, "area_light"), truth, options, topic, study);
  add_series({"cycles-grid", "blender", "Cycles, grid of lamps", side}, *find_driver("blender"),
             grids(scene, {1, 2, 4}, "lamps"), truth, options, topic, study);
  add_driver_series(
      {"povray-adaptive", "povray", "POV-Ray, its area_light 17 x 17, adaptive", "level + 1",
       false},
      {0, 1, 2, 3, 4},
      [&](int level) {
        return DriverSetting{povray_native_driver(level, 0), level + 1.0,
                             fmt::format("area_light 17 x 17 adaptive {}", level),
                             with_grid(scene, 17)};
      },
      truth, options, topic, study);
  add_driver_series(
      {"cycles-area", "blender", "Cycles, its AREA light", "samples a pixel", false},
      {4, 16, 64, 256},
      [&](int rays) {
        return DriverSetting{blender_native_driver(rays), double(rays),
                             fmt::format("AREA light, {} samples a pixel", rays), scene};
      },
      truth, options, topic, study);
}

void add_pixel_references(const Scene& scene, const CostTruth& truth, const CostOptions& options,
                          CostTopic& topic, CostStudy& study) {
  for (const Driver& driver : drivers()) {
    std::vector<Setting> settings;
    for (const int n : {1, 2, 4}) {
      Scene changed = scene;
      changed.samples = n;
      settings.push_back({double(n), fmt::format("{0} x {0} samples a pixel", n), changed});
    }
    add_series(
        {driver.name + "-samples", driver.name, driver.title + ", n x n samples", "samples a side"},
        driver, settings, truth, options, topic, study);
  }
}

}  // namespace litmus
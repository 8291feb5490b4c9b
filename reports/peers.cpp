// peers.cpp: the tasks, each taken in turns.
#include "reports/peers.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "reports/cost_measure.h"
#include "reports/peer_entrants.h"
#include "reports/stage.h"

namespace litmus {
namespace {

/// A lit picture by litmus, by others, and by what its arithmetic allows.
PeerTask picture_task(const std::string& name, const std::string& title, const Scene& scene,
                      const std::vector<Entrant>& others, const PeerOptions& options) {
  std::vector<Entrant> entrants = kernel_entrants(scene);
  entrants.insert(entrants.end(), others.begin(), others.end());
  const double pixels = double(scene.width) * scene.height;
  const Operations operations = counted_operations(scene);
  const ArithmeticRates rates = arithmetic_rates();
  entrants.push_back(limit_entrant(operations, rates));
  return take_turns({name,
                     fmt::format("{}, {} x {}", title, scene.width, scene.height),
                     "pixel",
                     pixels,
                     {},
                     limit_notes(operations, rates, pixels)},
                    entrants, options);
}

PeerTask point_task(int size, const PeerOptions& options) {
  const Scene scene = point_stage(size);
  return picture_task("point", "Point light with quadratic attenuation", scene,
                      {povray_entrant("POV-Ray", scene, povray_lamps(scene), options),
                       cycles_entrant(scene, options)},
                      options);
}

PeerTask area_task(int size, const PeerOptions& options) {
  const Scene scene = area_stage(size, 8);
  return picture_task(
      "area", "Area light of 8 x 8 samples", scene,
      {povray_entrant("POV-Ray, 64 light sources", scene, povray_lamps(scene), options),
       povray_entrant("POV-Ray, area_light 8 x 8 (shades from its centre)", scene,
                      povray_area_light(scene), options)},
      options);
}

}  // namespace

double PeerRow::least() const {
  return seconds.empty() ? 0 : *std::min_element(seconds.begin(), seconds.end());
}

PeerRatio PeerTask::ratio(const PeerRow& row) const {
  const std::vector<double>& first = rows.at(0).seconds;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < row.seconds.size() && i < first.size(); ++i)
    ratios.push_back(row.seconds[i] / first[i]);
  if (ratios.empty()) return {};
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  return {median(ratios), *least, *most};
}

PeerTask take_turns(PeerTask task, const std::vector<Entrant>& entrants,
                    const PeerOptions& options) {
  if (options.progress) options.progress(task.title);
  for (const Entrant& entrant : entrants)
    task.rows.push_back({entrant.name, entrant.missing, {}, entrant.triangles});
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    for (std::size_t i = 0; i < entrants.size(); ++i) {
      PeerRow& row = task.rows[i];
      if (!row.missing.empty()) continue;
      try {
        row.seconds.push_back(entrants[i].measure());
      } catch (const std::exception& wrong) {
        row.missing = wrong.what(), row.seconds.clear();
      }
    }
  }
  return task;
}

double least_of(const std::function<double()>& measure) {
  constexpr int kMost = 20;
  constexpr double kLong = 0.1;
  double least = measure(), spent = least;
  for (int i = 1; i < kMost && (i < 2 || spent < kLong); ++i) {
    const double seconds = measure();
    least = std::min(least, seconds), spent += seconds;
  }
  return least;
}

std::vector<PeerTask> measure_peers(const PeerOptions& options) {
  const int size = options.quick ? 256 : 1024;
  std::vector<PeerTask> tasks{point_task(size, options), area_task(size / 2, options)};
  const auto add = [&](std::vector<PeerTask> more) {
    std::move(more.begin(), more.end(), std::back_inserter(tasks));
  };
  add(mesh_tasks(202'000, size / 2, options));
  if (!options.quick) add(mesh_tasks(2'000'000, size / 2, options));
  std::vector<int> triangles{1'000, 10'000, 100'000};
  if (!options.quick) triangles.insert(triangles.end(), {1'000'000, 2'000'000});
  add(growth_tasks(triangles, size / 2, options));
  return tasks;
}

bool complete(const std::vector<PeerTask>& tasks) {
  return std::ranges::all_of(tasks, [](const PeerTask& task) {
    return std::ranges::all_of(task.rows, [](const PeerRow& row) { return row.missing.empty(); });
  });
}

}  // namespace litmus

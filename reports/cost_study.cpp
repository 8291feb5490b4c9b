// cost_study.cpp: litmus's own settings, one topic after the other.
#include "reports/cost_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/cost_fit.h"
#include "reports/cost_measure.h"
#include "reports/cost_references.h"
#include "tracer/area_sampling.h"
#include "tracer/autotune.h"

namespace litmus {
namespace {

Scene resized(Scene scene, const CostOptions& options) {
  scene = cost_sized(std::move(scene), options);
  scene.samples = 1;
  return scene;
}

using SettingOf = std::function<TuneSettings(int n)>;
using WordsOf = std::function<std::string(int n)>;

/// A series of litmus's own, with its jobs.
void add_series(CostTopic& topic, std::vector<CostJob>& jobs, const Scene& scene,
                const CostSeries& head, const std::vector<int>& knobs, const SettingOf& setting,
                const WordsOf& words_of) {
  const std::size_t series = topic.series.size();
  topic.series.push_back(head);
  for (const int n : knobs) {
    const TuneSettings settings = setting(n);
    topic.series.back().points.push_back({double(n), words_of(n), {}, {}});
    jobs.push_back({series, topic.series.back().points.size() - 1,
                    [&scene, settings] { return render(scene, settings, 1, true).whole; }});
  }
}

CostTopic area_topic(const Scene& scene, const CostOptions& options, CostStudy& study) {
  CostTopic topic{"area",
                  "Area lights: how many samples?",
                  "each area light as the whole rectangle, the limit of ever finer grids",
                  "",
                  {},
                  {}};
  const int finest = options.quick ? 64 : 128;
  const CostTruth truth =
      converged(render(scene, TuneSettings{Sampler::Certified, finest / 2}, 0),
                render(scene, TuneSettings{Sampler::Certified, finest}, 0), 0.5);
  topic.truth = fmt::format("certified n = {}; its error is half of what it differs from n = {}",
                            finest, finest / 2);
  topic.truth_error = truth.own_error;

  const std::vector<int> grids = options.quick
                                     ? std::vector<int>{1, 2, 4, 6, 8, 12, 16}
                                     : std::vector<int>{1, 2, 3, 4, 6, 8, 11, 16, 23, 32, 45, 64};
  const std::vector<int> pieces =
      options.quick ? std::vector<int>{1, 2, 4, 8, 16} : std::vector<int>{1, 2, 4, 8, 16, 32};
  const auto by = [](Sampler sampler) {
    return [sampler](int n) { return TuneSettings{sampler, n}; };
  };
  const std::string side = "samples a side", piece = "finest pieces a side";
  std::vector<CostJob> jobs;
  const auto add = [&](const CostSeries& head, const std::vector<int>& knobs, Sampler sampler) {
    add_series(topic, jobs, scene, head, knobs, by(sampler),
               [name = head.name](int n) { return fmt::format("{} n = {}", name, n); });
  };
  std::vector<int> fine_grids = grids;  // as far as the errors that the sentences ask for
  if (!options.quick) fine_grids.insert(fine_grids.end(), {90, 128});
  add({"grid", "litmus", "litmus, grid of cell centres", side}, fine_grids, Sampler::Centres);
  add({"corners", "litmus", "litmus, grid out to the corners", side}, grids, Sampler::Corners);
  add({"gauss-legendre", "litmus", "litmus, Gauss-Legendre", side}, grids, Sampler::Gauss);
  add({"jittered", "litmus", "litmus, jittered", side}, grids, Sampler::Jittered);
  add({"r2", "litmus", "litmus, R2 sequence", side}, grids, Sampler::R2);
  add({"certified", "litmus", "litmus, certified", piece}, pieces, Sampler::Certified);
  measure(topic, jobs, truth, options);
  if (options.references) add_area_references(scene, truth, options, topic, study);
  for (CostSeries& series : topic.series) series.fits = fit_orders(series, topic.truth_error);
  return topic;
}

CostTopic pixel_topic(const Scene& scene, const CostOptions& options, CostStudy& study) {
  CostTopic topic{"pixel",
                  "Pixels: how many samples?",
                  "each pixel as the mean over its whole area; area lights on the scene's own grid",
                  "",
                  {},
                  {}};
  const auto by = [](int n) { return TuneSettings{Sampler::Scene, 0, n}; };
  const int finest = options.quick ? 16 : 32;
  const CostTruth truth =
      converged(render(scene, by(finest / 2), 0), render(scene, by(finest), 0), 1);
  topic.truth = fmt::format("{0} x {0} samples; their error is what they differ from {1} x {1}",
                            finest, finest / 2);
  topic.truth_error = truth.own_error;
  const std::vector<int> knobs =
      options.quick ? std::vector<int>{1, 2, 3, 4, 6} : std::vector<int>{1, 2, 3, 4, 6, 8, 11, 16};
  std::vector<CostJob> jobs;
  add_series(topic, jobs, scene, {"samples", "litmus", "litmus, n x n samples", "samples a side"},
             knobs, by, [](int n) { return fmt::format("{0} x {0} samples a pixel", n); });
  measure(topic, jobs, truth, options);
  if (options.references) add_pixel_references(scene, truth, options, topic, study);
  for (CostSeries& series : topic.series) series.fits = fit_orders(series, topic.truth_error);
  return topic;
}

CostTopic precision_topic(const Scene& scene, const CostOptions& options) {
  CostTopic topic{"precision",
                  "Arithmetic: how many bits?",
                  "the scene as it is, at the pixels' centres, without rounding",
                  "",
                  {},
                  {}};
  const auto in = [](Precision precision) { return TuneSettings{Sampler::Scene, 0, 1, precision}; };
  Rendering quad = render(scene, in(Precision::Quad), 0);
  const CostTruth truth{quad.whole, regions_of(quad), {}};
  topic.truth = "the same in quad precision (113 bits)";
  std::vector<CostJob> jobs;
  add_series(
      topic, jobs, scene, {"precision", "litmus", "litmus", "bits"}, {24, 53, 64},
      [&](int bits) {
        return in(bits == 24   ? Precision::Float
                  : bits == 53 ? Precision::Double
                               : Precision::LongDouble);
      },
      [&](int bits) {
        return std::string(bits == 24 ? "float" : bits == 53 ? "double" : "long double");
      });
  measure(topic, jobs, truth, options);
  return topic;
}

}  // namespace

CostStudy measure_cost(const Scene& given, const CostOptions& options) {
  const Scene scene = resized(given, options);
  CostStudy study;
  study.scene = scene.name, study.about = scene.about;
  study.width = scene.width, study.height = scene.height, study.quick = options.quick;
  const auto say = [&](const std::string& text) {
    if (options.progress) options.progress(text);
  };
  if (integrates_area_lights(scene)) {
    say("area lights");
    study.topics.push_back(area_topic(scene, options, study));
  }
  say("samples of a pixel");
  study.topics.push_back(pixel_topic(scene, options, study));
  say("precision");
  study.topics.push_back(precision_topic(scene, options));
  study.sentences = cost_sentences(study);
  return study;
}

}  // namespace litmus

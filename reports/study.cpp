// study.cpp: walks from scenes through pictures and differences to verdicts. It computes nothing
// itself.
#include "reports/study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <future>
#include <iterator>

#include "compare/tolerances.h"
#include "reference/closed_form.h"
#include "reports/candidates.h"
#include "reports/compare_scene.h"
#include "reports/controls.h"
#include "reports/plain_text.h"
#include "reports/provenance.h"
#include "scene/refusal.h"
#include "tracer/render.h"

namespace litmus {
namespace {

std::vector<const Driver*> chosen_drivers(const std::vector<std::string>& names) {
  std::vector<const Driver*> chosen;
  for (const Driver& driver : drivers()) {
    if (names.empty() || std::find(names.begin(), names.end(), driver.name) != names.end()) {
      chosen.push_back(&driver);
    }
  }
  for (const std::string& name : names) {
    if (!find_driver(name) && name != kClosedForm)
      throw Refusal(
          fmt::format("reference \"{}\": there are povray, blender and closed-form", name));
  }
  return chosen;
}

/// For each scene a result per driver, all drivers at the same time.
std::vector<std::vector<ObtainedReference>> obtain_all(std::span<const Scene> scenes,
                                                       std::span<const Driver* const> drivers,
                                                       const ObtainOptions& options) {
  std::vector<std::future<std::vector<ObtainedReference>>> running;
  for (const Driver* driver : drivers) {
    running.push_back(
        std::async(std::launch::async, [=] { return obtain(scenes, *driver, options); }));
  }
  std::vector<std::vector<ObtainedReference>> results(scenes.size());
  for (auto& each : running) {
    std::vector<ObtainedReference> of_driver = each.get();
    for (std::size_t i = 0; i < results.size(); ++i) results[i].push_back(std::move(of_driver[i]));
  }
  return results;
}

/// One after the other, so that a scene's seconds are its own.
std::vector<RenderedScene> render_ours(std::span<const Scene> scenes, const Control* control,
                                       int threads) {
  std::vector<RenderedScene> ours;
  for (const Scene& scene : scenes) {
    RenderedScene& one = ours.emplace_back(RenderedScene{scene, {.threads = threads}, {}});
    one.bands = render_with(control, one.scene, one.options);
  }
  return ours;
}

void append(std::vector<Comparison>& rows, std::vector<Comparison>&& more) {
  std::move(more.begin(), more.end(), std::back_inserter(rows));
}

void append(Study& study, Study&& part) {
  std::move(part.cases.begin(), part.cases.end(), std::back_inserter(study.cases));
  append(study.comparisons, std::move(part.comparisons));
  append(study.informative, std::move(part.informative));
  append(study.pairs, std::move(part.pairs));
}

}  // namespace

Study run_study(std::span<const Scene> scenes, const StudyOptions& options) {
  const std::vector<const Driver*> drivers = chosen_drivers(options.references);
  const Control* control = options.control.empty() ? nullptr : find_control(options.control);
  if (!options.control.empty() && !control) {
    throw Refusal(
        fmt::format("--control: there is no \"{}\"; see litmus run --help", options.control));
  }
  const bool asked = options.native || options.obtain.sources != Sources::Stored;
  auto provenance = std::async(std::launch::async, [&] { return provenance_of(drivers, asked); });
  const std::vector<ExtraSource> extras = obtain_extras(scenes, options);
  std::vector<std::vector<ObtainedReference>> references =
      obtain_all(scenes, drivers, options.obtain);
  std::vector<RenderedScene> ours = render_ours(scenes, control, options.threads);
  std::vector<Study> parts(scenes.size());
  const auto compare = [&](std::size_t i) {
    parts[i] = compare_scene(scenes[i], std::move(ours[i]), {std::move(references[i]), extras, i},
                             options);
  };
  tbb::parallel_for(std::size_t{0}, scenes.size(), compare, tbb::simple_partitioner{});
  Study study;
  for (Study& part : parts) append(study, std::move(part));
  study.warnings = tolerance_warnings(tolerances(), nearby(tolerances_file()));
  study.provenance = provenance.get();
  for (const Candidate& candidate : options.candidates)
    study.candidates.push_back({candidate.name, std::string(name_of(candidate.encoding)),
                                candidate.encoding.exposure, blindness(candidate.encoding)});
  return study;
}

std::string overall_verdict(const Study& study) {
  const auto any = [&](std::string_view verdict) {
    return std::any_of(study.comparisons.begin(), study.comparisons.end(),
                       [&](const Comparison& row) { return row.verdict == verdict; });
  };
  for (const Case& entry : study.cases) {
    for (const CaseReference& reference : entry.references) {
      if (!reference.failure.empty()) return "broken";
    }
  }
  if (any("fail")) return "fail";
  return any("skipped") || study.comparisons.empty() ? "incomplete" : "pass";
}

}  // namespace litmus

// candidates.cpp: candidates and native exports as further sources of a study.
#include "reports/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "reference/native_drivers.h"
#include "reports/overview.h"

namespace litmus {
namespace {

/// The pictures that were rounded one by one: layer `index`, or all of them behind the last.
std::vector<const Picture*> parts_of(const ObtainedReference& images, std::size_t index) {
  if (index < images.layers.size()) return {&images.layers[index].picture};
  std::vector<const Picture*> parts;
  for (const Layer& layer : images.layers) parts.push_back(&layer.picture);
  return parts;
}

/// Whether a candidate is asked for the band scenes of a spectral scene, which are RGB scenes to
/// it: per band there is no rounding to allow for.
bool takes_bands(const Candidate& candidate) {
  return candidate.images.empty() && candidate.encoding.bits == 0;
}

std::vector<ObtainedReference> obtain_all(std::span<const Scene> scenes, const Candidate& candidate,
                                          const ObtainOptions& options) {
  if (takes_bands(candidate)) return obtain_candidate(scenes, candidate, options);
  std::vector<Scene> rgb;
  for (const Scene& scene : scenes)
    if (!scene.spectra) rgb.push_back(scene);
  std::vector<ObtainedReference> obtained = obtain_candidate(rgb, candidate, options), all;
  std::size_t next = 0;
  for (const Scene& scene : scenes) {
    if (!scene.spectra) {
      all.push_back(std::move(obtained.at(next++)));
      continue;
    }
    ObtainedReference none;
    none.scene = scene.name, none.reference = candidate.name;
    none.skipped = "a spectral scene: its bands are for commands that write floats";
    all.push_back(std::move(none));
  }
  return all;
}

}  // namespace

std::vector<ExtraSource> obtain_extras(std::span<const Scene> scenes, const StudyOptions& options) {
  std::vector<std::future<ExtraSource>> running;
  for (const Candidate& candidate : options.candidates) {
    running.push_back(std::async(std::launch::async, [&] {
      return ExtraSource{candidate.name, candidate.encoding, !candidate.expected_to_differ, false,
                         obtain_all(scenes, candidate, options.obtain)};
    }));
  }
  if (options.native) {
    for (const Driver& driver : native_drivers()) {
      running.push_back(std::async(std::launch::async, [&] {
        ObtainOptions live = options.obtain;
        live.sources = Sources::Auto;  // nothing is stored of them: without the renderer, skipped
        return ExtraSource{driver.name, {}, false, true, obtain(scenes, driver, live)};
      }));
    }
  }
  std::vector<ExtraSource> sources;
  for (auto& each : running) sources.push_back(each.get());
  return sources;
}

Picture theirs_beyond_rounding(const Picture& ours, const ObtainedReference& images,
                               std::size_t index, const Encoding& encoding) {
  if (encoding.bits > 0) return nearest_that_rounds_to(ours, parts_of(images, index), encoding);
  return index < images.layers.size() ? images.layers[index].picture : sum(images.layers);
}

std::string rounding_note(const ObtainedReference& images, std::size_t index,
                          const Encoding& encoding) {
  if (encoding.bits == 0) return "";
  double largest = 0;
  long clipped = 0;
  for (const Picture* part : parts_of(images, index)) {
    double brightest = 0;
    for (const glm::dvec3& p : part->pixels) brightest = std::max({brightest, p.x, p.y, p.z});
    // The half step never falls with the light.
    largest += half_step(brightest, encoding);
    clipped += clipped_pixels(*part, encoding);
  }
  std::string note =
      fmt::format("without what {} can round away, here up to {:.2g}", name_of(encoding), largest);
  if (clipped > 0)
    note += fmt::format("; {} pixel{} at its white, where brighter light is not told apart",
                        clipped, clipped == 1 ? " is" : "s are");
  return note;
}

std::vector<InformativeLine> informative_lines(const Study& study) {
  std::vector<std::string> sources;
  for (const Comparison& row : study.informative)
    if (std::find(sources.begin(), sources.end(), row.reference) == sources.end())
      sources.push_back(row.reference);
  std::vector<InformativeLine> lines;
  for (const std::string& source : sources)
    for (const std::string& type : light_types_of(study)) {
      InformativeLine line{source, type, {}, {}};
      double worst = -1;
      const auto add = [&](const Comparison& row) {
        if (row.reference != source || row.light_type != type || row.region != "interior" ||
            row.verdict == "skipped")
          return;
        const auto at = std::find(kAgainst.begin(), kAgainst.end(), row.against);
        if (at == kAgainst.end()) return;
        std::optional<double>& largest = line.largest[std::size_t(at - kAgainst.begin())];
        largest = std::max(largest.value_or(0), row.max_abs);
        if (row.max_abs > worst) worst = row.max_abs, line.scene = row.scene;
      };
      for (const Comparison& row : study.comparisons) add(row);
      for (const Comparison& row : study.informative) add(row);
      if (worst >= 0) lines.push_back(line);
    }
  return lines;
}

}  // namespace litmus

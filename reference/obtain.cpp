// obtain.cpp: plan, take what the store has, render the rest in one batch, keep each result at
// once.
#include "reference/obtain.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "reference/band_images.h"
#include "reference/hash.h"
#include "reference/process.h"
#include "reference/stored_images.h"
#include "scene/load.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// One scene to get live.
struct Job {
  const Scene* scene = nullptr;
  ObtainedReference* result = nullptr;
  std::vector<StoreKey> keys;  ///< one per layer
};

std::vector<StoreKey> keys_of(const Scene& scene, const Driver& driver, const std::string& version,
                              const std::string& program_version) {
  StoreKey key{.scene = fingerprint(scene),
               .layer = 0,
               .light = "ambient",
               .reference = driver.name,
               .revision = driver.revision,
               .source = hash_text(driver.source(scene)),
               .renderer_version = version,
               .program_version = program_version};
  std::vector<StoreKey> keys{key};
  for (const auto& light : scene.lights) {
    ++key.layer;
    key.light = light.name;
    keys.push_back(key);
  }
  return keys;
}

void round_to_float(Layers& layers) {
  for (auto& layer : layers)
    for (auto& pixel : layer.picture.pixels)
      for (int c = 0; c < 3; ++c) {
        // volatile: g++ 12 vectorises a round trip through float in pairs and then drops it.
        const volatile float rounded = float(pixel[c]);
        pixel[c] = rounded;
      }
}

/// Fills the job's result from the store if all its layers are there.
bool take(const Store& store, const Job& job) {
  Layers layers;
  StoreEntry entry;
  for (const auto& key : job.keys) {
    auto found = find(store, key);
    if (!found) return false;
    entry = std::move(*found);
    layers.push_back(std::move(entry.layer));
  }
  if (!misfit(*job.scene, layers).empty()) return false;
  job.result->layers = std::move(layers);
  job.result->source = "live";
  job.result->seconds = entry.seconds;
  job.result->command = entry.command;
  return true;
}

void keep(const Store& store, const Job& job) {
  try {
    for (std::size_t i = 0; i < job.keys.size(); ++i)
      save(store, job.keys[i], {job.result->layers[i], job.result->seconds, job.result->command});
  } catch (const std::exception& wrong) {
    if (store.warn) store.warn(fmt::format("{}: not kept: {}", job.scene->name, wrong.what()));
  }
}

/// Takes over what the driver says about one scene.
void accept(const Job& job, ReferenceResult&& said, const ObtainOptions& options) {
  auto& result = *job.result;
  result.command = std::move(said.command);
  result.seconds = said.seconds;
  result.failure = std::move(said.failure);
  result.skipped = std::move(said.skipped);
  if (!result.skipped.empty()) return;
  if (result.failure.empty())
    if (const auto wrong = misfit(*job.scene, said.layers); !wrong.empty())
      result.failure = fmt::format("{} gave a wrong image: {}", result.reference, wrong);
  if (!result.failure.empty()) {
    result.log = tail(said.log);
    return;
  }
  result.layers = std::move(said.layers);
  round_to_float(result.layers);
  result.source = "live";
  result.rendered_now = true;
  if (options.store) keep(*options.store, job);
}

/// Renders jobs of different names in one batch; every job's result is set afterwards.
void render_batch(const std::vector<Job>& jobs, const Driver& driver, const Installation& installed,
                  const ObtainOptions& options, const fs::path& work) {
  std::vector<Scene> scenes;
  std::map<std::string, const Job*> waiting;
  for (const auto& job : jobs) {
    scenes.push_back(*job.scene);
    waiting[job.scene->name] = &job;
  }
  auto reference = options.reference;
  reference.work = work;
  std::string reason = "gave no result";
  try {
    fs::create_directories(work);
    driver.render(installed, scenes, reference, [&](ReferenceResult said) {
      const auto found = waiting.find(said.scene);
      if (found == waiting.end()) return;
      accept(*found->second, std::move(said), options);
      waiting.erase(found);
    });
  } catch (const std::exception& wrong) {
    reason = wrong.what();
  }
  for (const auto& [name, job] : waiting) job->result->failure = driver.title + ": " + reason;
}

/// Scenes of one name (files of one stem in two folders) would share the driver's files: they go
/// into different batches. Nearly always this is one batch.
void render_all(std::vector<Job> jobs, const Driver& driver, const Installation& installed,
                const ObtainOptions& options) {
  for (int batch = 0; !jobs.empty(); ++batch) {
    std::set<std::string> names;
    std::vector<Job> now, later;
    for (auto& job : jobs)
      (names.insert(job.scene->name).second ? now : later).push_back(std::move(job));
    auto work = options.reference.work / driver.name;
    if (batch > 0) work += fmt::format("-{}", batch + 1);
    render_batch(now, driver, installed, options, work);
    jobs = std::move(later);
  }
}

std::vector<ObtainedReference> obtain_live(std::span<const Scene> scenes, const Driver& driver,
                                           const Installation& installed,
                                           const ObtainOptions& options) {
  std::vector<ObtainedReference> results(scenes.size());
  std::vector<Job> missing;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    auto& result = results[i];
    result.scene = scenes[i].name;
    result.reference = driver.name;
    result.version = installed.version;
    try {
      Job job{&scenes[i], &result,
              keys_of(scenes[i], driver, installed.version, options.program_version)};
      if (options.store && !options.fresh && take(*options.store, job)) continue;
      missing.push_back(std::move(job));
    } catch (const Refusal& wrong) {
      result.skipped = fmt::format("{} cannot express it: {}", driver.title, wrong.what());
    }
  }
  render_all(std::move(missing), driver, installed, options);
  return results;
}

void obtain_stored(const Scene& scene, const Driver& driver, const fs::path& folder,
                   ObtainedReference& result) {
  auto [images, reason] = load_stored(scene, driver.name, folder);
  if (!images) {
    result.skipped = reason;
    return;
  }
  result.layers = std::move(images->layers);
  result.source = "stored";
  result.version = images->version;
  result.command = images->command;
  result.seconds = images->seconds;
}

}  // namespace

Sources parse_sources(std::string_view word) {
  if (word == "auto") return Sources::Auto;
  if (word == "live") return Sources::Live;
  if (word == "stored") return Sources::Stored;
  throw Refusal(fmt::format("--references: {} is not one of auto, live, stored", word));
}

std::vector<ObtainedReference> obtain(std::span<const Scene> scenes, const Driver& driver,
                                      const ObtainOptions& options) {
  const auto installed = options.sources == Sources::Stored ? std::nullopt : driver.find();
  if (installed) {
    const std::vector<Scene> all = renderable(scenes);
    return gathered(scenes, obtain_live(all, driver, *installed, options));
  }
  std::vector<ObtainedReference> results(scenes.size());
  const auto missing =
      fmt::format("{} is not installed: apt-get install {}", driver.title, driver.package);
  const auto folder =
      options.stored_images.empty() ? stored_images_directory() : options.stored_images;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    results[i].scene = scenes[i].name;
    results[i].reference = driver.name;
    if (options.sources == Sources::Live) {
      results[i].failure = missing;
      continue;
    }
    obtain_stored(scenes[i], driver, folder, results[i]);
    if (options.sources == Sources::Auto && !results[i].skipped.empty())
      results[i].skipped = missing + "; " + results[i].skipped;
  }
  return results;
}

}  // namespace litmus

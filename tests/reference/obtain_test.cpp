// obtain_test.cpp: images come from where they may, and nothing stands in for anything else.
#include "reference/obtain.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "reference/stored_images.h"
#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// How the renderer of these tests behaves. It counts the scenes that it renders.
struct Behaviour {
  bool installed = true;
  std::string version = "1.0", source_suffix, failing, silent, misshapen, inexpressible;
  std::string breakdown;  ///< thrown after the first scene
  std::atomic<int> rendered = 0;
};
Behaviour* behaviour = nullptr;

std::optional<Installation> find_fake() {
  if (!behaviour->installed) return std::nullopt;
  return Installation{"/bin/fake", behaviour->version};
}

std::string fake_source(const Scene& scene) {
  if (scene.name == behaviour->inexpressible) throw Refusal("no such light");
  return scene.name + behaviour->source_suffix;
}

void render_fake(const Installation&, std::span<const Scene> scenes,
                 const ReferenceOptions& options, const ResultSink& sink) {
  for (const auto& scene : scenes) {
    ++behaviour->rendered;
    if (scene.name == behaviour->silent) continue;
    ReferenceResult result;
    result.scene = scene.name;
    result.layers = sample_layers(scene, 1);
    for (auto& layer : result.layers) layer.picture.pixels[0] = glm::dvec3(1.0 / 3);  // not a float
    result.seconds = 2;
    result.command = "fake " + scene.name;
    if (scene.name == behaviour->misshapen) result.layers.pop_back();
    if (scene.name == behaviour->failing) {
      result.layers.clear();
      result.failure = "fake exited with 1";
      result.log = options.work / "log";
      write_text(result.log, "line one\nout of cheese\n");
    }
    sink(std::move(result));
    if (!behaviour->breakdown.empty()) throw std::runtime_error(behaviour->breakdown);
  }
}

Driver fake_driver() {
  return {"fake", "Fake Renderer", "fake-package", 1, find_fake, fake_source, render_fake};
}

struct Obtain : InFolder {
  Behaviour it;
  std::vector<std::string> warnings;
  Store store;
  std::vector<Scene> scenes{sample_scene("one", 0.1), sample_scene("two", 0.2),
                            sample_scene("three", 0.3)};
  ObtainOptions options;

  void SetUp() override {
    InFolder::SetUp();
    behaviour = &it;
    store = open_store(folder / "store", [this](const std::string& s) { warnings.push_back(s); });
    options.store = &store;
    options.program_version = "0.1.0";
    options.stored_images = folder / "images";
    options.reference.work = folder / "work";
  }
  std::vector<ObtainedReference> run() const { return obtain(scenes, fake_driver(), options); }
  void ship(const Scene& scene, const std::string& renderer = "fake") const {
    save_stored(scene, renderer, {sample_layers(scene, 9), "0.9", "fake of old", 3},
                options.stored_images);
  }
};

TEST_F(Obtain, RendersWhatTheStoreLacks) {
  const auto got = run();
  ASSERT_EQ(got.size(), 3u);
  EXPECT_EQ(got[1].scene, "two");
  EXPECT_EQ(got[1].reference, "fake");
  EXPECT_EQ(got[1].source, "live");
  EXPECT_TRUE(got[1].rendered_now);
  EXPECT_EQ(got[1].version, "1.0");
  EXPECT_EQ(got[1].command, "fake two");
  EXPECT_EQ(got[1].seconds, 2);
  ASSERT_EQ(got[1].layers.size(), 3u);
  EXPECT_EQ(got[1].layers[0].picture.pixels[0], glm::dvec3(1.0f / 3.0f));
  EXPECT_EQ(it.rendered, 3);
}

TEST_F(Obtain, TakesFromTheStoreWhatItHas) {
  const auto fresh = run();
  const auto kept = run();
  EXPECT_EQ(it.rendered, 3);
  EXPECT_FALSE(kept[2].rendered_now);
  EXPECT_EQ(kept[2].source, "live");
  EXPECT_EQ(kept[2].version, "1.0");
  EXPECT_EQ(kept[2].command, "fake three");
  EXPECT_EQ(kept[2].seconds, 2);
  ASSERT_EQ(kept[2].layers.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE(same(kept[2].layers[i].picture, fresh[2].layers[i].picture)) << i;
}

TEST_F(Obtain, RendersOnlyTheMissingScenes) {
  run();
  scenes.push_back(sample_scene("four", 0.4));
  const auto got = run();
  EXPECT_EQ(it.rendered, 4);
  EXPECT_TRUE(got[3].rendered_now);
  EXPECT_FALSE(got[0].rendered_now);
}

TEST_F(Obtain, RendersAgainForAnotherVersionOrSource) {
  run();
  it.version = "1.1";
  run();
  EXPECT_EQ(it.rendered, 6);
  it.source_suffix = " as exported otherwise";
  run();
  EXPECT_EQ(it.rendered, 9);
  options.program_version = "0.2.0";
  run();
  EXPECT_EQ(it.rendered, 12);
}

TEST_F(Obtain, RendersAllAgainWhenAskedTo) {
  run();
  options.fresh = true;
  EXPECT_TRUE(run()[0].rendered_now);
  EXPECT_EQ(it.rendered, 6);
}

TEST_F(Obtain, WorksWithoutAStore) {
  options.store = nullptr;
  run();
  EXPECT_EQ(run()[0].source, "live");
  EXPECT_EQ(it.rendered, 6);
}

TEST_F(Obtain, MakesADamagedEntryAgain) {
  run();
  for (const auto& file : fs::recursive_directory_iterator(store.root))
    if (file.path().filename() == "image.exr") fs::resize_file(file.path(), 50);
  EXPECT_TRUE(run()[0].rendered_now);
  EXPECT_EQ(it.rendered, 6);
  EXPECT_EQ(warnings.size(), 3u);  // the first layer of each scene
}

TEST_F(Obtain, ReportsAFailureWithTheEndOfTheLogAndUsesNoStoredImage) {
  for (const auto& scene : scenes) ship(scene);
  it.failing = "two";
  const auto got = run();
  EXPECT_EQ(got[1].failure, "fake exited with 1");
  EXPECT_THAT(got[1].log, HasSubstr("out of cheese"));
  EXPECT_EQ(got[1].source, "");
  EXPECT_THAT(got[1].layers, IsEmpty());
  EXPECT_EQ(got[0].source, "live");
  EXPECT_EQ(got[2].source, "live");
}

TEST_F(Obtain, TriesAFailedSceneAgainNextTime) {
  it.failing = "two";
  run();
  it.failing = "";
  EXPECT_EQ(run()[1].source, "live");
  EXPECT_EQ(it.rendered, 4);
}

TEST_F(Obtain, ReportsASceneThatTheDriverNeverMentions) {
  it.silent = "one";
  EXPECT_EQ(run()[0].failure, "Fake Renderer: gave no result");
}

TEST_F(Obtain, ReportsABrokenDownDriverAndKeepsWhatWasDone) {
  it.breakdown = "disk full";
  const auto got = run();
  EXPECT_EQ(got[0].source, "live");
  EXPECT_EQ(got[1].failure, "Fake Renderer: disk full");
  it.breakdown = "";
  EXPECT_FALSE(run()[0].rendered_now);
}

TEST_F(Obtain, RefusesTheWrongLayers) {
  it.misshapen = "three";
  EXPECT_EQ(run()[2].failure, "fake gave a wrong image: 2 layers where the scene has 3");
}

TEST_F(Obtain, SkipsWhatTheRendererCannotExpress) {
  it.inexpressible = "one";
  const auto got = run();
  EXPECT_EQ(got[0].skipped, "Fake Renderer cannot express it: no such light");
  EXPECT_EQ(got[0].failure, "");
  EXPECT_EQ(got[1].source, "live");
}

TEST_F(Obtain, KeepsTwoScenesOfOneNameApart) {
  scenes = {sample_scene("one", 0.1), sample_scene("one", 0.2)};
  scenes[1].width = 9;
  const auto got = run();
  EXPECT_EQ(got[0].layers[0].picture.width, 6);
  EXPECT_EQ(got[1].layers[0].picture.width, 9);
}

TEST_F(Obtain, UsesStoredImagesWhereTheRendererIsMissing) {
  it.installed = false;
  ship(scenes[0]);
  const auto got = run();
  EXPECT_EQ(got[0].source, "stored");
  EXPECT_EQ(got[0].version, "0.9");
  EXPECT_EQ(got[0].command, "fake of old");
  EXPECT_EQ(got[0].layers.size(), 3u);
  EXPECT_EQ(got[1].source, "");
  EXPECT_EQ(got[1].failure, "");
  EXPECT_EQ(
      got[1].skipped,
      "Fake Renderer is not installed: apt-get install fake-package; no stored fake image of two");
}

TEST_F(Obtain, NeverUsesTheStoredImagesOfAnotherRenderer) {
  it.installed = false;
  ship(scenes[0], "other");
  EXPECT_EQ(run()[0].source, "");
}

TEST_F(Obtain, LiveWithoutTheRendererIsAFailure) {
  it.installed = false;
  options.sources = Sources::Live;
  ship(scenes[0]);
  const auto got = run();
  EXPECT_EQ(got[0].failure, "Fake Renderer is not installed: apt-get install fake-package");
  EXPECT_EQ(got[0].source, "");
}

TEST_F(Obtain, StoredDoesNotStartTheRenderer) {
  options.sources = Sources::Stored;
  ship(scenes[0]);
  const auto got = run();
  EXPECT_EQ(got[0].source, "stored");
  EXPECT_EQ(got[1].skipped, "no stored fake image of two");
  EXPECT_EQ(it.rendered, 0);
}

TEST_F(Obtain, ServesSeveralThreadsAtOnce) {
  std::vector<std::vector<ObtainedReference>> got(4);
  std::vector<std::thread> threads;
  for (auto& mine : got)
    threads.emplace_back([this, &got, &mine] {
      auto own = options;
      own.reference.work = folder / fmt::format("work-{}", &mine - got.data());
      mine = obtain(scenes, fake_driver(), own);
    });
  for (auto& thread : threads) thread.join();
  for (const auto& mine : got)
    for (const auto& result : mine) EXPECT_EQ(result.source, "live");
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(SourcesWord, IsOneOfThree) {
  EXPECT_EQ(parse_sources("auto"), Sources::Auto);
  EXPECT_EQ(parse_sources("live"), Sources::Live);
  EXPECT_EQ(parse_sources("stored"), Sources::Stored);
  EXPECT_THROW(parse_sources("both"), Refusal);
}

}  // namespace
}  // namespace litmus

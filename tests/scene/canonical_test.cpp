// canonical_test.cpp: the canonical scenes load, say what they show, and can be found by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdlib>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "scene/load.h"
#include "scene/observer.h"
#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

std::string name_complaint(const std::string& name) {
  try {
    find_scene(name);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return {};
}

const std::vector<Scene>& canonical() {
  static const std::vector<Scene> scenes = load_canonical_scenes().scenes;
  return scenes;
}

TEST(CanonicalScenes, LoadWithoutWarningsAndSayWhatTheyShow) {
  for (const Scene& scene : canonical()) {
    SCOPED_TRACE(scene.name);
    const bool stands_in = scene.spectra && colord_file("illuminant/CIE-D65.sp").empty();
    EXPECT_EQ(scene.warnings.empty(), !stands_in);
    EXPECT_GE(scene.about.size(), 30u);
    EXPECT_TRUE(scene.about.ends_with('.'));
    EXPECT_FALSE(scene.tags.empty());
    for (const Light& light : scene.lights)
      EXPECT_THAT(scene.tags, testing::Contains(std::string(light_type(light))));
  }
}

/// All but the mean of several samples and the mesh of 81,920 triangles are known beforehand, at
/// least in part.
TEST(CanonicalScenes, NameTheClosedFormsThatHoldInThem) {
  for (const Scene& scene : canonical()) {
    // Closed forms are of pixel centres.
    EXPECT_EQ(scene.expect.empty(), scene.samples > 1) << scene.name;
  }
}

TEST(CanonicalScenes, HaveUniqueIdsAndPictures) {
  std::set<std::string> ids, fingerprints;
  for (const auto& file : canonical_scenes()) {
    const std::string name = file.stem().string();
    EXPECT_TRUE(ids.insert(name.substr(0, name.find('-'))).second) << name;
  }
  for (const Scene& scene : canonical())
    EXPECT_TRUE(fingerprints.insert(fingerprint(scene)).second) << scene.name;
  for (const char* id : {"a1",  "a2",  "a3", "a4", "d1", "d2", "d3", "d4", "d5", "d6", "d7",  "d8",
                         "d9",  "p1",  "p2", "p3", "p4", "p5", "p6", "p7", "p8", "p9", "p10", "p11",
                         "p12", "p13", "s1", "s2", "s3", "s4", "s5", "s6", "s7", "s8", "s9",  "s10",
                         "r1",  "r2",  "r3", "r4", "r5", "r6", "r7", "r8", "r9", "c1", "c2",  "c3",
                         "c4",  "c5",  "c6", "v1", "v2", "v3", "v4", "v5", "v6", "v7", "v8",  "v9",
                         "v10", "v11", "x1", "x2", "x3", "x4", "x5", "w1", "w2", "w3", "w4"})
    EXPECT_TRUE(ids.contains(id)) << id;
}

/// What the references can be held to in seconds: Blender renders each sample of an area light
/// apart.
TEST(CanonicalScenes, AreCheapForTheReferences) {
  for (const Scene& scene : canonical()) {
    SCOPED_TRACE(scene.name);
    EXPECT_LE(scene.width * scene.height, 240 * 180);
    for (const Light& light : scene.lights)
      if (const auto* area = std::get_if<AreaLight>(&light.shape)) {
        EXPECT_LE(area->columns * area->rows, 20);
      }
  }
}

/// An infinite plane is a finite one in Blender, so each ray must reach it soon: the angle between
/// the floor and the highest ray of a perspective camera is at least 10 degrees.
TEST(CanonicalScenes, ShowNoHorizon) {
  for (const Scene& scene : canonical()) {
    if (scene.camera.projection != Projection::Perspective) continue;
    for (const Object& object : scene.objects) {
      const auto* plane = std::get_if<Plane>(&object.shape);
      if (!plane) continue;
      const Vector view = glm::normalize(scene.camera.target - scene.camera.eye);
      const double down = -std::asin(glm::dot(view, glm::normalize(plane->normal)));
      EXPECT_GE(down - scene.camera.fov / 2, 10 * M_PI / 180) << scene.name;
    }
  }
}

/// What can be loaded on a machine without colord-data.
CanonicalScenes without_colord() {
  const char* set = std::getenv("XDG_DATA_DIRS");
  const std::string before = set ? set : "";
  setenv("XDG_DATA_DIRS", "/nonexistent", 1);
  CanonicalScenes all = load_canonical_scenes();
  set ? setenv("XDG_DATA_DIRS", before.c_str(), 1) : unsetenv("XDG_DATA_DIRS");
  return all;
}

TEST(CanonicalScenes, WhoseDataIsNotInstalledAreLeftOutWithAReason) {
  const CanonicalScenes all = without_colord();
  ASSERT_EQ(all.left_out.size(), 1u);
  EXPECT_THAT(all.left_out[0], HasSubstr("w2-chart.toml:"));
  EXPECT_THAT(all.left_out[0], HasSubstr("apt-get install colord-data"));
  EXPECT_EQ(all.scenes.size() + 1, canonical_scenes().size());
  for (const Scene& scene : all.scenes) EXPECT_NE(scene.name, "w2-chart");
}

TEST(CanonicalScenes, AreAllThereWithTheDataInstalled) {
  if (colord_file("ref/CIE-TCS.sp").empty()) GTEST_SKIP() << "colord-data is not installed";
  const CanonicalScenes all = load_canonical_scenes();
  EXPECT_TRUE(all.left_out.empty());
  EXPECT_EQ(all.scenes.size(), canonical_scenes().size());
}

/// A colour that stands in for the CIE's makes another scene, and says so itself.
TEST(CanonicalScenes, SayWhichColoursStandIn) {
  for (const Scene& scene : without_colord().scenes) {
    if (!scene.spectra) continue;
    EXPECT_EQ(!scene.spectra->note.empty(), scene.name == "w4-metamers") << scene.name;
  }
}

TEST(FindScene, TakesANameAnIdOrAPathInAnyCase) {
  const auto file = find_scene("d5-sun-shadow");
  EXPECT_EQ(file.filename(), "d5-sun-shadow.toml");
  EXPECT_EQ(find_scene("D5"), file);
  EXPECT_EQ(find_scene("d5-Sun-Shadow"), file);
  EXPECT_EQ(find_scene(file.string()), file);
}

TEST(FindScene, DoesNotTakeTheBeginningOfAnId) {
  EXPECT_EQ(find_scene("s1").filename(), "s1-spot-linear.toml");
  EXPECT_EQ(find_scene("s10").filename(), "s10-spot-shadow.toml");
}

TEST(FindScene, NamesTheNearestWhereThereIsNone) {
  EXPECT_THAT(name_complaint("d5-sun-shado"), HasSubstr("did you mean d5-sun-shadow"));
  EXPECT_THAT(name_complaint("spot"), HasSubstr("s5-spot-tilted"));
  EXPECT_THAT(name_complaint("nothing-like-it"), HasSubstr("`litmus list`"));
  EXPECT_THAT(name_complaint("no/such.toml"), HasSubstr("no such scene file"));
}

TEST(DataDirectory, IsWhatTheEnvironmentSays) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "canonical");
  folder.write("canonical/q1-mine.toml", kScratchScene);
  setenv("LITMUS_DATA", folder.path().c_str(), 1);
  const auto data = data_directory();
  const auto scenes = canonical_scenes();
  const auto found = find_scene("q1");
  unsetenv("LITMUS_DATA");
  EXPECT_EQ(data, folder.path());
  EXPECT_EQ(scenes.size(), 1u);
  EXPECT_EQ(found, folder.path() / "canonical" / "q1-mine.toml");
}

TEST(DataDirectory, MustHoldScenes) {
  const ScratchFolder folder;
  setenv("LITMUS_DATA", folder.path().c_str(), 1);
  EXPECT_THROW(canonical_scenes(), Refusal);
  unsetenv("LITMUS_DATA");
}

}  // namespace
}  // namespace litmus

// migration_test.cpp: another version stands beside the old one, with figures and pictures of both.
#include "reports/migration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/stored_images.h"
#include "scene/load.h"
#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A run of s3 by a stand-in: the stored pictures with an error, as if another version had made
/// them.
struct MigrationPage : testing::Test {
  std::vector<Scene> scenes{load_scene(find_scene("s3"))};
  Study study;

  void SetUp() override {
    StudyOptions options;
    options.obtain.sources = Sources::Stored;
    options.references = {"blender"};
    study = run_study(scenes, options);
    study.cases[0].references[0].source = "live";
  }
  /// Adds `error` everywhere and judges anew by hand.
  void render_with(const std::string& version, double error) {
    study.cases[0].references[0].version = version;
    for (CaseLayer& layer : study.cases[0].layers)
      for (glm::dvec3& pixel : layer.theirs[0].picture.pixels) pixel += error;
    for (Comparison& row : study.comparisons) row.verdict = error > 1e-3 ? "fail" : "pass";
  }
  std::vector<Migration> found(const Study* baseline = nullptr) const {
    return migrations(study, scenes, baseline, stored_images_directory());
  }
};

TEST_F(MigrationPage, HasNothingOfTheVersionThatIsStored) { EXPECT_THAT(found(), IsEmpty()); }

TEST_F(MigrationPage, PutsOldAndNewSideBySidePerLight) {
  render_with("9.9", 0.01);
  const std::vector<Migration> all = found();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].old_version, "3.4.1");
  EXPECT_EQ(all[0].new_version, "9.9");
  ASSERT_EQ(all[0].layers.size(), 3u) << "ambient, the spot and their whole";
  for (const MigrationLayer& layer : all[0].layers) {
    EXPECT_NEAR(layer.apart, 0.01, 1e-12);
    EXPECT_LT(layer.old_max, 1e-4);
    EXPECT_NEAR(layer.new_max, 0.01, 1e-4);
    EXPECT_EQ(layer.old_verdict, "pass");
    EXPECT_EQ(layer.new_verdict, "fail");
  }
}

TEST_F(MigrationPage, ShowsThreePicturesOfEachLightAndBothVersions) {
  render_with("9.9", 0.01);
  const std::string page = migration_html(found());
  std::size_t pictures = 0;
  for (std::size_t at = page.find("<img src=\"data:"); at != page.npos;
       at = page.find("<img src=\"data:", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 3u * 3);
  EXPECT_THAT(page, HasSubstr("s3-spot-sharp: Blender Cycles 3.4.1 \u2192 9.9"));
  EXPECT_THAT(page, HasSubstr("verdicts change in 1"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST_F(MigrationPage, TakesTheBaselinesFiguresWhereNoPictureOfTheOldVersionIsKept) {
  Study baseline = study;
  baseline.cases[0].references[0].version = "2.93";
  const std::vector<Migration> all = found(&baseline);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].old_version, "2.93");
  EXPECT_FALSE(all[0].pictures);
  EXPECT_EQ(all[0].layers[0].old_max, all[0].layers[0].new_max);
  EXPECT_THAT(migration_html(all), HasSubstr("its pictures are not"));
}

TEST_F(MigrationPage, IsRemovedWhereNothingMigrated) {
  std::string name = (fs::temp_directory_path() / "litmus-migration-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  render_with("9.9", 0.01);
  write_migration(found(), folder);
  EXPECT_TRUE(fs::exists(folder / "migration.html"));
  write_migration({}, folder);
  EXPECT_TRUE(fs::is_empty(folder));
  fs::remove_all(folder);
}

TEST_F(MigrationPage, KeepsHostileTextInert) {
  render_with(kHostile, 0.01);
  EXPECT_THAT(migration_html(found()), Not(HasSubstr("<img src=x")));
}

}  // namespace
}  // namespace litmus

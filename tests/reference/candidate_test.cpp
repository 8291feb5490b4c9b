// candidate_test.cpp: a candidate's command is run for each light, its images are checked, its
// failures are told; shell scripts stand in for renderers.
#include "reference/candidate.h"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "compare/image_io.h"
#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class CandidateTest : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    store = open_store(folder / "store");
    options.store = &store;
    options.program_version = "test";
    options.reference.work = folder / "work";
    write_picture(folder / "picture.exr", sample_picture(6, 4, 1));
  }

  /// A candidate whose command is this shell script; it gets scene, light, output, width, height.
  Candidate script(const std::string& text) const {
    write_text(folder / "script.sh", "folder='" + folder.string() + "'\n" + text);
    Candidate candidate;
    candidate.name = "mine";
    candidate.folder = folder;
    candidate.command = {"sh",       "script.sh", "{scene}", "{light}",
                         "{output}", "{width}",   "{height}"};
    return candidate;
  }
  ObtainedReference run(const Candidate& candidate) const {
    return obtain_candidate(std::vector{scene}, candidate, options).front();
  }

  const Scene scene = sample_scene("sample");
  Store store;
  ObtainOptions options;
  const std::string copies = "cp \"$folder/picture.exr\" \"$3.exr\"\n";
};

TEST_F(CandidateTest, IsRunOnceForEachLightWithItsWordsFilledIn) {
  const auto result = run(script(
      "echo \"$2 $4 $5\" >> \"$folder/calls\"; cp \"$1\" \"$folder/scene.json\"\n" + copies));
  EXPECT_EQ(result.failure, "");
  EXPECT_EQ(result.source, "live");
  EXPECT_EQ(text_of(folder / "calls"), "ambient 6 4\nkey 6 4\nsun 6 4\n");
  EXPECT_EQ(nlohmann::json::parse(text_of(folder / "scene.json"))["litmus_scene"], 1);
  ASSERT_EQ(result.layers.size(), 3u);
  EXPECT_EQ(result.layers[1].light_type, "point");
  EXPECT_TRUE(same(result.layers[2].picture, sample_picture(6, 4, 1)));
}

TEST_F(CandidateTest, IsTakenFromTheStoreUntilItsScriptChanges) {
  const Candidate first = script(copies);
  EXPECT_TRUE(run(first).rendered_now);
  EXPECT_FALSE(run(first).rendered_now);
  const Candidate changed = script(copies + "# another\n");
  EXPECT_TRUE(run(changed).rendered_now);
  Candidate louder = changed;
  louder.command.push_back("--louder");
  EXPECT_TRUE(run(louder).rendered_now);
}

TEST_F(CandidateTest, FailsWithTheEndOfItsLog) {
  const auto result = run(script("echo no lamp >&2; exit 3\n"));
  EXPECT_THAT(result.failure, HasSubstr("light \"ambient\""));
  EXPECT_THAT(result.failure, HasSubstr("exited with 3"));
  EXPECT_THAT(result.log, HasSubstr("no lamp"));
}

TEST_F(CandidateTest, FailsWithoutAnImageAndSaysHowToNameIt) {
  EXPECT_THAT(run(script("true\n")).failure, HasSubstr("{output}.pfm"));
}

TEST_F(CandidateTest, FailsWithAnImageThatIsNotOne) {
  EXPECT_THAT(run(script("echo hello > \"$3.exr\"\n")).failure, HasSubstr("not a readable image"));
}

TEST_F(CandidateTest, FailsWithAnImageOfAnotherSize) {
  write_picture(folder / "picture.exr", sample_picture(4, 6, 1));
  EXPECT_THAT(run(script(copies)).failure, HasSubstr("4 x 6 pixels instead of 6 x 4"));
}

TEST_F(CandidateTest, FailsWithAPixelThatIsNotFinite) {
  Picture picture = sample_picture(6, 4, 1);
  picture.at(5, 2).y = std::numeric_limits<double>::infinity();
  write_picture(folder / "picture.exr", picture);
  EXPECT_THAT(run(script(copies)).failure, HasSubstr("pixel at 5, 2"));
}

TEST_F(CandidateTest, IsEndedByItsTimeLimit) {
  Candidate slow = script("sleep 30\n");
  slow.time_limit = std::chrono::seconds(1);
  EXPECT_THAT(run(slow).failure, HasSubstr("1 s"));
}

TEST_F(CandidateTest, FailsWithoutItsProgram) {
  Candidate candidate = script(copies);
  candidate.command[0] = "no-such-program-of-litmus";
  EXPECT_THAT(run(candidate).failure, HasSubstr("no-such-program-of-litmus"));
}

TEST_F(CandidateTest, MayDeclineASceneWithAReason) {
  const auto result = run(script("echo starting; echo no meshes here; exit 77\n"));
  EXPECT_EQ(result.failure, "");
  EXPECT_THAT(result.skipped, HasSubstr("declined the scene: no meshes here"));
  EXPECT_TRUE(result.layers.empty());
}

TEST_F(CandidateTest, MayBeAFolderOfImages) {
  Candidate candidate;
  candidate.name = "old";
  candidate.images = folder / "images";
  for (const char* light : {"ambient", "key", "sun"}) {
    fs::create_directories(candidate.images / "sample");
    write_picture(candidate.images / "sample" / (std::string(light) + ".exr"),
                  sample_picture(6, 4, 2));
  }
  EXPECT_EQ(run(candidate).source, "stored");
  EXPECT_EQ(run(candidate).layers.size(), 3u);
  fs::remove(candidate.images / "sample/sun.exr");
  EXPECT_THAT(run(candidate).failure, HasSubstr("no sun.exr or .pfm"));
  fs::remove_all(candidate.images / "sample");
  EXPECT_EQ(run(candidate).failure, "");
  EXPECT_THAT(run(candidate).skipped, HasSubstr("no folder"));
}

TEST_F(CandidateTest, GivesLightWithoutTheExposure) {
  Candidate candidate = script(copies);
  candidate.encoding.exposure = 4;
  const Picture light = run(candidate).layers.at(0).picture;
  EXPECT_EQ(light.at(3, 3).x, sample_picture(6, 4, 1).at(3, 3).x / 4);
}

TEST_F(CandidateTest, DecodesAPngOnlyIfItIsSaidToBeOne) {
  const std::vector<std::uint8_t> grey(6 * 4 * 3, 128);
  write_text(folder / "picture.png", encode_png(6, 4, grey));
  Candidate candidate = script("cp \"$folder/picture.png\" \"$3.png\"\n");
  candidate.encoding = {8, true};
  EXPECT_NEAR(run(candidate).layers.at(0).picture.at(0, 0).x, 0.2158605, 1e-6);
  candidate.encoding = {};
  EXPECT_THAT(run(candidate).failure, HasSubstr(".exr or .pfm"));
}

}  // namespace
}  // namespace litmus

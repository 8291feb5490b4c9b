// candidates_file_test.cpp: litmus.toml is read strictly.
#include "reference/candidates_file.h"

#include <gmock/gmock.h>

#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class CandidatesFile : public InFolder {
 protected:
  std::vector<Candidate> load(const std::string& text) const {
    write_text(folder / "litmus.toml", text);
    return load_candidates(folder / "litmus.toml");
  }
  std::string complaint(const std::string& text) const {
    try {
      load(text);
    } catch (const Refusal& refusal) {
      return refusal.what();
    }
    return {};
  }
  const std::string good =
      "[[candidate]]\nname = \"mine\"\ncommand = [\"x\", \"{scene}\", \"{light}\", "
      "\"{output}.pfm\"]\n";
};

TEST_F(CandidatesFile, GivesEveryField) {
  std::filesystem::create_directories(folder / "old");
  const auto candidates = load(good +
                               "encoding = \"png8-srgb\"\nexposure = 0.5\ntime_limit = 7\n"
                               "expect = \"differs\"\n[[candidate]]\nname = \"b\"\nimages = "
                               "\"old\"\n");
  ASSERT_EQ(candidates.size(), 2u);
  EXPECT_EQ(candidates[0].name, "mine");
  EXPECT_THAT(candidates[0].command, ElementsAre("x", "{scene}", "{light}", "{output}.pfm"));
  EXPECT_EQ(name_of(candidates[0].encoding), "png8-srgb");
  EXPECT_EQ(candidates[0].encoding.exposure, 0.5);
  EXPECT_EQ(candidates[0].time_limit, std::chrono::seconds(7));
  EXPECT_TRUE(candidates[0].expected_to_differ);
  EXPECT_EQ(candidates[1].images, folder / "old");
  EXPECT_EQ(name_of(candidates[1].encoding), "float");
  EXPECT_FALSE(candidates[1].expected_to_differ);
}

TEST_F(CandidatesFile, NamesThePlaceOfAMistakeAndTheRemedy) {
  EXPECT_THAT(complaint(good + "encodng = \"float\"\n"),
              HasSubstr("litmus.toml:4:1: encodng: unknown key in a candidate; did you mean "
                        "\"encoding\"?"));
  EXPECT_THAT(complaint(good + "encoding = \"jpeg\"\n"),
              HasSubstr("litmus.toml:4:12: encoding: must be \"float\""));
  EXPECT_THAT(complaint(good + "exposure = 0\n"), HasSubstr("litmus.toml:4:12: exposure: must be"));
  EXPECT_THAT(complaint(good + "time_limit = 0.5\n"), HasSubstr("time_limit: must be a whole"));
  EXPECT_THAT(complaint(good + "expect = \"nothing\"\n"), HasSubstr("\"equal\" or \"differs\""));
  EXPECT_THAT(complaint("[[candidates]]\n"), HasSubstr("did you mean \"candidate\"?"));
  EXPECT_THAT(complaint(""), HasSubstr("a table headed [[candidate]]"));
}

TEST_F(CandidatesFile, WantsEitherACommandOrImages) {
  EXPECT_THAT(complaint("[[candidate]]\nname = \"a\"\n"),
              HasSubstr("either a command or a folder"));
  EXPECT_THAT(complaint(good + "images = \".\"\n"), HasSubstr("either a command or a folder"));
  EXPECT_THAT(complaint("[[candidate]]\nname = \"a\"\nimages = \"none\"\n"),
              HasSubstr("there is no folder"));
  EXPECT_THAT(complaint("[[candidate]]\nname = \"a\"\nimages = \".\"\ntime_limit = 1\n"),
              HasSubstr("unknown key"));
}

TEST_F(CandidatesFile, WantsACommandThatSaysWhichLightToRenderAndWhere) {
  for (const char* word : {"{scene}", "{light}", "{output}"}) {
    std::string text = good;
    text.replace(text.find(word), std::string(word).size(), "x");
    EXPECT_THAT(complaint(text), HasSubstr(std::string("command: must mention ") + word));
  }
  EXPECT_THAT(complaint("[[candidate]]\nname = \"a\"\ncommand = []\n"),
              HasSubstr("must name a program"));
}

TEST_F(CandidatesFile, RefusesANameThatIsTakenOrNoWord) {
  EXPECT_THAT(complaint(good + good), HasSubstr("the name of an earlier candidate"));
  for (const char* name : {"povray", "litmus", "blender-native"}) {
    std::string text = good;
    text.replace(text.find("mine"), 4, name);
    EXPECT_THAT(complaint(text), HasSubstr("choose another name")) << name;
  }
  for (const char* name : {"a/b", "..", "<b>"}) {
    std::string text = good;
    text.replace(text.find("mine"), 4, name);
    EXPECT_THAT(complaint(text), HasSubstr("must be at most 60 letters")) << name;
  }
}

}  // namespace
}  // namespace litmus

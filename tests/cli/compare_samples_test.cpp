// compare_samples_test.cpp: litmus compare --samples, and the triage figures of litmus compare.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "compare/image_io.h"
#include "test_paths.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;

class SamplesProgram : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = std::filesystem::temp_directory_path() / "litmus-samples-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  Picture noise(double red_bias) {
    Picture picture(32, 32);
    for (glm::dvec3& pixel : picture.pixels)
      pixel = {0.5 + red_bias + 0.1 * normal(random), 0.4 + 0.1 * normal(random),
               0.3 + 0.1 * normal(random)};
    return picture;
  }

  void write(const std::string& side, int seeds, double red_bias = 0) {
    for (int k = 0; k < seeds; ++k)
      write_picture(folder / fmt::format("{}_{}.exr", side, k), noise(red_bias));
  }

  int compare(const std::string& arguments) {
    const std::string line =
        "cd '" + folder.string() + "' && " LITMUS_PROGRAM " compare " + arguments + " 2>&1";
    FILE* pipe = popen(line.c_str(), "r");
    text.clear();
    for (int c; (c = std::fgetc(pipe)) != EOF;) text += char(c);
    return WEXITSTATUS(pclose(pipe));
  }

  std::filesystem::path folder;
  std::string text;
  std::mt19937_64 random{4};
  std::normal_distribution<double> normal;
};

TEST_F(SamplesProgram, PassesTheSameRendererTwiceAndPrintsWhatItWouldFind) {
  write("a", 8), write("b", 8);
  EXPECT_EQ(compare("--samples 'a_*.exr' 'b_*.exr'"), 0) << text;
  EXPECT_THAT(text, HasSubstr("no difference found"));
  EXPECT_THAT(text, HasSubstr("bias of 0.05 sigma everywhere"));
}

TEST_F(SamplesProgram, FailsADifferenceAndNamesItsChannel) {
  write("a", 8), write("b", 8, 0.02), write("c", 8);
  ASSERT_EQ(compare("--json --samples 'a_*.exr' 'b_*.exr' 'a_*.exr' 'c_*.exr'"), 1) << text;
  const auto json = nlohmann::json::parse(text);
  ASSERT_EQ(json["comparisons"].size(), 2u);
  EXPECT_EQ(json["comparisons"][0]["verdict"], "fail");
  EXPECT_EQ(json["comparisons"][0]["mean"]["channel"], "red");
  EXPECT_NEAR(json["comparisons"][0]["mean"]["difference"].get<double>(), -0.02, 0.005);
  EXPECT_EQ(json["comparisons"][1]["verdict"], "pass");
}

TEST_F(SamplesProgram, ComparesFilesWithPartsLightByLight) {
  for (int k = 0; k < 8; ++k)
    for (const std::string side : {"a", "b"}) {
      const Layers layers{{"ambient", "ambient", noise(0)},
                          {"key", "spot", noise(side == "b" ? 0.05 : 0)}};
      write_layers(folder / fmt::format("{}_{}.exr", side, k), layers, {{"scene", "any"}});
    }
  ASSERT_EQ(compare("--json --samples 'a_*.exr' 'b_*.exr'"), 1) << text;
  const auto json = nlohmann::json::parse(text);
  ASSERT_EQ(json["comparisons"].size(), 3u);
  EXPECT_EQ(json["comparisons"][0]["verdict"], "pass") << "ambient";
  EXPECT_EQ(json["comparisons"][1]["layer"], "key");
  EXPECT_EQ(json["comparisons"][1]["verdict"], "fail");
}

TEST_F(SamplesProgram, WarnsOfFewSeeds) {
  write("a", 3), write("b", 3);
  EXPECT_EQ(compare("--samples 'a_*.exr' 'b_*.exr'"), 0);
  EXPECT_THAT(text, HasSubstr("fewer than 8 seeds"));
}

TEST_F(SamplesProgram, RefusesPatternsWithoutFilesOrWithoutAPartner) {
  write("a", 2);
  EXPECT_EQ(compare("--samples 'a_*.exr' 'z_*.exr'"), 2);
  EXPECT_THAT(text, HasSubstr("'z_*.exr'"));
  EXPECT_EQ(compare("--samples 'a_*.exr' 'a_*.exr' 'a_*.exr'"), 2);
  EXPECT_THAT(text, HasSubstr("pairs"));
  EXPECT_EQ(compare("a_0.exr"), 2);
  EXPECT_THAT(text, HasSubstr("two image files"));
}

TEST_F(SamplesProgram, OfTwoFilesPrintsTheTriageFigures) {
  write("a", 2);
  EXPECT_EQ(compare("a_0.exr a_1.exr"), 1);
  EXPECT_THAT(text, HasSubstr("HDR-FLIP"));
  EXPECT_EQ(compare("a_0.exr a_0.exr --json"), 0);
  const auto triage = nlohmann::json::parse(text)[0]["triage"];
  EXPECT_EQ(triage["ldr_flip"], 0);
  EXPECT_EQ(triage["hdr_flip"], 0);
  EXPECT_EQ(triage["ssim"], 1);
}

}  // namespace
}  // namespace litmus

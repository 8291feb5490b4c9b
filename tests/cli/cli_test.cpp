// cli_test.cpp: the program as a person uses it: exit codes, messages, files.
#include <gmock/gmock.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/image_io.h"
#include "tests/cli/program_test.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// A scene of a user's own, which no stored image belongs to.
const std::string kOwnScene = R"(schema = 1
about = "A floor under the sun."
[image]
width = 8
height = 8
[camera]
projection = "orthographic"
eye = [0, 0, 1]
target = [0, 0, 0]
up = [0, 1, 0]
height = 2
[[material]]
name = "matte"
[[object]]
shape = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
material = "matte"
[[light]]
type = "directional"
direction = [0, 0, -1]
)";

class Program : public ProgramTest {
 protected:
  const std::string no_renderers = "PATH=/nonexistent";
};

TEST_F(Program, ExplainsEachCommandWithAnExample) {
  for (const char* command :
       {"run", "render", "export", "reference", "compare", "cost", "list", "doctor"}) {
    const Ended help = litmus(std::string(command) + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_NE(help.text.find(command == std::string("doctor") ? "Exit code" : "Example: litmus"),
              std::string::npos)
        << command;
  }
}

TEST_F(Program, RefusesUnknownWordsWithTwo) {
  EXPECT_EQ(litmus("").code, 2);
  EXPECT_EQ(litmus("fly").code, 2);
  EXPECT_EQ(litmus("run --references sometimes").code, 2);
  EXPECT_EQ(litmus("run no-such-scene").code, 2);
  EXPECT_EQ(litmus("run d1 --references stored --control no-such-control").code, 2);
}

TEST_F(Program, NeedsTheImageModuleForImagesAlone) {
  fs::copy_file(LITMUS_PROGRAM, folder / "alone");
  const auto alone = [&](const std::string& arguments) { return run("./alone", arguments); };
  for (const char* command : {"list", "render --help", "explain p1 3 4 --reference none"})
    EXPECT_EQ(alone(command).code, 0) << command;
  const Ended ended = alone("render p1 -o x.exr");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.text, testing::AllOf(testing::HasSubstr("liblitmus_images.so"),
                                         testing::HasSubstr("belongs into the program's folder")));
  EXPECT_FALSE(fs::exists(folder / "x.exr"));
  const Ended doctor = alone("doctor");
  EXPECT_EQ(doctor.code, 3);
  EXPECT_THAT(doctor.text, testing::HasSubstr("OpenImageIO     missing"));
}

TEST_F(Program, ListsTheCanonicalScenesForMachines) {
  const auto list = nlohmann::json::parse(litmus("list --json").text);
  ASSERT_GE(list.size(), 25u);
  for (const auto& scene : list) {
    for (const char* key : {"name", "about", "light_types", "tags", "oracles"})
      EXPECT_TRUE(scene.contains(key)) << scene;
  }
}

TEST_F(Program, NamesThePlaceAndTheFieldOfAMistakeInAScene) {
  write("bad.toml", kOwnScene + R"(
[[light]]
type = "spot"
origin = [0, 0, 1]
direction = [0, 0, -1]
cutoff_degrees = 200
exponent = 1
)");
  for (const char* command :
       {"run bad.toml", "render bad.toml -o x.exr", "export bad.toml --to povray"}) {
    const Ended ended = litmus(command);
    EXPECT_EQ(ended.code, 2) << command;
    EXPECT_NE(ended.text.find("bad.toml:27:"), std::string::npos) << ended.text;
    EXPECT_NE(ended.text.find("cutoff_degrees"), std::string::npos) << ended.text;
  }
  EXPECT_FALSE(fs::exists(folder / "x.exr"));
  EXPECT_FALSE(fs::exists(folder / "litmus-report"));
}

TEST_F(Program, RendersTheSamePictureAtEveryNumberOfThreads) {
  ASSERT_EQ(litmus("render x5 -o one.exr --threads 1").code, 0);
  ASSERT_EQ(litmus("render x5 -o two.exr --threads 2").code, 0);
  EXPECT_EQ(litmus("compare one.exr two.exr --tolerance 0").code, 0);
}

TEST_F(Program, RendersInEveryPrecision) {
  for (const char* precision : {"float", "double", "long-double", "quad"}) {
    ASSERT_EQ(litmus(std::string("render d2 -o x.exr --precision ") + precision).code, 0);
    EXPECT_NEAR(read_picture(folder / "x.exr").at(48, 48).x,
                read_picture(folder / "x.exr").at(48, 48).y, 1e-6);
  }
}

TEST_F(Program, RendersAreaLightsByEverySamplerAndBoundsTheError) {
  ASSERT_EQ(litmus("render r2 -o plain.exr").code, 0);
  ASSERT_EQ(
      litmus("render r2 -o sure.exr --sampler certified --area-samples 4 --bound bound.exr").code,
      0);
  ASSERT_EQ(litmus("render r2 -o two.exr --sampler gauss-legendre --area-samples 2").code, 0);
  const Picture plain = read_picture(folder / "plain.exr"),
                sure = read_picture(folder / "sure.exr");
  const Picture bound = read_picture(folder / "bound.exr");
  EXPECT_NE(plain.pixels, sure.pixels);
  int unsure = 0;
  for (const auto& pixel : bound.pixels) unsure += pixel.x > 1e-3;
  EXPECT_GT(unsure, 0);
  EXPECT_LT(unsure, int(bound.pixels.size())) << "lit and dark pixels are all but certain";
  EXPECT_EQ(litmus("render r2 -o x.exr --bound bound.exr").code, 2) << "the grid has no bound";
  EXPECT_EQ(litmus("render r2 -o x.exr --sampler certified --precision quad").code, 2);
  EXPECT_EQ(litmus("render r2 -o x.exr --sampler dice").code, 2);
  EXPECT_FALSE(fs::exists(folder / "x.exr"));
}

TEST_F(Program, WritesTheBandsOfASpectralSceneAndRefusesThemOfAnother) {
  const Ended written = litmus("render w1 --spectral bands.exr -o colors.exr");
  ASSERT_EQ(written.code, 0) << written.text;
  EXPECT_EQ(litmus("compare bands.exr colors.exr --tolerance 0").code, 0);
  const Ended refused = litmus("render d1 --spectral none.exr");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.text.find("names no spectrum"), std::string::npos) << refused.text;
  EXPECT_EQ(litmus("render w1").code, 2);
  EXPECT_EQ(litmus("render w1 --spectral bands.png").code, 2);
  EXPECT_FALSE(fs::exists(folder / "none.exr"));
}

TEST_F(Program, LeavesOutWhatNeedsAPackageThatIsNotInstalled) {
  setenv("XDG_DATA_DIRS", "/nonexistent", 1);
  const Ended listed = litmus("list"), refused = litmus("render w2 -o w2.exr");
  unsetenv("XDG_DATA_DIRS");
  EXPECT_EQ(listed.code, 0);
  EXPECT_NE(listed.text.find("left out"), std::string::npos);
  EXPECT_NE(listed.text.find("x1-sun"), std::string::npos);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.text.find("apt-get install colord-data"), std::string::npos) << refused.text;
}

TEST_F(Program, ExportsASpectralSceneThreeBandsAFile) {
  ASSERT_EQ(litmus("export w4 --to povray -o out").code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/w4-metamers-00.pov"));
  EXPECT_TRUE(fs::exists(folder / "out/w4-metamers-13.pov"));
  EXPECT_FALSE(fs::exists(folder / "out/w4-metamers.pov"));
}

TEST_F(Program, RefusesAnOutputItCannotWriteAndLeavesNothing) {
  EXPECT_EQ(litmus("render d1 -o picture.gif").code, 2);
  EXPECT_EQ(litmus("render d1 -o picture.exr --light no-such-light").code, 2);
  EXPECT_EQ(litmus("render d1 -o no/such/folder/picture.exr").code, 2);
  EXPECT_FALSE(fs::exists(folder / "picture.gif"));
  EXPECT_FALSE(fs::exists(folder / "picture.exr"));
}

TEST_F(Program, ExportsForBothRenderersExactlyAndNatively) {
  for (const char* target : {"povray", "blender"}) {
    for (const char* native : {"", " --native"}) {
      EXPECT_EQ(litmus(std::string("export x5 -o out --to ") + target + native).code, 0);
    }
  }
  for (const char* file : {"x5-all-lights.pov", "x5-all-lights.py", "x5-all-lights-native.pov",
                           "x5-all-lights-native.py"}) {
    EXPECT_GT(fs::file_size(folder / "out" / file), 1000u) << file;
  }
}

TEST_F(Program, ComparesTwoImagesWithoutAScene) {
  ASSERT_EQ(litmus("render d1 -o a.exr").code, 0);
  ASSERT_EQ(litmus("render d2 -o b.exr").code, 0);
  ASSERT_EQ(litmus("render d5 -o c.exr").code, 0);
  EXPECT_EQ(litmus("compare a.exr a.exr").code, 0);
  EXPECT_EQ(litmus("compare a.exr c.exr").code, 1);
  EXPECT_EQ(litmus("compare a.exr b.exr").code, 2);  // another size
  EXPECT_EQ(litmus("compare a.exr missing.exr").code, 2);
}

TEST_F(Program, FailsTheComparisonOfASingleNaN) {
  Picture picture(4, 4);
  write_picture(folder / "good.exr", picture);
  picture.at(1, 2).y = std::numeric_limits<double>::quiet_NaN();
  write_picture(folder / "bad.exr", picture);
  EXPECT_EQ(litmus("compare good.exr bad.exr --tolerance 1").code, 1);
  EXPECT_EQ(litmus("compare bad.exr bad.exr --tolerance 1").code, 1);
}

TEST_F(Program, WritesEveryReportOfAStoredRun) {
  const Ended ended = litmus("run d2 s5 --references stored --out report -q");
  EXPECT_EQ(ended.code, 0) << ended.text;
  for (const char* file : {"report.html", "results.json", "summary.md", "junit.xml"}) {
    EXPECT_GT(fs::file_size(folder / "report" / file), 200u) << file;
  }
  for (const auto& row : results("report")["comparisons"])
    EXPECT_EQ(row["source"], row["reference"] == "closed-form" ? "computed" : "stored");
}

TEST_F(Program, FailsARunWithAKnownMistake) {
  EXPECT_EQ(litmus("run s1 --references stored --control cutoff -q").code, 1);
  EXPECT_EQ(litmus("run d1 --references stored --control cutoff -q").code, 0);  // no spot in it
}

TEST_F(Program, WorksWithoutAnyRenderer) {
  const Ended ended = litmus("run d2 --out report -q", no_renderers);
  EXPECT_EQ(ended.code, 0) << ended.text;
  for (const auto& row : results("report")["comparisons"])
    EXPECT_EQ(row["source"], row["reference"] == "closed-form" ? "computed" : "stored");
}

TEST_F(Program, NeedsNeitherRendererNorStoredImageForClosedForms) {
  const Ended ended = litmus("run d5 --with closed-form --out report -q", no_renderers);
  EXPECT_EQ(ended.code, 0) << ended.text;
  for (const auto& row : results("report")["comparisons"]) {
    EXPECT_EQ(row["reference"], "closed-form");
    EXPECT_EQ(row["verdict"], "pass");
  }
  EXPECT_EQ(litmus("run s1 --with closed-form --control cutoff -q", no_renderers).code, 1);
}

TEST_F(Program, SaysThatALiveRunNeedsTheRenderer) {
  const Ended ended = litmus("run d2 --references live --out report -q", no_renderers);
  EXPECT_EQ(ended.code, 4);
  EXPECT_NE(ended.text.find("apt-get install"), std::string::npos) << ended.text;
  EXPECT_EQ(litmus("run d2 --require povray -q", no_renderers).code, 4);
}

TEST_F(Program, CallsARunWithNothingToCompareWithIncomplete) {
  write("own.toml", kOwnScene);
  const Ended ended = litmus("run own.toml --out report -q", no_renderers);
  EXPECT_EQ(ended.code, 3) << ended.text;
  for (const auto& row : results("report")["comparisons"]) EXPECT_EQ(row["verdict"], "skipped");
}

TEST_F(Program, SaysWhatIsMissing) {
  const Ended ended = litmus("doctor", no_renderers);
  EXPECT_EQ(ended.code, 3);
  EXPECT_NE(ended.text.find("apt-get install povray"), std::string::npos) << ended.text;
  EXPECT_NE(ended.text.find("apt-get install blender"), std::string::npos) << ended.text;
}

TEST_F(Program, AnnotatesFailuresInsideOfGitHubOnly) {
  const std::string failing = "run s1 --references stored --control cutoff -q";
  EXPECT_EQ(litmus(failing).text.find("::error"), std::string::npos);
  for (const Ended& ended :
       {litmus(failing, "GITHUB_ACTIONS=true"), litmus(failing + " --annotations github")}) {
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.text.find("::error file="), std::string::npos) << ended.text;
    EXPECT_NE(ended.text.find("s1-spot-linear.toml,line="), std::string::npos) << ended.text;
  }
  EXPECT_EQ(litmus(failing + " --annotations none", "GITHUB_ACTIONS=true").text.find("::error"),
            std::string::npos);
}

}  // namespace
}  // namespace litmus

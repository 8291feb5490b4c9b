// approve_test.cpp: litmus approve changes what a failing case needs, and refuses the rest.
#include <gmock/gmock.h>

#include <functional>

#include "reference/drivers.h"
#include "tests/cli/program_test.h"

namespace litmus {
namespace {
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// A copy of litmus's data in which Blender's tolerance inside is too small for s5.
struct Approve : ProgramTest {
  const std::string where = "LITMUS_DATA=data";
  const std::string file = "data/compare/tolerances.toml";

  void SetUp() override {
    ProgramTest::SetUp();
    const fs::path source = LITMUS_SOURCE;
    for (const char* each : {"data/scene/canonical", "data/compare"})
      fs::create_directories(folder / each);
    fs::copy(source / "compare/tolerances.toml", folder / "data/compare");
    for (const char* scene : {"s5-spot-tilted", "d2-sun-sphere", "d1-sun-floor"}) {
      fs::copy(source / "scene/canonical" / (std::string(scene) + ".toml"),
               folder / "data/scene/canonical");
      fs::create_directories(folder / "data/reference/images" / scene);
      fs::copy(source / "reference/images" / scene, folder / "data/reference/images" / scene);
    }
    tighten("blender");
  }
  /// Lowers what is allowed and seen of the reference's interior.
  void tighten(const std::string& reference) const {
    std::string text = text_of(file);
    const std::size_t table = text.find("reference = \"" + reference + "\"\nregion = \"interior\"");
    for (const char* key : {"\nmax_abs = ", "\nmean_abs = ", "\nseen_max = ", "\nseen_mean = "}) {
      const std::size_t start = text.find(key, table) + std::string(key).size();
      text.replace(start, text.find('\n', start) - start, "1e-11");
    }
    write(file, text);
  }
  Ended run(const std::string& rest = "s5 --references stored") const {
    return litmus("run " + rest + " -q", where);
  }
  Ended approve(const std::string& rest) const {
    return litmus("approve " + rest + " --reason 'Cycles rounds once more'", where);
  }
  /// Runs, changes the results by hand, and approves s5/blender.
  Ended approve_changed(const std::function<void(nlohmann::json&)>& change) const {
    EXPECT_EQ(run().code, 1);
    nlohmann::json json = results("litmus-report");
    change(json);
    write("litmus-report/results.json", json.dump());
    return approve("s5/blender");
  }
};

TEST_F(Approve, LetsTheFailingCasePassAndSaysWhatItChanged) {
  ASSERT_EQ(run().code, 1);
  const std::string before = text_of(file),
                    image = text_of("data/reference/images/s5-spot-tilted/blender.exr");
  const Ended approved = approve("s5/blender");
  ASSERT_EQ(approved.code, 0) << approved.text;
  EXPECT_THAT(approved.text, HasSubstr("--- data/compare/tolerances.toml\n+++ "));
  EXPECT_THAT(approved.text, HasSubstr("-max_abs = 1e-11\n+max_abs = "));
  EXPECT_THAT(text_of(file), HasSubstr("reason = \"Cycles rounds once more\""));
  EXPECT_NE(text_of(file), before);
  EXPECT_EQ(text_of("data/reference/images/s5-spot-tilted/blender.exr"), image)
      << "compared with a stored image, which stays";
  const Ended again = run();
  EXPECT_EQ(again.code, 0) << again.text;
}

TEST_F(Approve, ChangesNothingInADryRun) {
  ASSERT_EQ(run().code, 1);
  const std::string before = text_of(file);
  const Ended dry = approve("s5/blender --dry-run");
  EXPECT_EQ(dry.code, 0) << dry.text;
  EXPECT_THAT(dry.text, HasSubstr("+max_abs = "));
  EXPECT_EQ(text_of(file), before);
}

TEST_F(Approve, WantsAReasonAndACaseThatFails) {
  ASSERT_EQ(run().code, 1);
  const std::string before = text_of(file);
  EXPECT_EQ(litmus("approve s5/blender", where).code, 2);
  EXPECT_THAT(approve("s5/povray").text, HasSubstr("nothing fails there"));
  EXPECT_EQ(approve("s5/povray").code, 2);
  EXPECT_EQ(approve("x1").code, 2);
  EXPECT_EQ(approve("s5/mitsuba").code, 2);
  EXPECT_EQ(approve("s5 --results missing.json").code, 2);
  EXPECT_EQ(approve("s5/blender s5/povray").code, 2) << "one refusal refuses all";
  EXPECT_EQ(text_of(file), before);
}

TEST_F(Approve, RefusesPixelsThatAreNotFinite) {
  const std::string before = text_of(file);
  const Ended ended = approve_changed([](nlohmann::json& json) {
    for (auto& row : json["comparisons"])
      if (row["verdict"] == "fail") row["nonfinite"] = 1;
  });
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.text, HasSubstr("are NaN or infinite"));
  EXPECT_EQ(text_of(file), before);
}

TEST_F(Approve, RefusesPicturesThatAreUnregistered) {
  // A picture shifted by half a pixel, not marked as a planted mistake.
  ASSERT_EQ(run("d2 --references stored --with blender --control half-pixel").code, 1);
  nlohmann::json json = results("litmus-report");
  json["provenance"]["command"] = "litmus run d2";
  write("litmus-report/results.json", json.dump());
  const Ended ended = approve("d2/blender");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.text, HasSubstr("unregistered: shifted by"));
}

TEST_F(Approve, KeepsTheLivePictureOfAFailingCaseAndOfNoOther) {
  if (!find_driver("povray")->find())
    GTEST_SKIP() << "POV-Ray is not installed: apt-get install povray";
  const std::string about = "data/reference/images/s5-spot-tilted/povray.json";
  const std::string other = "data/reference/images/d2-sun-sphere/povray.json";
  for (const std::string& each : {about, other}) {
    nlohmann::json json = nlohmann::json::parse(text_of(each));
    json["renderer_version"] = "3.6";
    write(each, json.dump());
  }
  tighten("povray");
  ASSERT_EQ(run("s5 d2 --references live --with povray").code, 1);
  EXPECT_TRUE(fs::exists(folder / "litmus-report/migration.html")) << "3.6 is what is stored";
  const Ended approved = approve("s5/povray");
  ASSERT_EQ(approved.code, 0) << approved.text;
  EXPECT_THAT(approved.text, HasSubstr("-povray 3.6\n+povray 3.7"));
  EXPECT_THAT(text_of(about), HasSubstr("\"renderer_version\": \"3.7"));
  EXPECT_THAT(text_of(other), HasSubstr("\"3.6\""));
}

}  // namespace
}  // namespace litmus

// github_test.cpp: annotations are escaped as GitHub reads them, point at the light, and are few.
#include "reports/github.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/load.h"
#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::size_t lines(const std::string& text) {
  return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

TEST(GitHub, EscapesTextAndPropertiesAsItsRunnerReadsThem) {
  EXPECT_EQ(github_text("100 %: a,\r\nb"), "100 %25: a,%0D%0Ab");
  EXPECT_EQ(github_property("100 %: a,\r\nb"), "100 %25%3A a%2C%0D%0Ab");
  EXPECT_EQ(github_text("%0A"), "%250A") << "what looks escaped stays what it is";
}

TEST(GitHub, SaysNothingOfAPass) { EXPECT_EQ(github_annotations(passing_study()), ""); }

TEST(GitHub, NamesTheSceneFileAndTheLineOfTheLight) {
  Study study = passing_study();
  Case& one = study.cases[2];
  one.file = find_scene("s3").string();
  Scene scene = load_scene(one.file);
  for (Comparison& row : study.comparisons)
    if (row.scene == one.scene && row.light == "spot" && row.region == "interior")
      row.light = scene.lights[0].name, row.verdict = "fail", row.reason = "too far";
  const std::string text = github_annotations(study);
  EXPECT_EQ(lines(text), 1u) << "one for a light, whatever the number of its rows";
  EXPECT_THAT(text, StartsWith("::error file=" + one.file + ",line="));
  EXPECT_THAT(text, Not(HasSubstr(",line=1,")));
  EXPECT_THAT(text, HasSubstr("::too far"));
}

TEST(GitHub, KeepsHostileTextOnOneLineAndInItsPlace) {
  Study study = passing_study();
  study.cases[0].file = "a,b::c\n%.toml";
  for (Comparison& row : study.comparisons)
    if (row.scene == study.cases[0].scene && row.region == "interior")
      row.verdict = "fail", row.reason = "x\n::error::y";
  const std::string text = github_annotations(study);
  EXPECT_THAT(text, StartsWith("::error file=a%2Cb%3A%3Ac%0A%25.toml,line=1,title="));
  EXPECT_THAT(text, Not(HasSubstr("\n::error::y")));
}

TEST(GitHub, AnnotatesRenderersThatFailedAndRowsThatAreWorse) {
  Study study = passing_study();
  study.cases[0].references[0].failure = "povray exited with 1";
  Study was = passing_study();
  for (Comparison& row : was.comparisons) row.max_abs /= 100;
  study.baseline = against_baseline(study, was, "old.json");
  const std::string text = github_annotations(study);
  EXPECT_THAT(text,
              StartsWith("::error file=scene/canonical/d1-sun-floor.toml,line=1,title=POV-Ray"));
  EXPECT_THAT(text, HasSubstr("is worse than the baseline::"));
}

TEST(GitHub, PrintsNoMoreThanGitHubShowsAndCountsTheRest) {
  Study study = with_provenance();
  for (int i = 0; i < 13; ++i)
    add_case(study, {"scene-" + std::to_string(i), "key", "point", 3e-4, 3e-3}, 24, 16);
  const std::string text = github_annotations(study);
  EXPECT_EQ(lines(text), kAnnotations);
  EXPECT_THAT(text, HasSubstr("and 4 more"));
}

}  // namespace
}  // namespace litmus

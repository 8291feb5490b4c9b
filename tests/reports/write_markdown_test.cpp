// write_markdown_test.cpp: summary.md says the worst first, stays small and inert.
#include "reports/write_markdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Markdown, OfAPassHasNoListOfFailures) {
  const std::string text = markdown(passing_study());
  EXPECT_THAT(text, HasSubstr("# litmus: pass\n"));
  EXPECT_THAT(text,
              HasSubstr("Everything agrees: 54 comparisons over 3 scenes; 54 passed, 0 failed"));
  EXPECT_THAT(text, Not(HasSubstr("## What disagrees")));
  EXPECT_THAT(text, Not(HasSubstr("## Skipped")));
}

TEST(Markdown, NamesFailuresBeforeTheTableOfLights) {
  const std::string text = markdown(mixed_study());
  EXPECT_THAT(text, HasSubstr("# litmus: fail\n"));
  const std::size_t failures = text.find("## What disagrees");
  ASSERT_NE(failures, std::string::npos);
  EXPECT_LT(failures, text.find("## Worst differences"));
  EXPECT_LT(text.find("| r2-nan |"), text.find("| r1-failing |"));
  EXPECT_THAT(text, HasSubstr("| POV-Ray (live) | interior | 3e-4 | 8e-7 |"));
}

TEST(Markdown, GivesTheWorstOfEachLightTypeAndReferenceWithItsSource) {
  EXPECT_THAT(
      markdown(passing_study()),
      HasSubstr("| spot | Blender Cycles | stored | 6e-7 | 3.8e-7 | 4e-6 |  | 3 | 0 | 0 |"));
}

TEST(Markdown, CountsSkippedRowsByReason) {
  EXPECT_THAT(markdown(mixed_study()),
              HasSubstr("- 3 rows: Blender Cycles: Blender is not installed"));
}

TEST(Markdown, KeepsHostileTextInertAndInItsCell) {
  Study study = mixed_study();
  for (Comparison& row : study.comparisons)
    if (row.scene == kHostile) row.verdict = "fail", row.reason = "a\nb | <b>`x`</b>";
  const std::string text = markdown(study);
  EXPECT_THAT(text, Not(HasSubstr("<img")));
  EXPECT_THAT(text, Not(HasSubstr("<b>")));
  EXPECT_THAT(text, HasSubstr("a b \\| &lt;b\\>\\`x\\`&lt;/b\\>"));
}

TEST(Markdown, StaysBelowTheLimitWhateverTheStudy) {
  Study study = passing_study();
  Comparison row = study.comparisons[0];
  row.verdict = "fail";
  row.scene = row.light = row.reason = std::string(5000, '|');
  for (int i = 0; i < 5000; ++i) {
    row.reason[0] = char('a' + i % 26), row.reason[1] = char('a' + i / 26 % 26);
    study.comparisons.push_back(row);
    row.verdict = i % 2 == 0 ? "skipped" : "fail";
  }
  for (int i = 0; i < 400; ++i) {
    study.cases[0].references.push_back(
        {"povray", "", "", "", 0, std::string(5000, '<'), std::string(5000, 'x')});
    study.provenance.versions.push_back({std::string(5000, '&'), std::string(5000, '&')});
  }
  const std::string text = markdown(study);
  EXPECT_LE(text.size(), kMarkdownLimit);
  EXPECT_GT(text.size(), kMarkdownLimit / 4) << "the study is large enough to matter";
  EXPECT_THAT(text, HasSubstr("more in results.json"));
}

TEST(Markdown, OfABigStudyAgainstABaselineStaysBelowTheLimit) {
  Study study = passing_study();
  Comparison row = study.comparisons[0];
  row.verdict = "fail", row.reason = std::string(400, '|');
  for (int i = 0; i < 20'000; ++i) {
    row.light = "light " + std::to_string(i);
    study.comparisons.push_back(row);
  }
  study.baseline = against_baseline(study, passing_study(), std::string(2000, '`'));
  const std::string text = markdown(study);
  EXPECT_LE(text.size(), kMarkdownLimit);
  EXPECT_THAT(text, HasSubstr("## Against the baseline"));
  EXPECT_THAT(text, HasSubstr("20,000 new failures"));
  EXPECT_THAT(text, Not(HasSubstr("](")));
}

}  // namespace
}  // namespace litmus

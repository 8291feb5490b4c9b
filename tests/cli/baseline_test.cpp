// baseline_test.cpp: litmus run --baseline as a gate: exit codes, words, and the file left alone.
#include <gmock/gmock.h>

#include "tests/cli/program_test.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;
using ::testing::Not;

struct BaselineGate : ProgramTest {
  Ended run(const std::string& rest) const {
    return litmus("run s5 --references stored -q " + rest);
  }
};

TEST_F(BaselineGate, PassesARunLikeIt) {
  ASSERT_EQ(run("--out old").code, 0);
  const Ended same = run("--baseline old/results.json --out new");
  EXPECT_EQ(same.code, 0) << same.text;
  EXPECT_THAT(same.text, HasSubstr("nothing new, nothing worse"));
  EXPECT_EQ(results("new")["baseline"]["regression"], false);
}

TEST_F(BaselineGate, FailsOnANewFailureAndSaysSoEverywhere) {
  ASSERT_EQ(run("--out old").code, 0);
  const Ended worse = run("--baseline old/results.json --out new --control cutoff");
  EXPECT_EQ(worse.code, 1);
  EXPECT_THAT(worse.text, HasSubstr("new failure: s5-spot-tilted, "));
  EXPECT_THAT(text_of("new/summary.md"), HasSubstr("- new failure: s5"));
  EXPECT_THAT(text_of("new/report.html"), HasSubstr("<h3>New failures</h3>"));
  EXPECT_EQ(results("new")["baseline"]["regression"], true);
}

TEST_F(BaselineGate, FailsOnAnErrorThatGrewWithinItsTolerance) {
  ASSERT_EQ(run("--out old").code, 0);
  nlohmann::json better = results("old");
  for (auto& row : better["comparisons"]) row["max_abs"] = row["max_abs"].get<double>() / 4;
  write("better.json", better.dump());
  const Ended worse = run("--baseline better.json --out new");
  EXPECT_EQ(worse.code, 1) << worse.text;
  EXPECT_THAT(worse.text, HasSubstr("worse: s5-spot-tilted"));
  EXPECT_THAT(worse.text, HasSubstr("0 fail"));
}

TEST_F(BaselineGate, LetsAKnownFailureBeAndTellsAFix) {
  ASSERT_EQ(run("--out old --control cutoff").code, 1);
  const Ended known = run("--baseline old/results.json --out new --control cutoff");
  EXPECT_EQ(known.code, 0) << known.text;
  EXPECT_THAT(known.text, HasSubstr("still fail"));
  const Ended fixed = run("--baseline old/results.json --out new");
  EXPECT_EQ(fixed.code, 0);
  EXPECT_THAT(fixed.text, HasSubstr("fixed: s5-spot-tilted"));
}

TEST_F(BaselineGate, NeverWritesTheBaseline) {
  ASSERT_EQ(run("--out old").code, 0);
  const std::string before = text_of("old/results.json");
  const auto when = std::filesystem::last_write_time(folder / "old/results.json");
  EXPECT_EQ(run("--baseline old/results.json --out new --control cutoff").code, 1);
  const Ended over_it = run("--baseline old/results.json --out old");
  EXPECT_EQ(over_it.code, 2);
  EXPECT_THAT(over_it.text, HasSubstr("is what this run's report would replace"));
  EXPECT_EQ(text_of("old/results.json"), before);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "old/results.json"), when);
}

TEST_F(BaselineGate, RefusesAFileThatIsNoneBeforeItWritesAnything) {
  write("bad.json", "{\"schema_version\": 99}");
  const Ended bad = run("--baseline bad.json --out new");
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.text, HasSubstr("bad.json: schema_version: is 99"));
  EXPECT_EQ(run("--baseline missing.json --out new").code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
}

}  // namespace
}  // namespace litmus

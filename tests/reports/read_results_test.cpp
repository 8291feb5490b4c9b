// read_results_test.cpp: a results.json comes back as it was written, or is refused by its place.
#include "reports/read_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "reports/write_json.h"
#include "scene/refusal.h"
#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

struct ReadResults : testing::Test {
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "litmus-results-XXXXXX").string();
    folder = ::mkdtemp(name.data());
    file = folder / "results.json";
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  Study read(const std::string& text) const {
    std::ofstream(file, std::ios::binary) << text;
    return read_results(file);
  }

  /// What reading the text is refused with.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const Refusal& wrong) {
      return wrong.what();
    }
    return "not refused";
  }

  std::filesystem::path folder, file;
};

TEST_F(ReadResults, GivesBackWhatWasWritten) {
  const Study written = mixed_study();
  const Study study = read(results_json(written));
  ASSERT_EQ(study.comparisons.size(), written.comparisons.size());
  for (std::size_t i = 0; i < study.comparisons.size(); ++i) {
    const Comparison &a = study.comparisons[i], &b = written.comparisons[i];
    for (const auto& metric : kMetrics<Comparison>)
      EXPECT_EQ(a.*metric.member, b.*metric.member) << metric.name;
    EXPECT_EQ(a.scene, b.scene);
    EXPECT_EQ(a.verdict, b.verdict);
    EXPECT_EQ(a.tolerance, b.tolerance);
  }
  ASSERT_EQ(study.cases.size(), written.cases.size());
  EXPECT_EQ(study.cases[0].seconds, written.cases[0].seconds);
  EXPECT_EQ(study.cases[0].references[0].seconds, written.cases[0].references[0].seconds);
  EXPECT_EQ(study.cases[0].references[0].version, "3.7.0.10");
}

TEST_F(ReadResults, NamesTheFileThePlaceAndTheRemedy) {
  json bad = json::parse(results_json(passing_study()));
  bad["comparisons"][3]["max_abs"] = "big";
  EXPECT_THAT(refusal(bad.dump()),
              AllOf(HasSubstr("results.json: comparisons[3].max_abs: must be a number"),
                    HasSubstr("make it with `litmus run`")));
  bad = json::parse(results_json(passing_study()));
  bad["cases"][0]["references"][1].erase("version");
  EXPECT_THAT(refusal(bad.dump()), HasSubstr("cases[0].references[1].version: is missing"));
  bad = json::parse(results_json(passing_study()));
  bad["comparisons"][0]["verdict"] = "maybe";
  EXPECT_THAT(
      refusal(bad.dump()),
      HasSubstr("comparisons[0].verdict: must be one of pass, fail, skipped, not \"maybe\""));
}

TEST_F(ReadResults, RefusesWhatIsNoResultsFile) {
  EXPECT_THAT(refusal(""), HasSubstr("is no JSON: at line 1"));
  EXPECT_THAT(refusal("{\"a\": \n [1,}"), HasSubstr("at line 2"));
  EXPECT_THAT(refusal("[]"), HasSubstr("has no schema_version"));
  EXPECT_THAT(refusal("{\"a\": 1}"), HasSubstr("has no schema_version"));
  EXPECT_THROW(read_results(folder / "missing.json"), Refusal);
  EXPECT_THROW(read_results(folder), Refusal);
}

TEST_F(ReadResults, RefusesAnotherSchemaVersion) {
  json other = json::parse(results_json(passing_study()));
  other["schema_version"] = kResultsSchemaVersion + 1;
  EXPECT_THAT(refusal(other.dump()), AllOf(HasSubstr("schema_version: is "), HasSubstr("reads 1")));
  other["schema_version"] = "1";
  EXPECT_THAT(refusal(other.dump()), HasSubstr("schema_version: is \"1\""));
}

TEST_F(ReadResults, RefusesARowThatIsThereTwice) {
  json twice = json::parse(results_json(passing_study()));
  twice["comparisons"].push_back(twice["comparisons"][4]);
  EXPECT_THAT(refusal(twice.dump()), HasSubstr("comparisons[54]: is there twice"));
}

TEST_F(ReadResults, RefusesANegativeFigure) {
  json bad = json::parse(results_json(passing_study()));
  bad["comparisons"][0]["tolerance"] = -1;
  EXPECT_THAT(refusal(bad.dump()), HasSubstr("comparisons[0].tolerance: must be a number >= 0"));
}

}  // namespace
}  // namespace litmus

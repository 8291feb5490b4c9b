// write_json_test.cpp: results.json keeps every figure and matches its schema.
#include "reports/write_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "scene/load.h"
#include "tests/json_schema.h"
#include "tests/reports/sample_study.h"

namespace litmus {
namespace {
using nlohmann::json;
using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::vector<std::string> schema_errors(const json& results) {
  return schema_mismatches("reports/results.schema.json", results);
}

TEST(ResultsJson, MatchesItsSchema) {
  EXPECT_THAT(schema_errors(json::parse(results_json(mixed_study()))), IsEmpty());
  EXPECT_THAT(schema_errors(json::parse(results_json({}))), IsEmpty());
}

TEST(ResultsJson, WouldNotMatchWithAMissingWrongOrUnknownMember) {
  const json good = json::parse(results_json(passing_study()));
  json bad = good;
  bad["comparisons"][3].erase("bias");
  EXPECT_THAT(schema_errors(bad), Contains(StartsWith("<root>[comparisons][3]: Missing")));
  bad = good;
  bad["comparisons"][0]["verdict"] = "maybe";
  EXPECT_THAT(schema_errors(bad), Contains(StartsWith("<root>[comparisons][0][verdict]: ")));
  bad = good;
  bad["comparisons"][0]["rmse"] = nullptr;
  EXPECT_THAT(schema_errors(bad), Contains(StartsWith("<root>[comparisons][0][rmse]: ")));
  bad = good;
  bad["cases"][0]["extra"] = 1;
  EXPECT_THAT(schema_errors(bad), Contains(StartsWith("<root>[cases][0]: Object contains")));
  bad = good;
  bad["schema_version"] = 2;
  EXPECT_THAT(schema_errors(bad), Contains(StartsWith("<root>[schema_version]: ")));
}

TEST(ResultsJson, KeepsEveryDigit) {
  Study study = passing_study();
  Comparison& row = study.comparisons[5];
  row.max_abs = 0.1 + 0.2, row.bias = -1.0 / 3e300, row.p999 = 5e-324;
  const json read = json::parse(results_json(study))["comparisons"][5];
  EXPECT_EQ(read["max_abs"].get<double>(), row.max_abs);
  EXPECT_EQ(read["bias"].get<double>(), row.bias);
  EXPECT_EQ(read["p999"].get<double>(), row.p999);
  EXPECT_EQ(read["max_at"], json(row.max_at));
}

TEST(ResultsJson, HasARowForEveryComparisonInOrder) {
  const Study study = mixed_study();
  const json rows = json::parse(results_json(study))["comparisons"];
  ASSERT_EQ(rows.size(), study.comparisons.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]["verdict"], study.comparisons[i].verdict);
    EXPECT_EQ(rows[i]["light"], study.comparisons[i].light);
    EXPECT_EQ(rows[i]["nonfinite"], study.comparisons[i].nonfinite);
  }
}

TEST(ResultsJson, RefusesAFigureThatIsNotFinite) {
  Study study = passing_study();
  study.comparisons[0].rmse = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(results_json(study), std::invalid_argument);
  study.comparisons[0].rmse = std::numeric_limits<double>::infinity();
  EXPECT_THROW(results_json(study), std::invalid_argument);
  study.comparisons[0].rmse = 0;
  EXPECT_NO_THROW(results_json(study));
}

TEST(ResultsJson, SurvivesTextThatIsNotUtf8) {
  Study study = passing_study();
  study.cases[0].about = "\xFF<";
  EXPECT_EQ(json::parse(results_json(study))["cases"][0]["about"], "\xEF\xBF\xBD<");
}

TEST(ResultsJson, OfARunWithABaselineMatchesItsSchema) {
  Study study = mixed_study();
  EXPECT_FALSE(json::parse(results_json(study)).contains("baseline"));
  study.baseline = against_baseline(study, passing_study(), "old.json");
  study.baseline->slower.push_back({"all", "povray", 0.1, 0.5});
  study.baseline->versions.push_back({"povray", "3.7", "3.8"});
  const json results = json::parse(results_json(study));
  EXPECT_THAT(schema_errors(results), IsEmpty());
  EXPECT_EQ(results["baseline"]["changes"][0]["kind"], "new failure");
  EXPECT_EQ(results["provenance"]["slower"][0]["now"], 0.5);
}

}  // namespace
}  // namespace litmus

// stress_report_test.cpp: stress.json keeps its schema, and the page shows what failed.
#include "reports/stress_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "reports/stress_page.h"
#include "tests/json_schema.h"

namespace litmus {
namespace {
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

StressReport sample() {
  StressReport report;
  report.samples = 1000, report.rays = 2000;
  StressRow angle{"alpha-double",
                  "formulas",
                  "angle",
                  "double",
                  "everywhere",
                  "ulp",
                  1000,
                  3.5,
                  5,
                  "acos",
                  std::numeric_limits<double>::infinity()};
  angle.curve = StressCurve{"ulp", true, "log10 of it", -3, 0, {1, 3.5}, {9, INFINITY}};
  report.rows = {angle,
                 {"leaks-float", "meshes", "edges <of> meshes", "float", "at 1e5", "leaks", 2000, 0,
                  0, "Moeller-Trumbore", 200}};
  report.envelopes = {{"scale", 1, "POV-Ray", 0, ""},
                      {"scale", 1e-6, "POV-Ray", 100, "no <parse>"}};
  return report;
}

std::vector<std::string> schema_errors(const StressReport& report) {
  return schema_mismatches("reports/stress.schema.json", json::parse(stress_json(report)));
}

TEST(StressJson, MatchesItsSchemaEvenWithWhatIsNotFinite) {
  EXPECT_THAT(schema_errors(sample()), IsEmpty());
  StressReport odd = sample();
  odd.rows[0].scalar = "half";
  EXPECT_THAT(schema_errors(odd), Not(IsEmpty()));  // the control
}

TEST(StressReport, FailsWhereABoundIsExceeded) {
  StressReport report = sample();
  EXPECT_TRUE(passes(report));
  report.rows[0].seen = 5.1;
  EXPECT_FALSE(passes(report));
  report.rows[0].seen = std::nan("");
  EXPECT_FALSE(passes(report));
}

TEST(StressReport, FailsWhereAControlKeepsTheBound) {
  StressReport report = sample();
  report.rows[1].control_seen = 0;
  EXPECT_FALSE(passes(report));
  report.rows[1].judged = false;
  EXPECT_TRUE(passes(report));
}

TEST(StressPage, ShowsEveryRowWithItsTextEscaped) {
  const std::string page = stress_page(sample());
  EXPECT_THAT(page, HasSubstr("All 2 figures keep their bounds"));
  EXPECT_THAT(page, HasSubstr("edges &lt;of&gt; meshes"));
  EXPECT_THAT(page, HasSubstr("<svg class=\"plot\""));
  EXPECT_THAT(page, HasSubstr("NaN, inf"));
  EXPECT_THAT(page, HasSubstr("title=\"no &lt;parse&gt;\">none<"));
  EXPECT_THAT(page, Not(HasSubstr("http://")));
}

TEST(StressPage, SaysHowManyFiguresFail) {
  StressReport report = sample();
  report.rows[1].seen = 3;
  const std::string page = stress_page(report);
  EXPECT_THAT(page, HasSubstr("1 of 2 figures fail"));
  EXPECT_THAT(page, HasSubstr("<tr class=\"fail\">"));
}

}  // namespace
}  // namespace litmus

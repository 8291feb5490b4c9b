// stress_page_test.cpp: the page of litmus stress puts what belongs together beside each other, and
// says why a renderer shows nothing.
#include "reports/stress_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace litmus {
namespace {
using testing::HasSubstr;
using testing::Not;

StressRow row_about(const std::string& what, const std::string& domain) {
  StressRow row;
  row.group = "formulas", row.what = what, row.domain = domain;
  row.control_seen = 1;
  return row;
}

TEST(StressPageOrder, PutsFloatAndDoubleOfACaseBesideEachOther) {
  StressReport report;
  report.rows = {row_about("angle", "first"), row_about("sum", "between"),
                 row_about("angle", "last")};
  const std::string page = stress_page(report);
  ASSERT_THAT(page, HasSubstr(">first<"));
  EXPECT_LT(page.find(">first<"), page.find(">last<"));
  EXPECT_LT(page.find(">last<"), page.find(">between<"));
}

TEST(StressPageEnvelopes, SayWhyARendererShowsNothing) {
  StressReport report;
  report.envelopes = {{"scale", 1, "POV-Ray", 0, ""},
                      {"scale", 1e-6, "POV-Ray", 100, "no <parse>"},
                      {"scale", 1, "Blender Cycles", 100, "not installed"}};
  const std::string page = stress_page(report);
  EXPECT_THAT(page, HasSubstr("<li>POV-Ray, scale 1e-06: no &lt;parse&gt;</li>"));
  EXPECT_THAT(page, HasSubstr("<li>Blender Cycles: not installed</li>"));
}

TEST(StressPageEnvelopes, NameNoFailureWhereThereIsNone) {
  StressReport report;
  report.envelopes = {{"scale", 1, "POV-Ray", 0, ""}};
  EXPECT_THAT(stress_page(report), Not(HasSubstr("No picture")));
}

}  // namespace
}  // namespace litmus

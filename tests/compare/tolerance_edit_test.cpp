// tolerance_edit_test.cpp: new figures go where they belong, and nothing else changes.
#include "compare/tolerance_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/document.h"
#include "scene/refusal.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;

const NamedTolerance& blender_edge() {
  for (const NamedTolerance& row : tolerances())
    if (row.reference == "blender" && row.region == Region::Edge) return row;
  throw std::logic_error("no such tolerance");
}

TEST(RaisedTolerance, CoversWhatWasSeenWithinTheLargestMargin) {
  const NamedTolerance& row = blender_edge();
  const double error = 3.217 * row.tolerance.max_abs;
  const ToleranceChange change = raised(row, error, 0, "why");
  EXPECT_GE(change.seen_max, error);
  EXPECT_LE(change.seen_max, 1.01 * error);
  EXPECT_GE(change.tolerance.max_abs, kRaisedMargin * error);
  EXPECT_LE(change.tolerance.max_abs, kLargestMargin * change.seen_max);
  EXPECT_EQ(change.tolerance.mean_abs, row.tolerance.mean_abs) << "a figure that passes stays";
  EXPECT_EQ(change.seen_mean, row.seen_mean);
}

TEST(EditedTolerances, DifferInTheFiveLinesOfTheirTableAlone) {
  const std::string before = read_limited(tolerances_file());
  const NamedTolerance& row = blender_edge();
  const ToleranceChange change =
      raised(row, 3 * row.tolerance.max_abs, 3 * row.tolerance.mean_abs, "a \"quoted\" \\ reason");
  const std::string after = edited_tolerances(before, tolerances(), {&change, 1});
  const std::string diff = line_diff("tolerances.toml", before, after);
  EXPECT_EQ(std::count(diff.begin(), diff.end(), '@'), 5 * 4);
  EXPECT_THAT(diff, HasSubstr("+reason = \"a \\\"quoted\\\" \\\\ reason\"\n"));
  EXPECT_THAT(diff, HasSubstr("--- tolerances.toml\n+++ tolerances.toml\n@@ -"));
  EXPECT_EQ(edited_tolerances(before, tolerances(), {}), before) << "without changes, to the byte";
  EXPECT_EQ(line_diff("x", before, before), "");
}

TEST(EditedTolerances, RefuseAReferenceThatHasNone) {
  ToleranceChange change;
  change.reference = "nobody";
  EXPECT_THROW(edited_tolerances("", tolerances(), {&change, 1}), Refusal);
}

}  // namespace
}  // namespace litmus

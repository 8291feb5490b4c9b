// tolerances_test.cpp: the reviewed file, and what its reader refuses.
#include "compare/tolerances.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scene/refusal.h"

namespace litmus {
namespace {
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Region kAllJudged[] = {Region::Interior, Region::Edge,  Region::Lit,
                                 Region::Penumbra, Region::Umbra, Region::Highlight};

std::string row(const std::string& region, const std::string& numbers) {
  return "[[tolerance]]\nreference = \"toy\"\nregion = \"" + region + "\"\n" + numbers +
         "\nreason = \"a test\"\n";
}

const std::string kNumbers = "max_abs = 4e-6\nmean_abs = 4e-8\nseen_max = 1e-6\nseen_mean = 1e-8";

/// A whole table, with the interior's row given.
std::string table(const std::string& interior) {
  std::string text = interior;
  for (const char* region : {"edge", "lit", "penumbra", "umbra", "highlight"})
    text += row(region, kNumbers);
  return text;
}

std::vector<NamedTolerance> load(const std::string& text) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("litmus-tolerances-" + std::to_string(getpid()) + ".toml");
  std::ofstream(file) << text;
  struct Remove {
    const std::filesystem::path& file;
    ~Remove() { std::filesystem::remove(file); }
  } remove{file};
  return load_tolerances(file);
}

std::string refusal(const std::string& text) {
  try {
    load(text);
  } catch (const Refusal& error) {
    return error.what();
  }
  return "";
}

TEST(TolerancesFile, StaysBelowThePublishedGates) {
  for (const NamedTolerance& row : tolerances()) {
    const bool povray = row.reference == "povray", edge = row.region == Region::Edge;
    EXPECT_LE(row.tolerance.max_abs, edge ? 1e-3 : povray ? 2e-6 : 2e-5) << row.line;
    // The gates on means are those of an interior; a part of it may have a larger mean.
    if (row.region == Region::Interior) {
      EXPECT_LE(row.tolerance.mean_abs, povray ? 1e-7 : 5e-7) << row.line;
    }
    EXPECT_FALSE(row.tolerance.reason.empty());
  }
}

TEST(TolerancesFile, HoldsClosedFormsToDoublePrecision) {
  for (const NamedTolerance& row : tolerances()) {
    if (row.reference == "closed-form") {
      EXPECT_LE(row.tolerance.max_abs, 1e-12) << row.line;
    }
  }
}

TEST(TolerancesFile, GivesNoCauseForAWarning) {
  EXPECT_THAT(tolerance_warnings(tolerances(), tolerances_file()), IsEmpty());
}

TEST(TolerancesFile, HasEveryRegionOfTheReferencesAndTheClosedForms) {
  for (const char* reference : {"povray", "blender", "closed-form"})
    for (const Region region : kAllJudged)
      EXPECT_EQ(find_tolerance(reference, region).may_be_empty, region != Region::Interior);
}

TEST(FindTolerance, HoldsAllToTheEdges) {
  EXPECT_EQ(find_tolerance("povray", Region::All).max_abs,
            find_tolerance("povray", Region::Edge).max_abs);
}

TEST(FindTolerance, RefusesAnUnknownReference) {
  EXPECT_THROW(find_tolerance("mitsuba", Region::Interior), Refusal);
}

TEST(LoadTolerances, ReadsEveryFigure) {
  const std::vector<NamedTolerance> rows = load(table(row("interior", kNumbers)));
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0].reference, "toy");
  EXPECT_EQ(rows[0].region, Region::Interior);
  EXPECT_EQ(rows[0].tolerance.max_abs, 4e-6);
  EXPECT_EQ(rows[0].tolerance.mean_abs, 4e-8);
  EXPECT_EQ(rows[0].tolerance.reason, "a test");
  EXPECT_EQ(rows[0].seen_max, 1e-6);
  EXPECT_EQ(rows[0].seen_mean, 1e-8);
  EXPECT_EQ(rows[1].line, 9);
}

TEST(LoadTolerances, RefusesWhatIsNotATolerance) {
  EXPECT_THAT(refusal(table(row("interior", kNumbers + "\nmaximum = 1"))),
              HasSubstr(":8:1: maximum: unknown key"));
  EXPECT_THAT(refusal(table(row("inside", kNumbers))), HasSubstr(":3:10: region: must be"));
  EXPECT_THAT(refusal(table(row("interior", "max_abs = 4e-6"))), HasSubstr("mean_abs: missing"));
  EXPECT_THAT(refusal(table(row("interior", "max_abs = -1"))),
              HasSubstr(":4:11: max_abs: must be a finite number >= 0"));
  EXPECT_THAT(refusal("[tolerances]\n"), HasSubstr("tolerances: unknown key"));
  EXPECT_THAT(refusal(""), HasSubstr("tolerance: missing"));
}

TEST(LoadTolerances, RefusesRegionsGivenTwiceOrNotAtAll) {
  EXPECT_THAT(refusal(table(row("interior", kNumbers)) + row("umbra", kNumbers)),
              HasSubstr("toy, umbra has a tolerance in line"));
  EXPECT_THAT(refusal(table("")), HasSubstr("toy has none for the region \"interior\""));
}

TEST(LoadTolerances, RefusesAnErrorSeenThatIsOverItsTolerance) {
  const std::string numbers = "max_abs = 4e-6\nmean_abs = 4e-8\nseen_max = 5e-6\nseen_mean = 1e-8";
  EXPECT_THAT(refusal(table(row("interior", numbers))), HasSubstr("seen_max: is over max_abs"));
}

TEST(ToleranceWarnings, NameTheLineOfATenfoldTolerance) {
  const std::string numbers = "max_abs = 1e-5\nmean_abs = 4e-8\nseen_max = 1e-6\nseen_mean = 1e-8";
  EXPECT_THAT(tolerance_warnings(load(table(row("interior", numbers))), "toy.toml"),
              ElementsAre(HasSubstr("toy.toml:1: the max_abs of toy, interior is 1e-05")));
  EXPECT_THAT(tolerance_warnings(load(table(row("interior", kNumbers))), "toy.toml"), IsEmpty());
}

}  // namespace
}  // namespace litmus

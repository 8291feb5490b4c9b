// provenance_test.cpp: what a report says about the renderers.
#include "reports/provenance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace litmus {
namespace {
using ::testing::ElementsAre;
using ::testing::StartsWith;

TEST(ProvenanceOf, HasTheVersionsOfTheRenderersThatAreAsked) {
  Driver here{}, missing{};
  here.title = "Here", missing.title = "Missing";
  here.find = [] { return std::optional(Installation{"/bin/here", "1.2"}); };
  missing.find = [] { return std::optional<Installation>(); };
  const std::vector<const Driver*> drivers{&here, &missing};
  const auto versions = provenance_of(drivers).versions;
  EXPECT_THAT(versions[0], ElementsAre("Here", "1.2"));
  EXPECT_THAT(versions[1], ElementsAre("Missing", "not installed"));
}

TEST(ProvenanceOf, StartsNoRendererWhereStoredImagesDo) {
  Driver driver{};
  driver.title = "Slow";
  driver.find = [] {
    ADD_FAILURE() << "asked";
    return std::optional<Installation>();
  };
  const std::vector<const Driver*> drivers{&driver};
  EXPECT_THAT(provenance_of(drivers, false).versions[0],
              ElementsAre("Slow", StartsWith("not started")));
}

}  // namespace
}  // namespace litmus

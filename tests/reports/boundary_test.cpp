// boundary_test.cpp: which edge pixels are excused, and which are not.
#include "reports/boundary.h"

#include <gtest/gtest.h>

namespace litmus {
namespace {

/// One layer: white left of `edge`, black right of it.
Probe step_at(double edge) {
  return [edge](double x, double) { return std::vector<glm::dvec3>{glm::dvec3(x < edge ? 1 : 0)}; };
}

TEST(BoundaryDistance, ExcusesABoundaryThatPassesCloseByTheCentre) {
  const auto distance = boundary_distance(step_at(3.5002), 3, 7, 0, glm::dvec3(0), 1e-3);
  ASSERT_TRUE(distance);
  EXPECT_LT(*distance, kBoundaryPixels);
  EXPECT_GE(*distance, 0.0002);
}

TEST(BoundaryDistance, DoesNotExcuseABoundaryFurtherAway) {
  EXPECT_FALSE(boundary_distance(step_at(3.5 + 2 * kBoundaryPixels), 3, 7, 0, glm::dvec3(0), 1e-3));
}

TEST(BoundaryDistance, DoesNotExcuseAValueThatIsOnNeitherSide) {
  EXPECT_FALSE(boundary_distance(step_at(3.5002), 3, 7, 0, glm::dvec3(0.5), 1e-3));
}

TEST(BoundaryDistance, LooksAtTheSumForTheLayerPastTheLast) {
  const Probe two = [](double x, double) {
    return std::vector<glm::dvec3>{glm::dvec3(0.25), glm::dvec3(x < 0.5001 ? 1 : 0)};
  };
  EXPECT_TRUE(boundary_distance(two, 0, 0, 2, glm::dvec3(0.25), 1e-3));
  EXPECT_FALSE(boundary_distance(two, 0, 0, 2, glm::dvec3(0), 1e-3));
}

}  // namespace
}  // namespace litmus

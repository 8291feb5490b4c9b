// gauss_test.cpp: Gauss-Legendre quadrature.
#include "tracer/gauss.h"

#include <gtest/gtest.h>

#include <cmath>

namespace litmus {
namespace {

TEST(GaussRule, IntegratesPolynomialsOfTwiceItsPointsExactly) {
  for (int n = 1; n <= 12; ++n) {
    const GaussRule rule = gauss_rule(n);
    for (int power = 0; power <= 2 * n; ++power) {
      double mean = 0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        mean += rule.weights[i] * std::pow(rule.nodes[i], power);
      const double exact = power % 2 ? 0 : 1.0 / (power + 1);
      if (power < 2 * n) {
        EXPECT_NEAR(mean, exact, 1e-14) << n << " points, x^" << power;
      } else {
        EXPECT_GT(std::fabs(mean - exact), 1e-9) << "the control: x^2n is one power too many";
      }
    }
  }
}

TEST(ShortRule, IsTheSameRule) {
  for (int n = 1; n <= kMostPoints; ++n) EXPECT_EQ(short_rule(n).nodes, gauss_rule(n).nodes);
}

}  // namespace
}  // namespace litmus

// povray_fit_test.cpp: POV-Ray's own lights come as near to the model as they can.
#include "exporters/povray_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace litmus::povray {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double fade(const FadeFit& fit, double d) {
  return 2 * fit.factor / (1 + std::pow(d / fit.distance, fit.power));
}

TEST(FadeFit, IsExactForOneKindOfAttenuation) {
  for (const double d : {0.0, 0.5, 3.0, 40.0}) {
    EXPECT_NEAR(fade(fit_fade({2, 0.7, 0}, 10), d), 1 / (1 + 0.7 * d / 2), 1e-15);
    EXPECT_NEAR(fade(fit_fade({2, 0, 0.7}, 10), d), 1 / (1 + 0.7 * d * d / 4), 1e-15);
  }
  EXPECT_EQ(fit_fade({2, 0.7, 0}, 10).error, 0);
}

TEST(FadeFit, IsNoFadingWithoutAttenuation) { EXPECT_EQ(fit_fade({}, 10).power, 0); }

TEST(FadeFit, KeepsToItsErrorForBothKinds) {
  const Attenuation both{2, 1, 1};
  const FadeFit fit = fit_fade(both, 12);
  double largest = 0;
  for (double d = 0; d <= 12; d += 0.01) {
    const double x = d / 2;
    largest = std::max(largest, std::abs(fade(fit, d) - 1 / ((1 + x) * (1 + x * x))));
  }
  EXPECT_NEAR(largest, fit.error, 1e-3);
  EXPECT_LT(fit.error, 0.05);
  EXPECT_GT(fit.error, 0.001) << "POV-Ray cannot be exact here";
}

TEST(SpotFit, BeatsTheNaiveReading) {
  // radius = falloff = cutoff: full light up to the cutoff, so off by the decay itself, up to 1.
  for (const double exponent : {1.0, 3.0, 30.0}) {
    const SpotFit fit = fit_spot(25 * kDegree, exponent);
    EXPECT_LT(fit.error, 0.1) << exponent;
    EXPECT_GT(fit.error, 0.001) << exponent;
    EXPECT_LT(fit.radius, fit.falloff);
  }
}

TEST(SpotFit, EndsAtNinetyDegrees) {
  const SpotFit fit = fit_spot(180 * kDegree, 30);
  EXPECT_LE(fit.falloff, 90);
  EXPECT_GT(fit.error, 0.5) << "half of the light is missing";
}

}  // namespace
}  // namespace litmus::povray

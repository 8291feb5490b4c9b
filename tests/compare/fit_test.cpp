// fit_test.cpp: the unit detective recovers factors and curves that were put in, and keeps silent
// about what is neither.
#include "compare/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace litmus {
namespace {
using std::numbers::pi;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A pool of light with a dark border.
Picture pool() {
  Picture picture(64, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const double r = std::hypot(x - 30.0, y - 22.0) / 22;
      picture.at(x, y) = r < 1 ? (1 - r * r) * glm::dvec3(0.9, 0.5, 0.2) : glm::dvec3(0);
    }
  return picture;
}

Picture mapped(const Picture& picture, const std::function<double(double)>& map) {
  Picture result = picture;
  for (glm::dvec3& p : result.pixels)
    for (int c = 0; c < 3; ++c) p[c] = map(p[c]);
  return result;
}

/// One pixel in twenty is anything.
Picture spoiled(Picture picture) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(0, 5);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    if (random() % 20 == 0) picture.pixels[i] = {value(random), value(random), value(random)};
  return picture;
}

/// Rounding errors of about a thousandth.
Picture noisy(Picture picture) {
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0, 1e-3);
  for (glm::dvec3& p : picture.pixels) p += glm::dvec3(noise(random), noise(random), noise(random));
  return picture;
}

double srgb(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

TEST(FitShading, RecoversAGainToAThousandthUnderFivePercentOfOutliers) {
  for (const double gain : {pi, 4 * pi, 1 / pi, 1 / (4 * pi), 2.0, 0.5, 1.01, 0.99}) {
    const Picture ours = spoiled(mapped(pool(), [&](double v) { return gain * v; }));
    const ShadingFit fit = fit_shading(ours, pool());
    ASSERT_TRUE(fit.determined);
    EXPECT_NEAR(fit.gain / gain, 1, 1e-3);
    EXPECT_NEAR(fit.offset, 0, 1e-3 * gain);
    EXPECT_NEAR(fit.slope, 1, 1e-3);
  }
}

TEST(FitShading, RecoversAGainUnderOutliersAndNoise) {
  const Picture ours = noisy(spoiled(mapped(pool(), [](double v) { return pi * v; })));
  EXPECT_NEAR(fit_shading(ours, pool()).gain / pi, 1, 1e-3);
}

TEST(FitShading, SeparatesGainFromOffset) {
  const ShadingFit fit =
      fit_shading(spoiled(mapped(pool(), [](double v) { return 1.5 * v + 0.02; })), pool());
  EXPECT_NEAR(fit.gain, 1.5, 1.5e-3);
  EXPECT_NEAR(fit.offset, 0.02, 1e-4);
}

TEST(FitShading, RecoversAPower) {
  for (const double power : {2.2, 1 / 2.2, 1.3}) {
    const Picture ours = spoiled(mapped(pool(), [&](double v) { return std::pow(v, power); }));
    const ShadingFit fit = fit_shading(ours, pool());
    EXPECT_NEAR(fit.slope / power, 1, 1e-3);
    EXPECT_NEAR(fit.level, 1, 1e-3);
    EXPECT_LT(fit.curve_unexplained, 1e-3);
  }
}

TEST(FitShading, OfAFlatPictureIsTheRatio) {
  Picture theirs(20, 20), ours(20, 20);
  for (glm::dvec3& p : theirs.pixels) p = glm::dvec3(0.25);
  for (glm::dvec3& p : ours.pixels) p = glm::dvec3(0.25 * pi);
  const ShadingFit fit = fit_shading(ours, theirs);
  EXPECT_NEAR(fit.gain, pi, 1e-12);
  EXPECT_EQ(fit.offset, 0);
  EXPECT_FALSE(fit.has_slope);
}

TEST(FitShading, IsNotDeterminedInTheDark) {
  EXPECT_FALSE(fit_shading(Picture(20, 20), Picture(20, 20)).determined);
  EXPECT_FALSE(fit_shading({}, {}).determined);
}

TEST(FitShading, LeavesOutEdgesAndPixelsThatAreNotFinite) {
  Picture ours = mapped(pool(), [](double v) { return 2 * v; });
  std::vector<std::uint8_t> edge(ours.pixels.size());
  for (std::size_t i = 0; i < edge.size(); i += 2) {
    edge[i] = 1;
    ours.pixels[i] = glm::dvec3(7);
  }
  ours.pixels[1401] = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  const ShadingFit fit = fit_shading(ours, pool(), edge);
  EXPECT_DOUBLE_EQ(fit.gain, 2);
  EXPECT_LT(fit.samples, std::int64_t(3 * edge.size() / 2));
}

std::string explained(const std::function<double(double)>& map) {
  return explain_units(spoiled(mapped(pool(), map)), pool());
}

TEST(ExplainUnits, NamesTheFactor) {
  EXPECT_EQ(
      explained([](double v) { return pi * v; }),
      "ours is 3.1416 times theirs: a factor of pi, as when irradiance is taken for radiance");
  EXPECT_THAT(explained([](double v) { return v / pi; }), HasSubstr(": a factor of 1/pi,"));
  EXPECT_THAT(explained([](double v) { return 4 * pi * v; }), HasSubstr("W are taken for W/sr"));
  EXPECT_THAT(explained([](double v) { return v / (4 * pi); }), HasSubstr("W/sr are taken for W"));
  EXPECT_THAT(explained([](double v) { return 2 * v; }), HasSubstr("a factor of 2,"));
  EXPECT_THAT(explained([](double v) { return v / 2; }), HasSubstr("a factor of 1/2,"));
}

TEST(ExplainUnits, NamesTheCurve) {
  EXPECT_THAT(explained(srgb), StartsWith("ours is theirs sRGB-encoded"));
  EXPECT_THAT(explain_units(spoiled(pool()), mapped(pool(), srgb)),
              StartsWith("theirs is ours sRGB-encoded"));
  EXPECT_THAT(explained([](double v) { return std::pow(v, 2.2); }),
              StartsWith("ours is theirs to the power 2.2: a gamma of 2.2"));
  EXPECT_THAT(explained([](double v) { return std::pow(v, 1 / 2.2); }),
              StartsWith("ours is theirs to the power 0.4545: a gamma of 1/2.2"));
}

TEST(ExplainUnits, NamesAPlainFactorOrOffset) {
  EXPECT_EQ(explained([](double v) { return 1.01 * v; }), "ours is 1.01 times theirs");
  EXPECT_EQ(explained([](double v) { return v + 0.015; }), "ours is theirs plus 0.015 everywhere");
}

TEST(ExplainUnits, IsSilentWhereNothingExplainsTheDifference) {
  EXPECT_EQ(explained([](double v) { return v; }), "");
  EXPECT_EQ(explained([](double v) { return v + 0.1 * std::sin(40 * v); }), "");
  EXPECT_EQ(explained([](double v) { return v > 0.3 ? 2 * v : 0.7 * v; }), "");
  EXPECT_EQ(explained([](double v) { return std::pow(v, 1.7); }), "");
  EXPECT_EQ(explain_units(Picture(9, 9), Picture(9, 9)), "");
}

}  // namespace
}  // namespace litmus

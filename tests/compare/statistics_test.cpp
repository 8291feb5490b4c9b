// statistics_test.cpp: the tests against textbook values, and how often they are right.
#include "compare/statistics.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <random>

#include "compare/difference.h"
#include "scene/refusal.h"

namespace litmus {

inline void PrintTo(const MeasuredRate& row, std::ostream* out) { *out << row.what; }

namespace {
using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// ---- The parts ---------------------------------------------------------------------------------

// By hand: means 3 and 5, variances 2.5 and 10, so t = -2 / sqrt(0.5 + 2) and
// df = 2.5^2 / (0.5^2 / 4 + 2^2 / 4).
TEST(WelchTest, IsTheTextbooks) {
  const Welch result =
      welch(std::vector<double>{1, 2, 3, 4, 5}, std::vector<double>{1, 3, 5, 7, 9});
  EXPECT_DOUBLE_EQ(result.t, -2 / std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(result.degrees_of_freedom, 6.25 / 1.0625);
}

// Student's t with 2 degrees of freedom has a closed form: p = 1 - t / sqrt(2 + t^2).
TEST(WelchTest, TakesItsPFromStudentsDistribution) {
  const Welch result = welch(std::vector<double>{0, 2}, std::vector<double>{5, 7});
  EXPECT_DOUBLE_EQ(result.degrees_of_freedom, 2);
  const double t = std::abs(result.t);
  EXPECT_NEAR(result.p, 1 - t / std::sqrt(2 + t * t), 1e-14);
}

TEST(WelchTest, WithoutNoiseIsCertain) {
  EXPECT_EQ(welch(std::vector<double>{1, 1}, std::vector<double>{1, 1}).p, 1);
  EXPECT_EQ(welch(std::vector<double>{1, 1}, std::vector<double>{2, 2}).p, 0);
}

TEST(WelchTest, LeavesOutWhatIsNegligible) {
  const std::vector<double> ours{1, 1.1, 1.2}, theirs{1.2, 1.3, 1.4};
  EXPECT_EQ(welch(ours, theirs, 0.3).p, 1);
  EXPECT_LT(welch(ours, theirs, 0.1).p, 1);
  EXPECT_GT(welch(ours, theirs, 0.1).p, welch(ours, theirs).p);
}

TEST(Sidak, IsTheLeastOfManyAndKeepsTinyValues) {
  EXPECT_DOUBLE_EQ(sidak(0.1, 2), 0.19);
  EXPECT_NEAR(sidak(1e-20, 1000), 1e-17, 1e-30);
  EXPECT_EQ(sidak(1, 5), 1);
  EXPECT_EQ(sidak(0, 5), 0);
}

TEST(Holm, AdjustsTheLeastMostAndKeepsTheOrder) {
  EXPECT_THAT(holm(std::vector<double>{0.01, 0.04, 0.03}),
              ElementsAre(DoubleEq(0.03), DoubleEq(0.06), DoubleEq(0.06)));
  EXPECT_THAT(holm(std::vector<double>{0.9, 0.8}), ElementsAre(1, 1));
  EXPECT_TRUE(holm({}).empty());
}

// ---- Simulated renderers -----------------------------------------------------------------------

constexpr double kSigma = 0.1;

struct Simulation {
  std::mt19937_64 random{20};
  std::normal_distribution<float> distribution;
  int spot_x = 0, spot_y = 0;

  double normal() { return double(distribution(random)); }
  double uniform() { return double(random() >> 11) * 0x1p-53; }
};

/// A pixel's value in one seed.
using Pixel = std::function<double(Simulation&, int x, int y, bool ours)>;

void render_again(std::vector<Picture>& seeds, Simulation& simulation, bool ours,
                  const Pixel& pixel) {
  for (Picture& picture : seeds)
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        picture.at(x, y) = glm::dvec3(pixel(simulation, x, y, ours));
}

std::vector<Picture> seeds(Simulation& simulation, int count, int size, bool ours,
                           const Pixel& pixel) {
  std::vector<Picture> result(std::size_t(count), Picture(size, size));
  render_again(result, simulation, ours, pixel);
  return result;
}

double noise(Simulation& s) { return 0.5 + kSigma * s.normal(); }

Pixel pixel_of(std::string_view what) {
  if (what == "no difference, normal noise")
    return [](Simulation& s, int, int, bool) { return noise(s); };
  if (what == "no difference, 10 times the noise on one side")
    return
        [](Simulation& s, int, int, bool ours) { return 0.5 + (ours ? 0.1 : 0.01) * s.normal(); };
  if (what == "no difference, fireflies")
    return [](Simulation& s, int, int, bool) {
      const double u = s.uniform();
      return noise(s) + (u < 0.01 ? 0.1 / (u + 1e-4) : 0);
    };
  if (what == "no difference, a light seen or not")
    return [](Simulation& s, int, int, bool) { return s.random() & 1 ? 1 + 1e-3 * s.normal() : 0; };
  if (what == "bias of 0.05 sigma everywhere")
    return [](Simulation& s, int, int, bool ours) { return noise(s) + ours * 0.05 * kSigma; };
  if (what == "16 x 16 spot of 1 sigma anywhere")
    return [](Simulation& s, int x, int y, bool ours) {
      const bool in = x >= s.spot_x && x < s.spot_x + 16 && y >= s.spot_y && y < s.spot_y + 16;
      return noise(s) + (ours && in) * kSigma;
    };
  if (what == "one pixel of 15 sigma")
    return [](Simulation& s, int x, int y, bool ours) {
      return noise(s) + (ours && x == s.spot_x && y == s.spot_y) * 15 * kSigma;
    };
  throw std::logic_error("no simulation of " + std::string(what));
}

class SampleTests : public testing::TestWithParam<MeasuredRate> {};

TEST_P(SampleTests, CallPicturesDifferentAsOftenAsTheySay) {
  const MeasuredRate& row = GetParam();
  Simulation simulation;
  const Pixel pixel = pixel_of(row.what);
  std::vector<Picture> ours(std::size_t(row.seeds), Picture(row.size, row.size)), theirs = ours;
  int different = 0;
  for (int run = 0; run < row.runs; ++run) {
    simulation.spot_x = int(simulation.random() % std::uint64_t(row.size - 16));
    simulation.spot_y = int(simulation.random() % std::uint64_t(row.size - 16));
    render_again(ours, simulation, true, pixel);
    render_again(theirs, simulation, false, pixel);
    SampleOptions options;
    options.seed = std::uint64_t(run);
    different += compare_samples(ours, theirs, options).p <= kAlpha;
  }
  const double rate = double(different) / row.runs;
  std::cout << fmt::format(
      "{:<46} {} seeds a side, {} x {}: {} of {} called different ({:.1f} %)\n", row.what,
      row.seeds, row.size, row.size, different, row.runs, 100 * rate);
  const bool null = row.what.starts_with("no difference");
  EXPECT_NEAR(rate, row.rate, null ? 0.004 : 0.02);
  if (null) {
    EXPECT_LE(rate, 0.016);
  } else {
    EXPECT_GE(rate, 0.95);
  }
  if (row.what == "no difference, normal noise") {
    EXPECT_GE(rate, 0.004) << "alpha is used, not only kept";
  }
}

INSTANTIATE_TEST_SUITE_P(Measured, SampleTests,
                         testing::ValuesIn(measured_rates().begin(), measured_rates().end()));

// ---- One comparison ----------------------------------------------------------------------------

struct Sides {
  std::vector<Picture> ours, theirs;
};

Sides sides(int count, int size) {
  Simulation simulation;
  const Pixel pixel = pixel_of("no difference, normal noise");
  return {seeds(simulation, count, size, true, pixel),
          seeds(simulation, count, size, false, pixel)};
}

TEST(CompareSamples, SaysWhereInWhichChannelAndByHowMuch) {
  Sides s = sides(8, 40);
  for (Picture& picture : s.ours) {
    picture.at(37, 3).z += 3;
    for (int y = 16; y < 32; ++y)
      for (int x = 16; x < 32; ++x) picture.at(x, y).y += 0.3;
  }
  const SampleComparison result = compare_samples(s.ours, s.theirs);
  EXPECT_EQ(result.pixel.channel, 2);
  EXPECT_THAT(result.pixel.at, ElementsAre(37, 3));
  EXPECT_NEAR(result.pixel.difference, 3, 0.3);
  EXPECT_EQ(result.tile.channel, 1);
  EXPECT_THAT(result.tile.at, ElementsAre(16, 16));
  EXPECT_NEAR(result.tile.difference, 0.3, 0.02);
  EXPECT_LT(result.p, 1e-6);
}

TEST(CompareSamples, FindsADifferenceWithoutAnyNoiseThere) {
  Sides s = sides(8, 32);
  for (auto* side : {&s.ours, &s.theirs})
    for (Picture& picture : *side) picture.at(5, 6) = glm::dvec3(side == &s.ours ? 0.25 : 0.5);
  const SampleComparison result = compare_samples(s.ours, s.theirs);
  EXPECT_THAT(result.pixel.at, ElementsAre(5, 6));
  EXPECT_LE(result.pixel.p, 0.001 + 1e-12);
}

TEST(CompareSamples, IgnoresANegligibleDifference) {
  Sides s = sides(8, 32);
  for (Picture& picture : s.ours)
    for (glm::dvec3& pixel : picture.pixels) pixel += 0.2;
  SampleOptions options;
  EXPECT_LT(compare_samples(s.ours, s.theirs, options).p, 1e-6);
  options.negligible = 0.25;
  EXPECT_EQ(compare_samples(s.ours, s.theirs, options).mean.p, 1);
}

TEST(CompareSamples, CountsPixelsThatAreNotFiniteAndLeavesThemOut) {
  Sides s = sides(8, 32);
  s.theirs[3].at(1, 2).y = std::numeric_limits<double>::quiet_NaN();
  s.ours[0].at(4, 4).x = std::numeric_limits<double>::infinity();
  const SampleComparison result = compare_samples(s.ours, s.theirs);
  EXPECT_EQ(result.nonfinite, 2);
  EXPECT_GT(result.p, kAlpha);
}

TEST(CompareSamples, CountsGreyPicturesOnce) {
  Sides grey = sides(8, 32), colored = sides(8, 32);
  for (Picture& picture : colored.ours) picture.at(0, 0).x += 1e-9;
  EXPECT_LT(compare_samples(grey.ours, grey.theirs).mean.p,
            compare_samples(colored.ours, colored.theirs).mean.p);
}

TEST(CompareSamples, TellsTheSameEveryTime) {
  const Sides s = sides(8, 32);
  EXPECT_EQ(compare_samples(s.ours, s.theirs).p, compare_samples(s.ours, s.theirs).p);
}

std::string refusal(const std::vector<Picture>& ours, const std::vector<Picture>& theirs) {
  try {
    compare_samples(ours, theirs);
  } catch (const Refusal& e) {
    return e.what();
  }
  return "";
}

TEST(CompareSamples, RefusesWhatHasNoNoise) {
  const Sides s = sides(3, 8);
  EXPECT_THAT(refusal({s.ours[0]}, s.theirs), HasSubstr("ours: 1 of the 2"));
  EXPECT_THAT(refusal({}, {}), HasSubstr("ours: 0 of the 2"));
  EXPECT_THAT(refusal(s.ours, {s.theirs[0], s.theirs[1], s.theirs[0]}),
              HasSubstr("theirs: pictures 1 and 3 are equal"));
  EXPECT_THROW(compare_samples(s.ours, sides(3, 9).ours), SizeMismatch);
}

}  // namespace
}  // namespace litmus

// spectrum_test.cpp: spectra by formula, between samples, and their means over bands.
#include "scene/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace litmus {
namespace {

TEST(Spectrum, IsLinearBetweenSamplesAndHoldsItsEnds) {
  const Spectrum ramp{{400, 500, 700}, {1, 3, 2}};
  EXPECT_EQ(value_at(ramp, 300), 1);
  EXPECT_EQ(value_at(ramp, 400), 1);
  EXPECT_DOUBLE_EQ(value_at(ramp, 425), 1.5);
  EXPECT_EQ(value_at(ramp, 500), 3);
  EXPECT_DOUBLE_EQ(value_at(ramp, 600), 2.5);
  EXPECT_EQ(value_at(ramp, 900), 2);
}

TEST(SpectrumMean, IsExactAcrossSamplesAndEnds) {
  const Spectrum peak{{500, 510, 520}, {0, 1, 0}};
  EXPECT_DOUBLE_EQ(mean_over(peak, 500, 520), 0.5);
  EXPECT_DOUBLE_EQ(mean_over(peak, 480, 540), 10.0 / 60);
  EXPECT_DOUBLE_EQ(mean_over(peak, 505, 515), 0.75);
  EXPECT_EQ(mean_over(peak, 600, 610), 0);
}

TEST(SpectrumMean, OfTheBandsIsTheMeanOfTheWhole) {
  const Spectrum a = illuminant_a();
  for (const int count : {1, 3, 40, 400}) {
    const std::vector<double> means = band_means(a, count);
    ASSERT_EQ(means.size(), std::size_t(count));
    EXPECT_NEAR(std::accumulate(means.begin(), means.end(), 0.0) / count,
                mean_over(a, kFirstWavelength, kLastWavelength), 1e-13)
        << count;
  }
}

TEST(Blackbody, IsOneAt560AndPeaksWhereWienSays) {
  for (const double kelvin : {500.0, 2856.0, 5000.0, 100'000.0})
    EXPECT_DOUBLE_EQ(value_at(blackbody(kelvin), 560), 1) << kelvin;
  const Spectrum sun = blackbody(5000);
  double peak = 0;
  for (std::size_t i = 1; i < sun.nm.size(); ++i)
    if (sun.values[i] > value_at(sun, peak)) peak = sun.nm[i];
  EXPECT_NEAR(peak, 2.897771955e6 / 5000, 1);  // Wien's displacement, nm
}

TEST(Blackbody, FallsByRayleighAndJeansWhereItIsHottest) {
  // For h c << lambda k T the power goes with lambda^-4; at 1e5 K the next term is 13 % here.
  const Spectrum hot = blackbody(100'000);
  EXPECT_NEAR(value_at(hot, 400) / value_at(hot, 780), std::pow(780.0 / 400, 4), 2.2);
}

TEST(IlluminantA, HasItsTabulatedValues) {  // CIE 15:2004, table T.1, /100
  EXPECT_NEAR(value_at(illuminant_a(), 380), 0.0979510, 5e-7);
  EXPECT_NEAR(value_at(illuminant_a(), 560), 1, 1e-15);
  EXPECT_NEAR(value_at(illuminant_a(), 780), 2.41675, 5e-5);
}

}  // namespace
}  // namespace litmus

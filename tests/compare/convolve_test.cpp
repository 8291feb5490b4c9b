// convolve_test.cpp: the separable filter against the double sum.
#include "compare/convolve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace litmus {
namespace {

TEST(Correlate, IsTheDoubleSumWithTheBorderContinued) {
  Channel plane{5, 4, {}};
  for (int i = 0; i < 20; ++i) plane.values.push_back(std::sin(3.0 * i));
  const std::vector<double> across{1, -2, 4}, down{0.5, 3, -1, 2, 7};
  const Channel result = correlate(plane, across, down);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) {
      double sum = 0;
      for (int j = -2; j <= 2; ++j)
        for (int i = -1; i <= 1; ++i)
          sum += down[std::size_t(j + 2)] * across[std::size_t(i + 1)] *
                 plane.values[std::size_t(std::clamp(y + j, 0, 3) * 5 + std::clamp(x + i, 0, 4))];
      EXPECT_NEAR(result.values[std::size_t(y * 5 + x)], sum, 1e-12) << x << ", " << y;
    }
}

TEST(Gaussian, HasItsWeightsWhereTheyBelong) {
  const std::vector<double> kernel = gaussian(2, 3);
  ASSERT_EQ(kernel.size(), 7u);
  EXPECT_EQ(kernel[3], 1);
  EXPECT_DOUBLE_EQ(kernel[1], std::exp(-0.5));
  EXPECT_EQ(kernel[5], kernel[1]);
}

TEST(Normalised, KernelSumsToOne) {
  const std::vector<double> kernel = normalised({1, 2, 1});
  EXPECT_EQ(kernel, (std::vector<double>{0.25, 0.5, 0.25}));
}

}  // namespace
}  // namespace litmus

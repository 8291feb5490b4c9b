// convolve.h: one channel of a picture, and separable filters over it.
#pragma once

#include <span>
#include <vector>

namespace litmus {

/// One channel: width * height values, row by row.
struct Channel {
  int width = 0, height = 0;
  std::vector<double> values;
};

/// sum over i, j of down[j] * across[i] * plane(x + i - r, y + j - r): correlation with the outer
/// product of two kernels of 2r + 1 weights (r may differ between them). Beyond its border a plane
/// continues with its border value.
Channel correlate(const Channel& plane, std::span<const double> across,
                  std::span<const double> down);

/// exp(-i^2 / (2 sigma^2)) for i = -radius..radius, not normalised. sigma > 0, in pixels.
std::vector<double> gaussian(double sigma, int radius);

/// The kernel divided by the sum of its weights.
std::vector<double> normalised(std::vector<double> kernel);

}  // namespace litmus

// convolve.cpp: separable filters, along the rows first.
#include "compare/convolve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace litmus {
namespace {

std::size_t index(const Channel& plane, int x, int y) {
  return std::size_t(y) * std::size_t(plane.width) + std::size_t(x);
}

Channel along_rows(const Channel& plane, std::span<const double> kernel) {
  const int radius = int(kernel.size() / 2);
  Channel result{plane.width, plane.height, std::vector<double>(plane.values.size())};
  std::vector<double> padded(std::size_t(plane.width + 2 * radius));
  for (int y = 0; y < plane.height; ++y) {
    for (int x = -radius; x < plane.width + radius; ++x)
      padded[std::size_t(x + radius)] =
          plane.values[index(plane, std::clamp(x, 0, plane.width - 1), y)];
    double* out = &result.values[index(plane, 0, y)];
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (int x = 0; x < plane.width; ++x) out[x] += kernel[k] * padded[std::size_t(x) + k];
  }
  return result;
}

Channel along_columns(const Channel& plane, std::span<const double> kernel) {
  const int radius = int(kernel.size() / 2);
  Channel result{plane.width, plane.height, std::vector<double>(plane.values.size())};
  for (int y = 0; y < plane.height; ++y) {
    double* out = &result.values[index(plane, 0, y)];
    for (int k = 0; k < int(kernel.size()); ++k) {
      const double* in =
          &plane.values[index(plane, 0, std::clamp(y + k - radius, 0, plane.height - 1))];
      for (int x = 0; x < plane.width; ++x) out[x] += kernel[std::size_t(k)] * in[x];
    }
  }
  return result;
}

}  // namespace

Channel correlate(const Channel& plane, std::span<const double> across,
                  std::span<const double> down) {
  return along_columns(along_rows(plane, across), down);
}

std::vector<double> gaussian(double sigma, int radius) {
  std::vector<double> kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(std::exp(-i * i / (2 * sigma * sigma)));
  return kernel;
}

std::vector<double> normalised(std::vector<double> kernel) {
  const double total = std::accumulate(kernel.begin(), kernel.end(), 0.0);
  for (double& weight : kernel) weight /= total;
  return kernel;
}

}  // namespace litmus

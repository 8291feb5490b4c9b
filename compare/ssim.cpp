// ssim.cpp: means, variances and covariance under a Gaussian window.
#include "compare/ssim.h"

#include <algorithm>
#include <cmath>

#include "compare/convolve.h"
#include "compare/difference.h"

namespace litmus {
namespace {

constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

/// IEC 61966-2-1 of a value clipped to [0, 1].
double encoded(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

Channel shown(const Picture& picture, const Picture& other) {
  Channel plane{picture.width, picture.height, std::vector<double>(picture.pixels.size())};
  for (std::size_t i = 0; i < plane.values.size(); ++i) {
    const double own = luminance(picture.pixels[i]);
    if (std::isfinite(own) && std::isfinite(luminance(other.pixels[i])))
      plane.values[i] = encoded(own);
  }
  return plane;
}

/// The windowed mean of a * b.
Channel mean_of_product(const Channel& a, const Channel& b, std::span<const double> window) {
  Channel product = a;
  for (std::size_t i = 0; i < product.values.size(); ++i) product.values[i] *= b.values[i];
  return correlate(product, window, window);
}

}  // namespace

double ssim(const Picture& ours, const Picture& theirs) {
  if (ours.width != theirs.width || ours.height != theirs.height)
    throw SizeMismatch("SSIM: the pictures differ in size; render both at one size");
  if (ours.pixels.empty()) return 1;
  const std::vector<double> window = normalised(gaussian(kSigma, kRadius));
  const Channel a = shown(ours, theirs), b = shown(theirs, ours);
  const Channel mean_a = correlate(a, window, window), mean_b = correlate(b, window, window);
  const Channel aa = mean_of_product(a, a, window), bb = mean_of_product(b, b, window),
                ab = mean_of_product(a, b, window);
  const bool fits = a.width > 2 * kRadius && a.height > 2 * kRadius;
  const int border = fits ? kRadius : 0;
  double total = 0;
  for (int y = border; y < a.height - border; ++y)
    for (int x = border; x < a.width - border; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
      const double ma = mean_a.values[i], mb = mean_b.values[i];
      const double variances = aa.values[i] - ma * ma + bb.values[i] - mb * mb;
      const double covariance = ab.values[i] - ma * mb;
      total += (2 * ma * mb + kC1) * (2 * covariance + kC2) /
               ((ma * ma + mb * mb + kC1) * (variances + kC2));
    }
  const double pixels = double(a.width - 2 * border) * double(a.height - 2 * border);
  return std::min(1.0, total / pixels);  // rounding
}

}  // namespace litmus

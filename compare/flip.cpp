// flip.cpp: colour pipeline, feature pipeline, exposures. [L] and [H] as in flip.h.
#include "compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>

#include "compare/convolve.h"
#include "compare/difference.h"

namespace litmus {
namespace {

using glm::dvec3;
using std::numbers::pi;

// ---- Colour spaces -----------------------------------------------------------------------------

/// Linear sRGB to XYZ under D65, by rows, from the primaries of IEC 61966-2-1.
const glm::dmat3 kXyzOfRgb =
    glm::transpose(glm::dmat3(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794,
                              2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897,
                              1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382));
const glm::dmat3 kRgbOfXyz = glm::inverse(kXyzOfRgb);
const dvec3 kWhite = kXyzOfRgb * dvec3(1);

/// The linearised CIELAB of [L], section 4.1: achromatic, red-green, blue-yellow.
dvec3 opponent(const dvec3& rgb) {
  const dvec3 v = kXyzOfRgb * rgb / kWhite;
  return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

dvec3 rgb_of_opponent(const dvec3& c) {
  const double y = (c.x + 16) / 116;
  return kRgbOfXyz * (kWhite * dvec3(y + c.y / 500, y, y - c.z / 200));
}

/// CIELAB, with a and b scaled by L / 100 for the Hunt effect ([L], section 4.1).
dvec3 hunt_lab(const dvec3& rgb) {
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const dvec3 v = kXyzOfRgb * rgb / kWhite;
  const double fx = f(v.x), fy = f(v.y), fz = f(v.z), lightness = 116 * fy - 16;
  return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

/// Lightness apart, hue and chroma as the crow flies.
double hyab(const dvec3& a, const dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// ---- Colour pipeline ---------------------------------------------------------------------------

using Channels = std::array<Channel, 3>;

/// The contrast sensitivity of one channel: the sum of terms a sqrt(pi / b) exp(-pi^2 x^2 / b), x
/// in degrees ([L], table 1).
struct Term {
  double a, b;
};
constexpr Term kAchromatic{1, 0.0047}, kRedGreen{1, 0.0053};
constexpr std::array<Term, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};

/// The blur of one term, and how much it weighs in its channel.
struct Blur {
  std::vector<double> kernel;
  double weight;
};

Blur blur_of(const Term& term, double pixels_per_degree) {
  // All channels have the support of the widest Gaussian, three standard deviations.
  const double widest = std::sqrt(kBlueYellow[0].b / (2 * pi * pi));
  const int radius = int(std::ceil(3 * widest * pixels_per_degree));
  std::vector<double> kernel =
      gaussian(std::sqrt(term.b / (2 * pi * pi)) * pixels_per_degree, radius);
  const double total = std::accumulate(kernel.begin(), kernel.end(), 0.0);
  return {normalised(kernel), term.a * std::sqrt(pi / term.b) * total * total};
}

Channel blurred(const Channel& plane, const Blur& blur) {
  return correlate(plane, blur.kernel, blur.kernel);
}

/// What the eye resolves of the picture, in Hunt-adjusted CIELAB.
std::vector<dvec3> perceived(const Channels& opponents, double pixels_per_degree) {
  const Channel achromatic = blurred(opponents[0], blur_of(kAchromatic, pixels_per_degree));
  const Channel red_green = blurred(opponents[1], blur_of(kRedGreen, pixels_per_degree));
  const Blur wide = blur_of(kBlueYellow[0], pixels_per_degree);
  const Blur narrow = blur_of(kBlueYellow[1], pixels_per_degree);
  const double share = wide.weight / (wide.weight + narrow.weight);
  const Channel first = blurred(opponents[2], wide), second = blurred(opponents[2], narrow);
  std::vector<dvec3> result(achromatic.values.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double blue_yellow = share * first.values[i] + (1 - share) * second.values[i];
    const dvec3 rgb = rgb_of_opponent({achromatic.values[i], red_green.values[i], blue_yellow});
    result[i] = hunt_lab(glm::clamp(rgb, 0.0, 1.0));
  }
  return result;
}

constexpr double kColorExponent = 0.7;             // qc
constexpr double kBreakAt = 0.4, kBreakTo = 0.95;  // pc, pt
constexpr double kFeatureExponent = 0.5;           // qf
constexpr double kFeatureWidth = 0.082;            // w, degrees

/// Compresses large colour differences: the first pc of the range takes pt of the scale.
double redistributed(double distance) {
  static const double largest =
      std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kColorExponent);
  const double error = std::pow(distance, kColorExponent), knee = kBreakAt * largest;
  if (error < knee) return kBreakTo / knee * error;
  return kBreakTo + (error - knee) / (largest - knee) * (1 - kBreakTo);
}

// ---- Feature pipeline --------------------------------------------------------------------------

/// The kernel with its positive weights scaled to 1 and its negative ones to -1.
std::vector<double> balanced(std::vector<double> kernel) {
  double positive = 0, negative = 0;
  for (const double weight : kernel) (weight > 0 ? positive : negative) += weight;
  for (double& weight : kernel) weight /= weight > 0 ? positive : -negative;
  return kernel;
}

struct Features {
  Channel edges, points;
};

Channel magnitude(const Channel& a, const Channel& b) {
  Channel result = a;
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = std::hypot(a.values[i], b.values[i]);
  return result;
}

/// First and second derivatives of a Gaussian over the luminance ([L], section 4.2).
Features features(const Channels& opponents, double pixels_per_degree) {
  const double sigma = 0.5 * kFeatureWidth * pixels_per_degree;
  const int radius = int(std::ceil(3 * sigma));
  std::vector<double> smooth = gaussian(sigma, radius), first = smooth, second = smooth;
  for (int i = -radius; i <= radius; ++i) {
    first[std::size_t(i + radius)] *= -i;
    second[std::size_t(i + radius)] *= i * i / (sigma * sigma) - 1;
  }
  smooth = normalised(smooth), first = balanced(first), second = balanced(second);
  Channel luminance = opponents[0];
  for (double& value : luminance.values) value = (value + 16) / 116;
  return {magnitude(correlate(luminance, first, smooth), correlate(luminance, smooth, first)),
          magnitude(correlate(luminance, second, smooth), correlate(luminance, smooth, second))};
}

// ---- Together ----------------------------------------------------------------------------------

/// The planes of a picture of values in [0, 1].
Channels opponents_of(const std::vector<dvec3>& shown, int width, int height) {
  Channels planes;
  planes.fill({width, height, std::vector<double>(shown.size())});
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const dvec3 color = opponent(shown[i]);
    for (int channel = 0; channel < 3; ++channel)
      planes[std::size_t(channel)].values[i] = color[channel];
  }
  return planes;
}

/// LDR-FLIP at each pixel of two pictures of values in [0, 1].
std::vector<double> error_map(const std::vector<dvec3>& ours, const std::vector<dvec3>& theirs,
                              int width, int height, double pixels_per_degree) {
  const Channels a = opponents_of(ours, width, height), b = opponents_of(theirs, width, height);
  const std::vector<dvec3> seen_a = perceived(a, pixels_per_degree),
                           seen_b = perceived(b, pixels_per_degree);
  const Features mine = features(a, pixels_per_degree), other = features(b, pixels_per_degree);
  std::vector<double> errors(ours.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double color = redistributed(hyab(seen_a[i], seen_b[i]));
    const double feature = std::max(std::abs(mine.edges.values[i] - other.edges.values[i]),
                                    std::abs(mine.points.values[i] - other.points.values[i]));
    const double strength =
        std::min(1.0, std::pow(feature / std::numbers::sqrt2, kFeatureExponent));
    errors[i] = std::pow(color, 1 - strength);
  }
  return errors;
}

/// The pixels of one picture after `show`; black where either picture is not finite.
template <class Show>
std::vector<dvec3> shown(const Picture& picture, const Picture& other, Show show) {
  std::vector<dvec3> result(picture.pixels.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    if (is_finite(picture.pixels[i]) && is_finite(other.pixels[i]))
      result[i] = show(picture.pixels[i]);
  return result;
}

void require_same_size(const Picture& ours, const Picture& theirs) {
  if (ours.width != theirs.width || ours.height != theirs.height)
    throw SizeMismatch("FLIP: the pictures differ in size; render both at one size");
}

double mean(const std::vector<double>& values) {
  return values.empty()
             ? 0
             : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double xyz_luminance(const dvec3& rgb) { return (kXyzOfRgb * rgb).y; }

// The ACES fit of [H], (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5), with its pre-exposure of 0.6.
constexpr double k0 = 0.6 * 0.6 * 2.51, k1 = 0.6 * 0.03;
constexpr double k3 = 0.6 * 0.6 * 2.43, k4 = 0.6 * 0.59, k5 = 0.14;
constexpr double kToneMapped = 0.85;  // t of [H]: what the brightest and the median are mapped to

double tone_mapped(double x) {
  const double y = (k0 * x * x + k1 * x) / (k3 * x * x + k4 * x + k5);
  return std::isfinite(y) ? std::clamp(y, 0.0, 1.0) : 1;  // infinity / infinity far up the curve
}

/// The value that the curve maps to kToneMapped: the positive root of a quadratic equation.
double before_tone_mapping() {
  const double a = k0 - kToneMapped * k3, b = k1 - kToneMapped * k4, c = -kToneMapped * k5;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

dvec3 exposed(const dvec3& rgb, double stops) {
  const dvec3 x = glm::max(rgb, 0.0) * std::exp2(stops);
  return {tone_mapped(x.x), tone_mapped(x.y), tone_mapped(x.z)};
}

}  // namespace

double ldr_flip(const Picture& ours, const Picture& theirs, double pixels_per_degree) {
  require_same_size(ours, theirs);
  const auto clip = [](const dvec3& rgb) { return glm::clamp(rgb, 0.0, 1.0); };
  return mean(error_map(shown(ours, theirs, clip), shown(theirs, ours, clip), ours.width,
                        ours.height, pixels_per_degree));
}

Exposures exposures_for(const Picture& theirs) {
  std::vector<double> all, lit;
  for (const dvec3& pixel : theirs.pixels) {
    if (!is_finite(pixel)) continue;
    all.push_back(xyz_luminance(glm::max(pixel, 0.0)));
    if (all.back() > 0 && std::isfinite(all.back())) lit.push_back(all.back());
  }
  if (lit.empty()) return {};
  const double brightest = *std::max_element(lit.begin(), lit.end());
  // Half the pixels or more are black: their median says nothing about the rest.
  std::vector<double>& ranked = 2 * lit.size() > all.size() ? all : lit;
  const auto middle = ranked.begin() + std::ptrdiff_t((ranked.size() - 1) / 2);
  std::nth_element(ranked.begin(), middle, ranked.end());
  const double x = before_tone_mapping(), start = std::log2(x / brightest);
  const double stop = std::min(std::log2(x / *middle), start + kMaximumStops);
  return {start, stop, std::max(2, int(std::ceil(stop - start)))};
}

double hdr_flip(const Picture& ours, const Picture& theirs, double pixels_per_degree) {
  require_same_size(ours, theirs);
  const Exposures exposures = exposures_for(theirs);
  std::vector<double> worst(ours.pixels.size());
  const double step = (exposures.stop - exposures.start) / (exposures.count - 1);
  for (int i = 0; i < exposures.count; ++i) {
    if (i > 0 && step == 0) break;  // the same exposure again
    const auto show = [&](const dvec3& rgb) { return exposed(rgb, exposures.start + i * step); };
    const std::vector<double> errors =
        error_map(shown(ours, theirs, show), shown(theirs, ours, show), ours.width, ours.height,
                  pixels_per_degree);
    for (std::size_t k = 0; k < worst.size(); ++k) worst[k] = std::max(worst[k], errors[k]);
  }
  return mean(worst);
}

}  // namespace litmus

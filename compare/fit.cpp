// fit.cpp: robust lines through ours over theirs, and the words for what they say.
#include "compare/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace litmus {
namespace {

using std::numbers::pi;

constexpr std::size_t kMostSamples = 8'000, kFewestSamples = 30;
constexpr double kFlatSpread = 0.02;  // theirs within 2 % says nothing about a slope
constexpr double kTypical = 0.8;      // the quantile of |ours - theirs| that has to be explained
constexpr double kUnexplained = 0.1;  // what may be left of it
constexpr double kSameness = 1e-6;    // of the largest value: there is nothing to explain

struct Point2 {
  double theirs, ours;
};

double quantile(std::vector<double> values, double p) {
  if (values.empty()) return 0;
  const auto nth = values.begin() + std::ptrdiff_t(p * double(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

bool by_theirs(const Point2& a, const Point2& b) {
  return a.theirs != b.theirs ? a.theirs < b.theirs : a.ours < b.ours;
}

/// The finite samples off the edges where theirs is above 0.
std::vector<Point2> positive_samples(const Picture& ours, const Picture& theirs,
                                     std::span<const std::uint8_t> edge) {
  std::vector<Point2> all;
  all.reserve(3 * theirs.pixels.size());
  for (std::size_t i = 0; i < theirs.pixels.size(); ++i) {
    if ((!edge.empty() && edge[i] != 0) || !is_finite(ours.pixels[i]) ||
        !is_finite(theirs.pixels[i]))
      continue;
    for (int c = 0; c < 3; ++c)
      if (theirs.pixels[i][c] > 0) all.push_back({theirs.pixels[i][c], ours.pixels[i][c]});
  }
  return all;
}

/// Of the lit samples as many as tell a line, sorted by theirs.
std::vector<Point2> lit_samples(const Picture& ours, const Picture& theirs,
                                std::span<const std::uint8_t> edge) {
  const std::vector<Point2> all = positive_samples(ours, theirs, edge);
  if (all.empty()) return all;
  std::vector<double> values;
  values.reserve(all.size());
  for (const Point2& p : all) values.push_back(p.theirs);
  const double least = kLitPart * quantile(std::move(values), 0.999);
  std::size_t stride = all.size() / kMostSamples + 1;
  if (stride % 3 == 0) ++stride;  // or only one channel is seen
  std::vector<Point2> some;
  for (std::size_t i = 0; i < all.size(); i += stride)
    if (all[i].theirs > least) some.push_back(all[i]);
  std::sort(some.begin(), some.end(), by_theirs);
  return some;
}

struct Line {
  double slope = 1, offset = 0;
  double at(double x) const { return slope * x + offset; }
};

bool is_flat(std::span<const Point2> points) {
  const double low = points[points.size() / 20].theirs;
  const double high = points[points.size() - 1 - points.size() / 20].theirs;
  return high - low < kFlatSpread * std::max(std::fabs(low), std::fabs(high));
}

/// Theil and Sen's line, each point paired with the one half of all points further on.
Line median_line(std::span<const Point2> points) {
  const std::size_t half = points.size() / 2;
  std::vector<double> slopes, offsets;
  for (std::size_t i = 0; i + half < points.size(); ++i) {
    const Point2 &a = points[i], &b = points[i + half];
    if (b.theirs > a.theirs) slopes.push_back((b.ours - a.ours) / (b.theirs - a.theirs));
  }
  Line line;
  line.slope = quantile(std::move(slopes), 0.5);
  for (const Point2& p : points) offsets.push_back(p.ours - line.slope * p.theirs);
  line.offset = quantile(std::move(offsets), 0.5);
  return line;
}

/// One step of least squares with Tukey's biweight around the line.
Line reweighted(std::span<const Point2> points, const Line& line) {
  std::vector<double> residuals;
  for (const Point2& p : points) residuals.push_back(std::fabs(p.ours - line.at(p.theirs)));
  const double scale = 4.685 * 1.4826 * quantile(residuals, 0.5);
  if (!(scale > 0)) return line;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double u = residuals[i] / scale;
    if (u >= 1) continue;
    const double weight = (1 - u * u) * (1 - u * u);
    const auto [t, o] = points[i];
    n += weight, x += weight * t, y += weight * o, xx += weight * t * t, xy += weight * t * o;
  }
  const double spread = n * xx - x * x;
  if (!(spread > 1e-9 * n * xx)) return line;
  const double slope = (n * xy - x * y) / spread;
  return {slope, (y - slope * x) / n};
}

Line robust_line(std::span<const Point2> points) {
  Line line = median_line(points);
  for (int i = 0; i < 8; ++i) line = reweighted(points, line);
  return line;
}

/// The typical |ours - model(theirs)|.
template <class Model>
double typical_error(std::span<const Point2> points, Model model) {
  std::vector<double> errors;
  for (const Point2& p : points) errors.push_back(std::fabs(p.ours - model(p.theirs)));
  return quantile(std::move(errors), kTypical);
}

ShadingFit fit_samples(std::span<const Point2> points) {
  ShadingFit fit;
  fit.samples = std::int64_t(points.size());
  if (points.size() < kFewestSamples) return fit;
  fit.determined = true;
  const double before = typical_error(points, [](double t) { return t; });
  const auto left = [&](auto model) {
    return before > 0 ? typical_error(points, model) / before : 1;
  };
  if (is_flat(points)) {
    std::vector<double> ratios;
    for (const Point2& p : points) ratios.push_back(p.ours / p.theirs);
    fit.gain = quantile(std::move(ratios), 0.5);
  } else {
    const Line line = robust_line(points);
    fit.gain = line.slope, fit.offset = line.offset;
  }
  fit.unexplained = left([&](double t) { return fit.gain * t + fit.offset; });

  std::vector<Point2> logs;
  for (const Point2& p : points)
    if (p.ours > 0) logs.push_back({std::log(p.theirs), std::log(p.ours)});
  fit.has_slope = !is_flat(points) && logs.size() >= points.size() / 2;
  if (!fit.has_slope) return fit;
  const Line line = robust_line(logs);
  fit.slope = line.slope, fit.level = std::exp(line.offset);
  fit.curve_unexplained = left([&](double t) { return fit.level * std::pow(t, fit.slope); });
  return fit;
}

// ---- Words -----------------------------------------------------------------------------------

struct Factor {
  double value;
  std::string_view words;
};

constexpr std::array<Factor, 6> kFactors{{
    {pi, "a factor of pi, as when irradiance is taken for radiance"},
    {1 / pi, "a factor of 1/pi, as when the 1/pi of a matte surface is applied once too often"},
    {4 * pi, "a factor of 4 pi, as when a lamp's W are taken for W/sr"},
    {1 / (4 * pi), "a factor of 1/(4 pi), as when a lamp's W/sr are taken for W"},
    {2, "a factor of 2, as when a light counts twice"},
    {0.5, "a factor of 1/2, as when a light is shared by two sides"},
}};

bool near(double value, double wanted, double slack = kFactorSlack) {
  return std::fabs(value - wanted) <= slack * std::fabs(wanted);
}

/// The transfer function of sRGB (IEC 61966-2-1), continued over 1.
double srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double linear_of(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

std::string factor_words(const ShadingFit& fit) {
  for (const Factor& factor : kFactors)
    if (near(fit.gain, factor.value))
      return fmt::format("ours is {:.5g} times theirs: {}", fit.gain, factor.words);
  return "";
}

/// sRGB or a power of 2.2, whichever comes closest; empty if none comes close.
std::string curve_words(std::span<const Point2> points, const ShadingFit& fit, double before) {
  const std::array<std::pair<double, std::string_view>, 4> curves{{
      {typical_error(points, srgb),
       "ours is theirs sRGB-encoded, as when ours was made for display and theirs is linear light"},
      {typical_error(points, linear_of),
       "theirs is ours sRGB-encoded, as when an image for display is taken for linear light"},
      {typical_error(points, [](double t) { return std::pow(t, 1 / 2.2); }),
       "a gamma of 1/2.2, as when ours was made for display and theirs is linear light"},
      {typical_error(points, [](double t) { return std::pow(t, 2.2); }),
       "a gamma of 2.2, as when an image for display is taken for linear light"},
  }};
  const auto best = std::min_element(curves.begin(), curves.end());
  if (!(best->first <= kUnexplained * before)) return "";
  if (best < curves.begin() + 2) return std::string(best->second);
  if (!fit.has_slope) return fmt::format("ours is theirs by {}", best->second);
  return fmt::format("ours is theirs to the power {:.4g}: {}", fit.slope, best->second);
}

}  // namespace

ShadingFit fit_shading(const Picture& ours, const Picture& theirs,
                       std::span<const std::uint8_t> edge) {
  return fit_samples(lit_samples(ours, theirs, edge));
}

std::string explain_units(const Picture& ours, const Picture& theirs,
                          std::span<const std::uint8_t> edge) {
  const std::vector<Point2> points = lit_samples(ours, theirs, edge);
  const ShadingFit fit = fit_samples(points);
  if (!fit.determined) return "";
  const double largest = points.back().theirs;
  const double before = typical_error(points, [](double t) { return t; });
  if (!(before > kSameness * largest)) return "";

  // A factor alone, then curves, then what any line says.
  const bool line_fits = fit.unexplained <= kUnexplained;
  const bool through_zero = std::fabs(fit.offset) <= kFactorSlack * std::fabs(fit.gain) * largest;
  if (line_fits && through_zero)
    if (const std::string words = factor_words(fit); !words.empty()) return words;
  if (const std::string words = curve_words(points, fit, before); !words.empty()) return words;
  if (!line_fits) return "";
  const double moved = std::fabs(fit.offset), scaled = std::fabs(fit.gain - 1) * largest;
  if (moved <= 0.02 * scaled) return fmt::format("ours is {:.5g} times theirs", fit.gain);
  if (scaled <= 0.02 * moved)
    return fmt::format("ours is theirs {} {:.4g} everywhere", fit.offset > 0 ? "plus" : "minus",
                       moved);
  return "";
}

}  // namespace litmus

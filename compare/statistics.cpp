// statistics.cpp: Welch's t over means and tiles, relabelling over pixels.
#include "compare/statistics.h"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "compare/difference.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

/// Means, and the variances of the means.
struct Moments {
  double difference, variance_ours, variance_theirs;
  double count_ours, count_theirs;
};

double degrees_of_freedom(const Moments& m) {
  const double variance = m.variance_ours + m.variance_theirs;
  if (!(variance > 0)) return m.count_ours + m.count_theirs - 2;
  // Shares keep the squares of tiny variances from underflowing.
  const double a = m.variance_ours / variance, b = m.variance_theirs / variance;
  return 1 / (a * a / (m.count_ours - 1) + b * b / (m.count_theirs - 1));
}

Welch welch_of(const Moments& m, double degrees, double negligible) {
  const double variance = m.variance_ours + m.variance_theirs;
  const double beyond = std::max(0.0, std::abs(m.difference) - negligible);
  const double t = beyond > 0 ? beyond / std::sqrt(variance) : 0;
  if (std::isinf(t)) return {std::copysign(t, m.difference), degrees, 0};
  return {std::copysign(t, m.difference), degrees, 2 * gsl_cdf_tdist_Q(t, degrees)};
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// The variance of the mean of the values.
double variance_of_mean(std::span<const double> values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / double(values.size() - 1) / double(values.size());
}

Moments moments_of(std::span<const double> ours, std::span<const double> theirs) {
  return {mean_of(ours) - mean_of(theirs), variance_of_mean(ours), variance_of_mean(theirs),
          double(ours.size()), double(theirs.size())};
}

// ---- The pictures as numbers -------------------------------------------------------------------

/// All seeds of both sides, ours first, by channel.
struct Stack {
  int width = 0, height = 0, ours = 0, theirs = 0;
  /// channel, seed, pixel. Each pixel without its mean over all seeds, which no test depends on.
  std::vector<std::vector<std::vector<float>>> channels;
  std::int64_t nonfinite = 0;
  int seeds() const { return ours + theirs; }
};

void require_usable(std::span<const Picture> side, const Picture& first, std::string_view name) {
  if (side.size() < 2)
    throw Refusal(
        fmt::format("{}: {} of the 2 pictures that show noise; use 8 or more, each with "
                    "another seed",
                    name, side.size()));
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side[i].width != first.width || side[i].height != first.height)
      throw SizeMismatch(fmt::format("{}: picture {} is {} x {}, another is {} x {}", name, i + 1,
                                     side[i].width, side[i].height, first.width, first.height));
    for (std::size_t k = 0; k < i; ++k)
      if (side[i].pixels == side[k].pixels)
        throw Refusal(fmt::format("{}: pictures {} and {} are equal; render each with another seed",
                                  name, k + 1, i + 1));
  }
}

bool is_grey(const Picture& picture) {
  return std::all_of(picture.pixels.begin(), picture.pixels.end(), [](const glm::dvec3& v) {
    return !is_finite(v) || (v.x == v.y && v.x == v.z);
  });
}

Stack stack_of(std::span<const Picture> ours, std::span<const Picture> theirs) {
  std::vector<const Picture*> all;
  for (const Picture& picture : ours) all.push_back(&picture);
  for (const Picture& picture : theirs) all.push_back(&picture);
  Stack stack{all[0]->width, all[0]->height, int(ours.size()), int(theirs.size()), {}, 0};
  const bool grey = std::all_of(all.begin(), all.end(), [](auto* p) { return is_grey(*p); });
  const std::size_t pixels = all[0]->pixels.size();
  stack.channels.assign(grey ? 1 : 3, std::vector(all.size(), std::vector<float>(pixels)));
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!std::all_of(all.begin(), all.end(), [&](auto* p) { return is_finite(p->pixels[i]); })) {
      ++stack.nonfinite;
      continue;
    }
    for (std::size_t c = 0; c < stack.channels.size(); ++c) {
      double mean = 0;
      for (const Picture* picture : all) mean += picture->pixels[i][int(c)] / double(all.size());
      for (std::size_t s = 0; s < all.size(); ++s)
        stack.channels[c][s][i] = float(all[s]->pixels[i][int(c)] - mean);
    }
  }
  return stack;
}

// ---- Pixels under one deal ---------------------------------------------------------------------

/// A rectangle of pixels.
struct Area {
  int x, y, width, height;
};

/// Mean difference and variances of every pixel of one channel, however the seeds are dealt to the
/// two sides.
class Pixels {
 public:
  Pixels(const std::vector<std::vector<float>>& seeds, int width)
      : seeds_(seeds), width_(width), squares_(seeds[0].size()) {
    for (const std::vector<float>& seed : seeds)
      for (std::size_t i = 0; i < seed.size(); ++i) squares_[i] += seed[i] * seed[i];
  }

  /// Sums the seeds of the first side. The pixels' means are 0, so the rest is the other side.
  void deal(std::span<const int> first_side) {
    sum_.assign(squares_.size(), 0);
    square_.assign(squares_.size(), 0);
    for (const int index : first_side) {
      const float* values = seeds_[std::size_t(index)].data();
      for (std::size_t i = 0; i < sum_.size(); ++i) {
        sum_[i] += values[i];
        square_[i] += values[i] * values[i];
      }
    }
    a_ = float(first_side.size()), b_ = float(seeds_.size()) - a_;
  }

  Moments at(std::size_t i) const {
    const float sum = sum_[i], square = square_[i], all = squares_[i];
    // Float sums leave a variance of 1e-7 where there is none: the least is a little more.
    const float least = 1e-6f * all;
    const float inside_a = std::max(least, square - sum * sum / a_);
    const float inside_b = std::max(least, all - square - sum * sum / b_);
    return {double(sum * (1 / a_ + 1 / b_)), double(inside_a / (a_ * (a_ - 1))),
            double(inside_b / (b_ * (b_ - 1))), double(a_), double(b_)};
  }

  /// Welch's t, squared; 0 where it is below `threshold`.
  double squared_t(std::size_t i, double threshold, double negligible) const {
    const Moments m = at(i);
    const double variance = m.variance_ours + m.variance_theirs;
    if (m.difference * m.difference <= threshold * variance) return 0;  // most end here
    const double beyond = std::max(0.0, std::abs(m.difference) - negligible);
    const double t2 = beyond * beyond / variance;
    return t2 > threshold ? t2 : 0;
  }

  /// Degrees of freedom by the two sides' variances over a whole area.
  double pooled_degrees(const Area& area) const {
    Moments sum{0, 0, 0, double(a_), double(b_)};
    for (int y = area.y; y < area.y + area.height; ++y)
      for (int x = area.x; x < area.x + area.width; ++x) {
        const Moments m = at(index(x, y));
        sum.variance_ours += m.variance_ours, sum.variance_theirs += m.variance_theirs;
      }
    return degrees_of_freedom(sum);
  }

  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }
  std::size_t size() const { return squares_.size(); }

 private:
  const std::vector<std::vector<float>>& seeds_;
  int width_;
  std::vector<float> squares_, sum_, square_;
  float a_ = 0, b_ = 0;
};

std::vector<Area> areas(const Stack& stack, int width, int height) {
  std::vector<Area> result;
  for (int y = 0; y < stack.height; y += height)
    for (int x = 0; x < stack.width; x += width)
      result.push_back(
          {x, y, std::min(width, stack.width - x), std::min(height, stack.height - y)});
  return result;
}

// ---- Means and tiles ---------------------------------------------------------------------------

/// The mean of an area of one channel, seed by seed.
std::vector<double> means(const Stack& stack, std::size_t channel, const Area& area) {
  std::vector<double> result;
  for (const std::vector<float>& seed : stack.channels[channel]) {
    double sum = 0;
    for (int y = area.y; y < area.y + area.height; ++y) {
      const float* row = &seed[std::size_t(y) * std::size_t(stack.width) + std::size_t(area.x)];
      for (int x = 0; x < area.width; ++x) sum += double(row[x]);
    }
    result.push_back(sum / area.width / area.height);
  }
  return result;
}

/// The worst of all areas of the given size.
Finding worst_area(const Stack& stack, const std::vector<Pixels>& channels, int width, int height,
                   double negligible) {
  Finding worst;
  int count = 0;
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (const Area& area : areas(stack, width, height)) {
      const std::vector<double> values = means(stack, c, area);
      const Moments m = moments_of(std::span(values).first(std::size_t(stack.ours)),
                                   std::span(values).last(std::size_t(stack.theirs)));
      const double degrees = std::min(degrees_of_freedom(m), channels[c].pooled_degrees(area));
      const double p = welch_of(m, degrees, negligible).p;
      if (++count == 1 || p < worst.p) worst = {p, m.difference, int(c), {area.x, area.y}};
    }
  worst.p = sidak(worst.p, count);
  return worst;
}

// ---- The worst pixel ---------------------------------------------------------------------------

/// The number of different ways to deal the seeds, as far as 1e9.
double deals(int ours, int theirs) {
  double count = 1;
  for (int i = 1; i <= ours && count < 1e9; ++i) count *= double(theirs + i) / i;
  return ours == theirs ? count / 2 : count;  // the statistic has no sign
}

/// The first `count` of the numbers 0..n-1 in random order.
void shuffle_front(std::vector<int>& order, std::size_t count, std::mt19937_64& random) {
  for (std::size_t i = 0; i < count; ++i)
    std::swap(order[i], order[i + std::size_t(random() % (order.size() - i))]);
}

constexpr int kEnoughExceedances = 20;
constexpr double kEnoughDeals = 1000;  // fewer cannot give a p-value of kAlpha / 3

/// How often random deals have a squared t of at least `t2` anywhere, as a p-value.
double relabelled_p(const Stack& stack, std::vector<Pixels> channels, double t2,
                    const SampleOptions& options) {
  std::mt19937_64 random(options.seed);
  std::vector<int> order(std::size_t(stack.seeds()));
  std::iota(order.begin(), order.end(), 0);
  const double reached = t2 * (1 - 1e-3);  // equal but for the rounding of float sums
  const auto reaches = [&](Pixels& pixels, std::span<const int> first_side) {
    pixels.deal(first_side);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (pixels.squared_t(i, reached, options.negligible) > 0) return true;
    return false;
  };
  int exceedances = 0;
  for (int shuffle = 1; shuffle <= options.shuffles; ++shuffle) {
    shuffle_front(order, std::size_t(stack.ours), random);
    const auto first_side = std::span(order).first(std::size_t(stack.ours));
    exceedances += std::any_of(channels.begin(), channels.end(),
                               [&](Pixels& each) { return reaches(each, first_side); });
    if (exceedances == kEnoughExceedances) return double(exceedances) / shuffle;
  }
  return double(exceedances + 1) / (options.shuffles + 1);
}

/// The largest squared t of an area and its pixel.
struct Peak {
  double t2 = 0;
  int x = 0, y = 0;
};

Peak peak_of(const Pixels& pixels, const Area& area, double negligible) {
  Peak peak{0, area.x, area.y};
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) {
      const double t2 = pixels.squared_t(pixels.index(x, y), peak.t2, negligible);
      if (t2 > 0) peak = {t2, x, y};
    }
  return peak;
}

Finding worst_pixel(const Stack& stack, const std::vector<Pixels>& channels,
                    const SampleOptions& options) {
  Finding worst;
  double largest = 0;
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (const Area& area : areas(stack, kTile, kTile)) {
      const Peak peak = peak_of(channels[c], area, options.negligible);
      if (peak.t2 == 0) continue;
      largest = std::max(largest, peak.t2);
      const Moments m = channels[c].at(channels[c].index(peak.x, peak.y));
      const double p = welch_of(m, channels[c].pooled_degrees(area), options.negligible).p;
      if (p < worst.p) worst = {p, m.difference, int(c), {peak.x, peak.y}};
    }
  worst.p = sidak(worst.p, double(channels.size() * channels[0].size()));
  const bool decided = worst.p > kAlpha || deals(stack.ours, stack.theirs) < kEnoughDeals;
  if (!decided) worst.p = std::max(worst.p, relabelled_p(stack, channels, largest, options));
  return worst;
}

constexpr MeasuredRate kMeasured[] = {
    {"no difference, normal noise", 8, 48, 1000, 0.006},
    {"no difference, 10 times the noise on one side", 8, 32, 1000, 0.008},
    {"no difference, fireflies", 8, 32, 1000, 0},
    {"no difference, a light seen or not", 8, 32, 1000, 0.005},
    {"bias of 0.05 sigma everywhere", 8, 128, 100, 1},
    {"16 x 16 spot of 1 sigma anywhere", 8, 128, 100, 1},
    {"one pixel of 15 sigma", 8, 64, 20, 1},
};

}  // namespace

Welch welch(std::span<const double> ours, std::span<const double> theirs, double negligible) {
  const Moments m = moments_of(ours, theirs);
  return welch_of(m, degrees_of_freedom(m), negligible);
}

double sidak(double p, double count) { return p >= 1 ? 1 : -std::expm1(count * std::log1p(-p)); }

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    largest = std::max(largest, std::min(1.0, double(p.size() - rank) * p[order[rank]]));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

SampleComparison compare_samples(std::span<const Picture> ours, std::span<const Picture> theirs,
                                 const SampleOptions& options) {
  const Picture& first = ours.empty() ? theirs.empty() ? Picture() : theirs[0] : ours[0];
  require_usable(ours, first, "ours");
  require_usable(theirs, first, "theirs");
  const Stack stack = stack_of(ours, theirs);
  SampleComparison result{stack.ours, stack.theirs, stack.nonfinite, {}, {}, {}, 1};
  std::vector<int> as_they_are(ours.size());
  std::iota(as_they_are.begin(), as_they_are.end(), 0);
  std::vector<Pixels> channels;
  for (const auto& seeds : stack.channels) {
    channels.emplace_back(seeds, stack.width);
    channels.back().deal(as_they_are);
  }
  result.mean = worst_area(stack, channels, stack.width, stack.height, options.negligible);
  result.tile = worst_area(stack, channels, kTile, kTile, options.negligible);
  result.pixel = worst_pixel(stack, channels, options);
  result.p = std::min(1.0, 3 * std::min({result.mean.p, result.tile.p, result.pixel.p}));
  return result;
}

std::span<const MeasuredRate> measured_rates() { return kMeasured; }

}  // namespace litmus

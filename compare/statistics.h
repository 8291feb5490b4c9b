// statistics.h: are two noisy renderers the same? Hypothesis tests over several seeds a side.
//
// After Jung, Hanika, Dachsbacher, "Detecting Bias in Monte Carlo Renderers using Welch's t-test"
// (2020), with the number of tests accounted for.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scene/picture.h"

namespace litmus {

/// Welch's test of two means with unknown, unequal variances.
struct Welch {
  double t = 0;                   ///< infinite where neither side varies and the means differ
  double degrees_of_freedom = 1;  ///< after Welch and Satterthwaite
  double p = 1;                   ///< two-sided, by Student's t distribution
};

/// Differences of the means up to `negligible` count as none, and larger ones lose as much. Both
/// sides have at least two values.
Welch welch(std::span<const double> ours, std::span<const double> theirs, double negligible = 0);

/// 1 - (1 - p)^count: how often the least of `count` independent p-values is at most p (Sidak).
double sidak(double p, double count);

/// Holm's adjusted p-values: rejecting those at most alpha keeps the chance of any false rejection
/// among all of them at most alpha, whatever their dependence.
std::vector<double> holm(std::span<const double> p);

struct SampleOptions {
  double negligible = 0;   ///< a difference up to this is no difference, as in `welch`
  int shuffles = 999;      ///< of the pixel test; 300 per compared pair are the least of any use
  std::uint64_t seed = 1;  ///< of the shuffles
};

/// Seeds a side below which the pixel test rests on normal noise, and a warning is due.
inline constexpr int kEnoughSeeds = 8;
inline constexpr double kAlpha = 0.01;  ///< of all comparisons of one call together
inline constexpr int kTile = 16;        ///< pixels

/// Where one test sees the largest evidence.
struct Finding {
  double p = 1;                 ///< adjusted for all places and channels the test looks at
  double difference = 0;        ///< ours - theirs there, of the means over the seeds
  int channel = 0;              ///< 0, 1, 2: red, green, blue
  std::array<int, 2> at{0, 0};  ///< x, y of the pixel or of the tile's first pixel
};

struct SampleComparison {
  int ours = 0, theirs = 0;    ///< seeds
  std::int64_t nonfinite = 0;  ///< pixels that are NaN or infinite in some seed; they take no part
  Finding mean;                ///< of the whole picture
  Finding tile;                ///< the worst of the tiles of kTile x kTile pixels
  Finding pixel;               ///< the worst pixel
  double p = 1;                ///< of all three: the least, times 3
};

/// Compares two renderers by their pictures with different seeds. Each channel is tested by itself,
/// but equal channels (grey pictures) count once. The three tests share alpha: p is three times the
/// least of theirs (Bonferroni).
///
/// mean, tile: Welch's t over the seeds' means, with Student's quantiles; Sidak over channels and
/// tiles. A mean over many pixels is close to normal however heavy the tails of a pixel's noise.
///
/// pixel: the largest of all pixels' Welch statistics. Its p is the larger of two:
///   - Sidak over Student's quantiles, right for normal noise, however different on the two sides.
///     But tens of thousands of pixels need quantiles far out, where fireflies and a light that is
///     either seen or not are nothing like normal.
///   - relabelling: how often seeds dealt to the two sides at random give a value as large anywhere
///     (Westfall and Young 1993), stopped at the 20th such deal (Besag and Clifford 1991). Right
///     for any noise that is alike on the two sides. At least 1 / (shuffles + 1) and 1 / number of
///     different deals, which 8 seeds a side make 6435. Done where the first is at most kAlpha, and
///     where there are 1000 deals (from 7 seeds a side on).
///
/// Degrees of freedom are those of the variances summed over a tile's pixels: so far out, a pixel's
/// own are too high where its noise happens to look small, which is where t is large. (With 10
/// times the noise on one side, a pixel's own gave 2.1 % of false alarms, relabelling alone 46 %.)
///
/// Throws Refusal with fewer than 2 seeds a side, with two equal pictures on one side, and
/// SizeMismatch.
SampleComparison compare_samples(std::span<const Picture> ours, std::span<const Picture> theirs,
                                 const SampleOptions& options = {});

/// What the tests were measured to do, at kAlpha. Printed, and held to within 0.4 % (rates of false
/// alarms) or 2 % (power), by: compare_tests --gtest_filter='*SampleTests.*'
struct MeasuredRate {
  std::string_view what;
  int seeds;    ///< a side
  int size;     ///< pixels, width and height
  int runs;     ///< simulated comparisons
  double rate;  ///< the share that was called different
};

/// "sigma" is the standard deviation of a pixel between seeds. The first rows have nothing to find.
std::span<const MeasuredRate> measured_rates();

}  // namespace litmus

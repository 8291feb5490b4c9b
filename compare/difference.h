// difference.h: how far two pictures are apart, as figures over one region.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scene/picture.h"
#include "scene/refusal.h"

namespace litmus {

/// Edge and interior share the picture (regions.h); the others are parts of the interior.
enum class Region { Interior, Edge, All, Lit, Penumbra, Umbra, Highlight };

/// "interior", "edge", "all", "lit", "penumbra", "umbra" or "highlight".
std::string_view name_of(Region region);

/// Two pictures that cannot be compared because their sizes differ.
struct SizeMismatch : Refusal {
  using Refusal::Refusal;
};

/// d = ours - theirs. Counts are of pixels; every other figure is over pixels x channels, without
/// the pixels that are not finite. No figure is ever NaN or infinite.
struct Difference {
  std::int64_t pixels = 0;                     ///< in the region, finite or not
  std::int64_t nonfinite = 0;                  ///< with a NaN or an infinity in either picture
  double bias = 0;                             ///< mean of d
  double mean_abs = 0;                         ///< mean of |d|
  double max_abs = 0;                          ///< largest |d|
  std::array<int, 2> max_at{0, 0};             ///< x, y of the first pixel with max_abs
  double rmse = 0;                             ///< root of the mean of d^2
  double p50 = 0, p95 = 0, p99 = 0, p999 = 0;  ///< percentiles of |d| by nearest rank
  double max_relative = 0;                     ///< largest |d| / max(|theirs|, kRelativeFloor)
  std::int64_t over_tolerance = 0;             ///< pixels with |d| > tolerance in some channel

  struct Pixel {
    int x = 0, y = 0;
    double max_abs = 0;
  };
  std::vector<Pixel> over;  ///< the pixels of over_tolerance, worst first
};

/// Below this, a relative difference is measured against the floor itself.
inline constexpr double kRelativeFloor = 1e-3;

/// Compares the pixels of the interior, the edge or all. `edge` is 1 where a pixel is an edge,
/// width
/// * height; it may be empty where no pixel is. A region without pixels gives zeros everywhere.
/// Values up to 1e308 and down to 1e-308 neither overflow nor underflow. Throws SizeMismatch if the
/// pictures (or the mask) differ in size.
Difference difference(const Picture& ours, const Picture& theirs,
                      std::span<const std::uint8_t> edge, Region region, double tolerance);

/// The same over the pixels where `members` (as by region_mask) is not 0.
Difference difference(const Picture& ours, const Picture& theirs,
                      std::span<const std::uint8_t> members, double tolerance);

/// One figure of a Difference, or of any row with the same members.
template <class Row>
struct Metric {
  std::string_view name;     ///< the key in files
  std::string_view title;    ///< the words in a table's head
  std::string_view meaning;  ///< one phrase
  double Row::*member;
};

/// The figures that writers print, in this order. A new error measure is a member and a row here.
template <class Row>
inline constexpr std::array<Metric<Row>, 9> kMetrics{{
    {"max_abs", "largest", "the largest |ours - theirs|", &Row::max_abs},
    {"mean_abs", "mean", "the mean of |ours - theirs|", &Row::mean_abs},
    {"bias", "bias", "the mean of ours - theirs, with its sign", &Row::bias},
    {"rmse", "rms", "the root of the mean of (ours - theirs) squared", &Row::rmse},
    {"p50", "p50", "half of all |ours - theirs| are at most this", &Row::p50},
    {"p95", "p95", "95 % of all |ours - theirs| are at most this", &Row::p95},
    {"p99", "p99", "99 % of all |ours - theirs| are at most this", &Row::p99},
    {"p999", "p99.9", "99.9 % of all |ours - theirs| are at most this", &Row::p999},
    {"max_relative", "relative", "the largest |ours - theirs| / max(|theirs|, 0.001)",
     &Row::max_relative},
}};

}  // namespace litmus

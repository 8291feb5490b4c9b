// difference.cpp: the figures of a difference, in one pass and a few partial sorts.
#include "compare/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace litmus {
namespace {

// Squares of any double fit: neither sums nor squares need scaling. It is slow, so plain double is
// used where the differences are of a common size.
using Wide = long double;
static_assert(std::numeric_limits<Wide>::max_exponent10 >= 4000 &&
              std::numeric_limits<Wide>::min_exponent10 <= -4000);
constexpr double kLeastCommon = 1e-140, kMostCommon = 1e140;

double narrow(Wide value) {
  constexpr Wide limit = std::numeric_limits<double>::max();
  return double(std::clamp(value, -limit, limit));
}

void check_sizes(const Picture& ours, const Picture& theirs, std::size_t edge_pixels) {
  if (ours.width != theirs.width || ours.height != theirs.height)
    throw SizeMismatch(
        fmt::format("ours is {} x {} pixels, theirs {} x {}: only pictures of one size "
                    "are compared",
                    ours.width, ours.height, theirs.width, theirs.height));
  if (edge_pixels != 0 && edge_pixels != ours.pixels.size())
    throw SizeMismatch(fmt::format("the edge mask has {} pixels, the pictures {}", edge_pixels,
                                   ours.pixels.size()));
}

bool is_in(Region region, bool edge) {
  return region == Region::All || edge == (region == Region::Edge);
}

template <class Real>
struct Sums {
  Real signed_sum = 0, absolute = 0, squares = 0;
  std::vector<double> magnitudes;  // |d| per channel
};

// Adds one finite pixel's three channels.
template <class Real>
void add(Difference& result, Sums<Real>& sums, const glm::dvec3& ours, const glm::dvec3& theirs,
         int x, int y, double tolerance) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const Real d = Real(ours[c]) - Real(theirs[c]);
    double magnitude = double(std::abs(d));
    if constexpr (std::is_same_v<Real, Wide>) magnitude = narrow(std::abs(d));
    sums.signed_sum += d;
    sums.absolute += std::abs(d);
    sums.squares += d * d;
    sums.magnitudes.push_back(magnitude);
    worst = std::max(worst, magnitude);
    const double scale = std::max(std::abs(theirs[c]), kRelativeFloor);
    if (magnitude > result.max_relative * scale) result.max_relative = magnitude / scale;
  }
  if (worst > result.max_abs) {
    result.max_abs = worst;
    result.max_at = {x, y};
  }
  if (worst > tolerance) result.over.push_back({x, y, worst});
}

// The smallest value that at least the fraction p of all values do not exceed (nearest rank). Those
// before `from` are no greater than the rest, and do not hold it. Returns its place.
std::size_t percentile(std::vector<double>& values, std::size_t from, double p, double& value) {
  const double rank = std::ceil(p * double(values.size()));
  const std::size_t nth = std::max(from, std::size_t(std::max(rank, 1.0)) - 1);
  std::nth_element(values.begin() + std::ptrdiff_t(from), values.begin() + std::ptrdiff_t(nth),
                   values.end());
  value = values[nth];
  return nth;
}

template <class Real>
void finish(Difference& result, Sums<Real>& sums) {
  result.over_tolerance = std::int64_t(result.over.size());
  std::stable_sort(result.over.begin(), result.over.end(),
                   [](const auto& a, const auto& b) { return a.max_abs > b.max_abs; });
  if (sums.magnitudes.empty()) return;
  result.max_relative = narrow(result.max_relative);
  const auto count = Real(sums.magnitudes.size());
  result.bias = narrow(sums.signed_sum / count);
  result.mean_abs = narrow(sums.absolute / count);
  result.rmse = narrow(std::sqrt(sums.squares / count));
  // From the lowest up: each sorts what the one before left above it.
  std::size_t from = 0;
  from = percentile(sums.magnitudes, from, 0.5, result.p50);
  from = percentile(sums.magnitudes, from, 0.95, result.p95);
  from = percentile(sums.magnitudes, from, 0.99, result.p99);
  percentile(sums.magnitudes, from, 0.999, result.p999);
}

template <class Real>
Difference difference_in(const Picture& ours, const Picture& theirs,
                         std::span<const std::uint8_t> members, double tolerance) {
  Difference result;
  Sums<Real> sums;
  sums.magnitudes.reserve(3 * ours.pixels.size());
  for (int y = 0; y < ours.height; ++y)
    for (int x = 0; x < ours.width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(ours.width) + std::size_t(x);
      if (members.empty() || members[i] == 0) continue;
      ++result.pixels;
      if (is_finite(ours.pixels[i]) && is_finite(theirs.pixels[i]))
        add(result, sums, ours.pixels[i], theirs.pixels[i], x, y, tolerance);
      else
        ++result.nonfinite;
    }
  finish(result, sums);
  return result;
}

}  // namespace

std::string_view name_of(Region region) {
  switch (region) {
    case Region::Interior:
      return "interior";
    case Region::Edge:
      return "edge";
    case Region::Lit:
      return "lit";
    case Region::Penumbra:
      return "penumbra";
    case Region::Umbra:
      return "umbra";
    case Region::Highlight:
      return "highlight";
    case Region::All:
      break;
  }
  return "all";
}

Difference difference(const Picture& ours, const Picture& theirs,
                      std::span<const std::uint8_t> members, double tolerance) {
  check_sizes(ours, theirs, members.size());
  Difference result = difference_in<double>(ours, theirs, members, tolerance);
  const double largest = result.max_abs;
  if (largest == 0 || (largest > kLeastCommon && largest < kMostCommon)) return result;
  return difference_in<Wide>(ours, theirs, members, tolerance);
}

Difference difference(const Picture& ours, const Picture& theirs,
                      std::span<const std::uint8_t> edge, Region region, double tolerance) {
  check_sizes(ours, theirs, edge.size());
  std::vector<std::uint8_t> members(ours.pixels.size());
  for (std::size_t i = 0; i < members.size(); ++i)
    members[i] = is_in(region, !edge.empty() && edge[i] != 0);
  return difference(ours, theirs, members, tolerance);
}

}  // namespace litmus

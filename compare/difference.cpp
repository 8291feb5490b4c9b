// difference.cpp: the figures of a difference, in one pass and a few partial sorts.
#include "compare/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace litmus {
namespace {

// Squares of any double fit: neither sums nor squares below need scaling.
using Wide = long double;
static_assert(std::numeric_limits<Wide>::max_exponent10 >= 4000 &&
              std::numeric_limits<Wide>::min_exponent10 <= -4000);

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

struct Sums {
  Wide signed_sum = 0, absolute = 0, squares = 0;
  std::vector<double> magnitudes;  // |d| per channel
};

// Adds one finite pixel's three channels.
void add(Difference& result, Sums& sums, const glm::dvec3& ours, const glm::dvec3& theirs, int x,
         int y, double tolerance) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const Wide d = Wide(ours[c]) - Wide(theirs[c]);
    const double magnitude = narrow(std::abs(d));
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

// The smallest value that at least the fraction p of all values do not exceed (nearest rank);
// the first `within` are no greater than the rest, and hold it. Returns its rank.
std::size_t percentile(std::vector<double>& values, std::size_t within, double p, double& value) {
  const double rank = std::ceil(p * double(values.size()));
  const auto nth = std::min(within, std::size_t(std::max(rank, 1.0))) - 1;
  const auto first = values.begin();
  std::nth_element(first, first + std::ptrdiff_t(nth), first + std::ptrdiff_t(within));
  value = values[nth];
  return nth + 1;
}

void finish(Difference& result, Sums& sums) {
  result.over_tolerance = std::int64_t(result.over.size());
  std::stable_sort(result.over.begin(), result.over.end(),
                   [](const auto& a, const auto& b) { return a.max_abs > b.max_abs; });
  if (sums.magnitudes.empty()) return;
  result.max_relative = narrow(result.max_relative);
  const auto count = Wide(sums.magnitudes.size());
  result.bias = narrow(sums.signed_sum / count);
  result.mean_abs = narrow(sums.absolute / count);
  result.rmse = narrow(std::sqrt(sums.squares / count));
  // From the highest down: each sorts what the one before left below it.
  std::size_t within = sums.magnitudes.size();
  within = percentile(sums.magnitudes, within, 0.999, result.p999);
  within = percentile(sums.magnitudes, within, 0.99, result.p99);
  within = percentile(sums.magnitudes, within, 0.95, result.p95);
  percentile(sums.magnitudes, within, 0.5, result.p50);
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
  Difference result;
  Sums sums;
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

Difference difference(const Picture& ours, const Picture& theirs,
                      std::span<const std::uint8_t> edge, Region region, double tolerance) {
  check_sizes(ours, theirs, edge.size());
  std::vector<std::uint8_t> members(ours.pixels.size());
  for (std::size_t i = 0; i < members.size(); ++i)
    members[i] = is_in(region, !edge.empty() && edge[i] != 0);
  return difference(ours, theirs, members, tolerance);
}

}  // namespace litmus

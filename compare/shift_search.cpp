// shift_search.cpp: correlation of whole pixels, then Lucas and Kanade's steps.
#include "compare/shift_search.h"

#include <algorithm>
#include <cmath>

#include "compare/registration.h"
#include "compare/smooth_pieces.h"

namespace litmus {
namespace {

constexpr int kMostSteps = 30;

/// Where the pixels of a row, or of a column, of theirs lie on ours.
struct Place {
  int pixel;  ///< of theirs
  double from_middle;
  std::size_t nearest;  ///< of ours
  CubicPlace cubic;
};

std::vector<Place> places(int size, double scale, double shift, int stride) {
  const double middle = (size - 1) / 2.0;
  std::vector<Place> result;
  result.reserve(std::size_t(size / stride + 1));
  for (int pixel = 0; pixel < size; pixel += stride) {
    const double at = middle + scale * (pixel - middle) + shift;
    if (!(at >= 0 && at < size - 0.5)) continue;
    result.push_back({pixel, pixel - middle, std::size_t(std::lround(at)), cubic_place(at)});
  }
  return result;
}

std::vector<ShiftObservation> observe(const PicturePair& pair, const Warp& warp) {
  const Picture& ours = pair.ours;
  const std::vector<Place> columns = places(ours.width, warp.scale, warp.dx, pair.stride);
  const std::vector<Place> rows = places(ours.height, warp.scale, warp.dy, pair.stride);
  std::vector<ShiftObservation> result;
  result.reserve(columns.size() * rows.size());
  for (const Place& row : rows) {
    for (const Place& column : columns) {
      const glm::dvec3& other = pair.theirs.at(column.pixel, row.pixel);
      if (!pair.smooth[row.nearest * std::size_t(ours.width) + column.nearest] || !is_finite(other))
        continue;
      const PlacedSample own = sample_at(ours, column.cubic, row.cubic);
      ShiftObservation& seen = result.emplace_back();
      seen.pixel = std::size_t(row.pixel) * std::size_t(ours.width) + std::size_t(column.pixel);
      for (int c = 0; c < 3; ++c)
        seen.channels[std::size_t(c)] = {
            1,
            other[c],
            own.along_x[c],
            own.along_y[c],
            own.along_x[c] * column.from_middle + own.along_y[c] * row.from_middle,
            own.value[c] - other[c]};
    }
  }
  return result;
}

double grey(const glm::dvec3& v) { return (v.x + v.y + v.z) / 3; }

/// The correlation of theirs with ours moved by whole pixels, which no gain or offset changes.
double correlation(const PicturePair& pair, int dx, int dy) {
  const Picture &ours = pair.ours, &theirs = pair.theirs;
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int y = std::max(0, -dy); y < ours.height - std::max(0, dy); y += pair.stride)
    for (int x = std::max(0, -dx); x < ours.width - std::max(0, dx); x += pair.stride) {
      const double p = grey(ours.at(x + dx, y + dy)), q = grey(theirs.at(x, y));
      if (!std::isfinite(p) || !std::isfinite(q)) continue;
      n += 1, a += p, b += q, aa += p * p, bb += q * q, ab += p * q;
    }
  const double spread = (aa - a * a / n) * (bb - b * b / n);
  return spread > 0 ? (ab - a * b / n) / std::sqrt(spread) : 0;
}

Warp best_whole_pixel(const PicturePair& pair) {
  const int reach = std::min({kLargestSearch, pair.ours.width / 4, pair.ours.height / 4});
  Warp best;
  double largest = correlation(pair, 0, 0);
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      if (const double c = correlation(pair, dx, dy); c > largest + 1e-9) {
        largest = c;
        best.dx = dx, best.dy = dy;
      }
  return best;
}

}  // namespace

ShiftFit refine(const PicturePair& pair, const Warp& start, std::size_t count) {
  ShiftFit fit{start, {}, {}, false};
  for (int i = 0; i < kMostSteps; ++i) {
    fit.seen = observe(pair, fit.warp);
    if (fit.seen.size() < kFewestPixels) return fit;
    if (i == 0) fit.normal = shift_equations(fit.seen);
    reweigh(fit.seen, fit.normal, pair.noise);
    fit.normal = shift_equations(fit.seen);
    const auto change = shift_step(fit.normal, count);
    if (!change) return fit;
    const auto [x, y, scale] = *change;
    // Pixels that join or leave at a smooth piece's border may keep the steps from vanishing.
    fit.converged = std::hypot(x, y) < 1e-4 && std::fabs(scale) < 1e-5;
    if (std::hypot(x, y) < 1e-6 && std::fabs(scale) < 1e-8) return fit;
    const double shorten = std::min(1.0, 0.7 / std::max(std::hypot(x, y), 1e-30));
    fit.warp.dx += shorten * x, fit.warp.dy += shorten * y, fit.warp.scale += shorten * scale;
    const bool ran_away = std::hypot(fit.warp.dx - start.dx, fit.warp.dy - start.dy) > 3 ||
                          std::fabs(fit.warp.scale - 1) > 0.2;
    if (ran_away) break;
  }
  return fit;
}

ShiftFit best_fit(const PicturePair& pair) {
  ShiftFit here = refine(pair, {}, 2);
  const double good = 300 * std::max(pair.noise * pair.noise, kFloatNoise * kFloatNoise);
  if (here.converged && here.mean_error() <= good) return here;
  const Warp start = best_whole_pixel(pair);
  if (start.dx == 0 && start.dy == 0) return here;
  ShiftFit there = refine(pair, start, 2);
  if (!there.converged || (here.converged && here.mean_error() <= there.mean_error())) return here;
  return there;
}

double error_before(const PicturePair& pair, const ShiftFit& fit) {
  std::vector<ShiftObservation> seen = observe(pair, {});
  std::vector<double> weights(pair.theirs.pixels.size());
  for (const ShiftObservation& one : fit.seen) weights[one.pixel] = one.weight;
  for (ShiftObservation& one : seen) one.weight = weights[one.pixel];
  const ShiftEquations normal = shift_equations(seen);
  return normal.weight > 0 ? normal.error() / normal.weight : 0;
}

}  // namespace litmus

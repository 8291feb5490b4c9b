// smooth_pieces.cpp: cubics between pixels; edges and creases left out.
#include "compare/smooth_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace litmus {
namespace {

constexpr double kFlat = 1e-5;  // a third difference below it is no crease

/// Whether a crease passes between a pixel and its neighbours along (dx, dy).
bool is_creased(const Picture& picture, int x, int y, int dx, int dy) {
  const auto at = [&](int k) { return picture.at(x + k * dx, y + k * dy); };
  for (const int k : {-1, 0}) {
    const glm::dvec3 first = at(k + 1) - at(k);
    const glm::dvec3 third = at(k + 2) - 3.0 * at(k + 1) + 3.0 * at(k) - at(k - 1);
    if (glm::length(third) > std::max(glm::length(first), kFlat)) return true;
  }
  return false;
}

}  // namespace

CubicPlace cubic_place(double at) {
  const int before = int(std::floor(at));
  const double t = at - before, t2 = t * t, t3 = t2 * t;
  return {before - 1,
          {(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2,
           (t3 - t2) / 2},
          {(-3 * t2 + 4 * t - 1) / 2, (9 * t2 - 10 * t) / 2, (-9 * t2 + 8 * t + 1) / 2,
           (3 * t2 - 2 * t) / 2}};
}

PlacedSample sample_at(const Picture& picture, const CubicPlace& column, const CubicPlace& row) {
  // Down each of the four columns first, whose channels lie side by side.
  constexpr std::size_t kSide = 4, kNumbers = 3 * kSide;
  std::array<double, kNumbers> value{}, slope{};
  for (std::size_t j = 0; j < kSide; ++j) {
    const double* pixels = &picture.at(column.first, row.first + int(j)).x;
    for (std::size_t k = 0; k < kNumbers; ++k) {
      value[k] += row.value[j] * pixels[k];
      slope[k] += row.slope[j] * pixels[k];
    }
  }
  PlacedSample result;
  for (std::size_t i = 0; i < kSide; ++i)
    for (int c = 0; c < 3; ++c) {
      const std::size_t k = 3 * i + std::size_t(c);
      result.value[c] += column.value[i] * value[k];
      result.along_x[c] += column.slope[i] * value[k];
      result.along_y[c] += column.value[i] * slope[k];
    }
  return result;
}

std::vector<std::uint8_t> smooth_pixels(const Picture& picture,
                                        std::span<const std::uint8_t> edge) {
  std::vector<std::uint8_t> smooth(picture.pixels.size());
  const auto clear = [&](int x, int y, int radius, const auto& spoils) {
    for (int j = y - radius; j <= y + radius; ++j)
      for (int i = x - radius; i <= x + radius; ++i)
        if (spoils(std::size_t(j) * std::size_t(picture.width) + std::size_t(i))) return false;
    return true;
  };
  for (int y = 2; y + 2 < picture.height; ++y)
    for (int x = 2; x + 2 < picture.width; ++x)
      smooth[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] =
          clear(x, y, 1, [&](std::size_t i) { return !edge.empty() && edge[i] != 0; }) &&
          clear(x, y, 2, [&](std::size_t i) { return !is_finite(picture.pixels[i]); });
  return smooth;
}

std::vector<std::uint8_t> without_creases(const Picture& picture,
                                          std::vector<std::uint8_t> smooth) {
  for (int y = 2; y + 2 < picture.height; ++y)
    for (int x = 2; x + 2 < picture.width; ++x) {
      std::uint8_t& kept = smooth[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
      if (kept && (is_creased(picture, x, y, 1, 0) || is_creased(picture, x, y, 0, 1))) kept = 0;
    }
  return smooth;
}

}  // namespace litmus

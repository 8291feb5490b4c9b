// registration.cpp: a search over whole pixels, then Gauss-Newton steps with gain and offset
// eliminated.
#include "compare/registration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace litmus {
namespace {

constexpr std::size_t kFewestPixels = 64;
constexpr double kMostPixels = 300'000;  // of a larger picture, every second or third is used
constexpr int kMostSteps = 30;
constexpr double kLargestUncertainty = 0.004;  // pixels: a verdict at 0.02 is then five sigma
constexpr double kFloor = 1e-7;                // no renderer's picture is better than its floats
constexpr double kFlattest = 1e-5;  // weakest over strongest direction, squared gradients

/// Where ours lies on theirs: theirs(p) is ours(centre + scale (p - centre) + shift).
struct Warp {
  double dx = 0, dy = 0, scale = 1;
};

// ---- Sampling ours ---------------------------------------------------------------------------

/// The four weights of a Catmull-Rom cubic and of its derivative at t in [0, 1).
struct Cubic {
  std::array<double, 4> value, slope;
};

Cubic cubic(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {{(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2,
           (t3 - t2) / 2},
          {(-3 * t2 + 4 * t - 1) / 2, (9 * t2 - 10 * t) / 2, (-9 * t2 + 8 * t + 1) / 2,
           (3 * t2 - 2 * t) / 2}};
}

struct Sample {
  glm::dvec3 value{0}, along_x{0}, along_y{0};
};

/// All 16 pixels around (x, y) lie inside the picture.
Sample sample(const Picture& picture, double x, double y) {
  const int column = int(std::floor(x)), row = int(std::floor(y));
  const Cubic across = cubic(x - column), down = cubic(y - row);
  Sample result;
  for (int j = 0; j < 4; ++j) {
    glm::dvec3 value{0}, slope{0};
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3& pixel = picture.at(column - 1 + i, row - 1 + j);
      value += across.value[std::size_t(i)] * pixel;
      slope += across.slope[std::size_t(i)] * pixel;
    }
    result.value += down.value[std::size_t(j)] * value;
    result.along_x += down.value[std::size_t(j)] * slope;
    result.along_y += down.slope[std::size_t(j)] * value;
  }
  return result;
}

/// 1 where the 5 x 5 pixels around one are inside, finite and of one smooth piece: no edge among
/// the inner 3 x 3, each of which vouches for its own neighbours.
std::vector<std::uint8_t> smooth_pixels(const Picture& ours, std::span<const std::uint8_t> edge) {
  std::vector<std::uint8_t> smooth(ours.pixels.size());
  const auto clear = [&](int x, int y, int radius, const auto& spoils) {
    for (int j = y - radius; j <= y + radius; ++j)
      for (int i = x - radius; i <= x + radius; ++i)
        if (spoils(std::size_t(j) * std::size_t(ours.width) + std::size_t(i))) return false;
    return true;
  };
  for (int y = 2; y + 2 < ours.height; ++y)
    for (int x = 2; x + 2 < ours.width; ++x)
      smooth[std::size_t(y) * std::size_t(ours.width) + std::size_t(x)] =
          clear(x, y, 1, [&](std::size_t i) { return !edge.empty() && edge[i] != 0; }) &&
          clear(x, y, 2, [&](std::size_t i) { return !is_finite(ours.pixels[i]); });
  return smooth;
}

// ---- One step --------------------------------------------------------------------------------

/// The terms of one channel of one pixel: theirs, the derivatives of ours by dx, dy and scale, and
/// ours - theirs. A constant 1 comes before them.
constexpr std::size_t kTerms = 6, kFirst = 2;
using Terms = std::array<double, kTerms>;
using Matrix = std::array<Terms, kTerms>;

struct Observation {
  std::size_t pixel;  ///< index in theirs
  std::array<Terms, 3> channels;
  double weight = 1;
};

/// Everything about the pair of pictures that does not change from step to step.
struct Pair {
  const Picture& ours;
  const Picture& theirs;
  std::vector<std::uint8_t> smooth;
  int stride;
  double noise;
};

std::vector<Observation> observe(const Pair& pair, const Warp& warp) {
  const Picture& ours = pair.ours;
  const double middle_x = (ours.width - 1) / 2.0, middle_y = (ours.height - 1) / 2.0;
  std::vector<Observation> result;
  for (int y = 0; y < ours.height; y += pair.stride) {
    for (int x = 0; x < ours.width; x += pair.stride) {
      const double u = x - middle_x, v = y - middle_y;
      const double at_x = middle_x + warp.scale * u + warp.dx;
      const double at_y = middle_y + warp.scale * v + warp.dy;
      if (!(at_x >= 0 && at_x < ours.width - 0.5 && at_y >= 0 && at_y < ours.height - 0.5))
        continue;
      const auto nearest =
          std::size_t(std::lround(at_y)) * std::size_t(ours.width) + std::size_t(std::lround(at_x));
      const glm::dvec3& other = pair.theirs.at(x, y);
      if (!pair.smooth[nearest] || !is_finite(other)) continue;
      const Sample own = sample(ours, at_x, at_y);
      Observation& seen = result.emplace_back();
      seen.pixel = std::size_t(y) * std::size_t(ours.width) + std::size_t(x);
      for (int c = 0; c < 3; ++c)
        seen.channels[std::size_t(c)] = {1,
                                         other[c],
                                         own.along_x[c],
                                         own.along_y[c],
                                         own.along_x[c] * u + own.along_y[c] * v,
                                         own.value[c] - other[c]};
    }
  }
  return result;
}

/// Takes a term out of all others (Gauss and Jordan, on the symmetric matrix). One that is nothing
/// but those taken out before is skipped.
void eliminate(Matrix& m, std::size_t term, double original) {
  if (!(m[term][term] > 1e-12 * original)) {
    for (std::size_t i = 0; i < kTerms; ++i) m[i][term] = m[term][i] = 0;
    return;
  }
  const Terms pivot = m[term];
  for (std::size_t i = 0; i < kTerms; ++i) {
    if (i == term) continue;
    const double factor = m[i][term] / pivot[term];
    for (std::size_t j = 0; j < kTerms; ++j) m[i][j] -= factor * pivot[j];
  }
}

/// What the pixels say, gain and offset of each channel being whatever fits best.
struct Normal {
  Matrix m{};  ///< rows and columns from kFirst on: dx, dy, scale, ours - theirs
  std::array<std::array<double, 2>, 3> shading{};  ///< per channel: offset, gain - 1
  double weight = 0;                               ///< of all pixels
  double error() const { return std::max(0.0, m[kTerms - 1][kTerms - 1]); }
};

Normal normal_equations(std::span<const Observation> seen) {
  std::array<Matrix, 3> sums{};
  Normal result;
  for (const Observation& one : seen) {
    result.weight += one.weight;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < kTerms; ++i)
        for (std::size_t j = i; j < kTerms; ++j)
          sums[c][i][j] += one.weight * one.channels[c][i] * one.channels[c][j];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    Matrix& m = sums[c];
    for (std::size_t i = 0; i < kTerms; ++i)
      for (std::size_t j = 0; j < i; ++j) m[i][j] = m[j][i];
    const double squares = m[1][1];
    eliminate(m, 0, m[0][0]);
    eliminate(m, 1, squares);
    for (std::size_t i = 0; i < kFirst; ++i)
      result.shading[c][i] = m[i][i] > 0 ? m[i][kTerms - 1] / m[i][i] : 0;
    for (std::size_t i = kFirst; i < kTerms; ++i)
      for (std::size_t j = kFirst; j < kTerms; ++j) result.m[i][j] += m[i][j];
  }
  return result;
}

/// The step that the normal equations ask for, in the first `count` of dx, dy and scale; nothing
/// where they do not determine one.
std::optional<std::array<double, 3>> step(const Normal& normal, std::size_t count) {
  Matrix m = normal.m;
  std::array<double, 3> result{};
  for (std::size_t i = kFirst; i < kFirst + count; ++i) {
    if (!(m[i][i] > 1e-10 * normal.m[i][i])) return {};
    eliminate(m, i, 0);
  }
  for (std::size_t i = 0; i < count; ++i)
    result[i] = -m[kFirst + i][kTerms - 1] / m[kFirst + i][kFirst + i];
  return result;
}

/// Lessens the weight of pixels that gain, offset and warp leave far off, such as those on a crease
/// that no mask knows (Geman and McClure's weights). The scale is the median over the pixels that
/// say anything about a shift.
void reweigh(std::vector<Observation>& seen, const Normal& normal, double noise) {
  std::vector<double> errors, gradients, telling;
  double mean = 0;
  for (const Observation& one : seen) {
    double error = 0, gradient = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const Terms& t = one.channels[c];
      const double left = t[5] - normal.shading[c][0] - normal.shading[c][1] * t[1];
      error += left * left, gradient += t[2] * t[2] + t[3] * t[3];
    }
    errors.push_back(error), gradients.push_back(gradient);
    mean += gradient / double(seen.size());
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (gradients[i] >= mean / 2) telling.push_back(errors[i]);
  if (telling.empty()) return;
  const auto middle = telling.begin() + std::ptrdiff_t(telling.size() / 2);
  std::nth_element(telling.begin(), middle, telling.end());
  const double scale = std::max({36 * *middle, 27 * noise * noise, 300 * kFloor * kFloor});
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double root = 1 / (1 + errors[i] / scale);
    seen[i].weight = root * root;
  }
}

// ---- The search ------------------------------------------------------------------------------

double grey(const glm::dvec3& v) { return (v.x + v.y + v.z) / 3; }

/// The correlation of theirs with ours moved by whole pixels, which no gain or offset changes.
double correlation(const Pair& pair, int dx, int dy) {
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

Warp best_whole_pixel(const Pair& pair) {
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

struct Fit {
  Warp warp;
  Normal normal;
  std::vector<Observation> seen;
  bool converged = false;
  double mean_error() const { return normal.error() / normal.weight; }
};

Fit refine(const Pair& pair, const Warp& start, std::size_t count) {
  Fit fit{start, {}, {}, false};
  for (int i = 0; i < kMostSteps; ++i) {
    fit.seen = observe(pair, fit.warp);
    if (fit.seen.size() < kFewestPixels) return fit;
    if (i == 0) fit.normal = normal_equations(fit.seen);
    reweigh(fit.seen, fit.normal, pair.noise);
    fit.normal = normal_equations(fit.seen);
    const auto change = step(fit.normal, count);
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

/// From where the pictures are, and from the best whole pixel if that is another one.
Fit best_fit(const Pair& pair) {
  Fit here = refine(pair, {}, 2);
  const double good = 300 * std::max(pair.noise * pair.noise, kFloor * kFloor);
  if (here.converged && here.mean_error() <= good) return here;
  const Warp start = best_whole_pixel(pair);
  if (start.dx == 0 && start.dy == 0) return here;
  Fit there = refine(pair, start, 2);
  if (!there.converged || (here.converged && here.mean_error() <= there.mean_error())) return here;
  return there;
}

/// The mean squared difference of the fit's pixels as the pictures are, with the fit's weights.
double error_before(const Pair& pair, const Fit& fit) {
  std::vector<Observation> seen = observe(pair, {});
  std::vector<double> weights(pair.theirs.pixels.size());
  for (const Observation& one : fit.seen) weights[one.pixel] = one.weight;
  for (Observation& one : seen) one.weight = weights[one.pixel];
  const Normal normal = normal_equations(seen);
  return normal.weight > 0 ? normal.error() / normal.weight : 0;
}

/// The squared gradients in the weakest and the strongest direction.
std::array<double, 2> strengths(const Normal& normal) {
  const double xx = normal.m[kFirst][kFirst], yy = normal.m[kFirst + 1][kFirst + 1];
  const double xy = normal.m[kFirst][kFirst + 1];
  const double middle = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
  return {std::max(0.0, middle - apart), middle + apart};
}

/// The part of `before` that is gone, apart from what may be there anyway.
double gone(double before, double after, double allowed) {
  if (!(before > allowed)) return 0;
  return std::clamp(1 - std::max(0.0, after - allowed) / (before - allowed), 0.0, 1.0);
}

std::string short_pixels(double value) {
  const std::string text = fmt::format("{:.3g}", std::round(value * 1000) / 1000);
  return text == "-0" ? "0" : text;
}

}  // namespace

Registration registration(const Picture& ours, const Picture& theirs,
                          std::span<const std::uint8_t> edge, double noise) {
  Registration result;
  const auto undetermined = [&](std::string why) {
    result.why = std::move(why);
    return result;
  };
  if (ours.width != theirs.width || ours.height != theirs.height)
    return undetermined("the pictures differ in size");
  const double pixels = double(ours.pixels.size());
  const int stride = std::max(1, int(std::ceil(std::sqrt(pixels / kMostPixels))));
  const Pair pair{ours, theirs, smooth_pixels(ours, edge), stride, noise};
  const Fit fit = best_fit(pair);
  result.pixels = std::int64_t(fit.seen.size());
  if (fit.seen.size() < kFewestPixels)
    return undetermined(fmt::format("only {} pixels are smooth and finite", fit.seen.size()));

  // Does the picture vary enough, both ways?
  const auto [weakest, strongest] = strengths(fit.normal);
  const double allowed = 3 * std::max(noise * noise, kFloor * kFloor);
  if (!(strongest > allowed * fit.normal.weight))
    return undetermined("nothing changes along the picture but what a gain or an offset changes");
  if (weakest < kFlattest * strongest)
    return undetermined("the picture changes in one direction only");
  if (!fit.converged) return undetermined("no shift brings the pictures together");
  result.uncertainty = std::sqrt(std::max(fit.mean_error(), allowed) / 3 / weakest);
  if (result.uncertainty > kLargestUncertainty)
    return undetermined("the picture changes too little to tell a shift");
  result.determined = true;
  result.dx = fit.warp.dx, result.dy = fit.warp.dy;
  result.explained = gone(error_before(pair, fit), fit.mean_error(), allowed);
  const Fit zoomed = refine(pair, fit.warp, 3);
  if (zoomed.converged) result.scale = zoomed.warp.scale;
  return result;
}

double explained_by_moving(const Picture& ours, const Picture& moved, const Picture& theirs,
                           std::span<const std::uint8_t> where, double noise) {
  const auto error = [&](const Picture& mine) {
    std::vector<Observation> seen;
    for (std::size_t i = 0; i < theirs.pixels.size(); ++i) {
      if (where[i] == 0 || !is_finite(ours.pixels[i]) || !is_finite(moved.pixels[i]) ||
          !is_finite(theirs.pixels[i]))
        continue;
      Observation& one = seen.emplace_back();
      for (int c = 0; c < 3; ++c)
        one.channels[std::size_t(c)] = {
            1, theirs.pixels[i][c], 0, 0, 0, mine.pixels[i][c] - theirs.pixels[i][c]};
    }
    const Normal normal = normal_equations(seen);
    return seen.empty() ? 0 : normal.error() / double(seen.size());
  };
  return gone(error(ours), error(moved), 3 * std::max(noise * noise, kFloor * kFloor));
}

std::string unregistered(const Registration& r) {
  if (!r.determined || r.explained < kExplainedByShift) return "";
  if (!(std::hypot(r.dx, r.dy) > kLargestShift)) return "";
  return fmt::format(
      "unregistered: shifted by ({}, {}) px, which explains {:.1f} % of the difference; compare "
      "the cameras before the shading",
      short_pixels(r.dx), short_pixels(r.dy), std::floor(1000 * r.explained) / 10);
}

}  // namespace litmus

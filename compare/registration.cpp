// registration.cpp: whether a shift that was found is to be believed, and what it explains.
#include "compare/registration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/shift_search.h"
#include "compare/smooth_pieces.h"

namespace litmus {
namespace {

constexpr double kMostPixels = 300'000;        // of a larger picture, every second or third is used
constexpr double kLargestUncertainty = 0.004;  // pixels: a verdict at 0.02 is then five sigma
constexpr double kFlattest = 1e-5;  // weakest over strongest direction, squared gradients

/// The part of `before` that is gone, apart from what may be there anyway.
double gone(double before, double after, double allowed) {
  if (!(before > allowed)) return 0;
  return std::clamp(1 - std::max(0.0, after - allowed) / (before - allowed), 0.0, 1.0);
}

std::string short_pixels(double value) {
  const std::string text = fmt::format("{:.3g}", std::round(value * 1000) / 1000);
  return text == "-0" ? "0" : text;
}

/// Why the pixels of a fit do not tell a shift; empty where they do.
std::string undetermined(const ShiftFit& fit, double allowed) {
  if (fit.seen.size() < kFewestPixels)
    return fmt::format("only {} pixels are smooth and finite", fit.seen.size());
  // Does the picture vary enough, both ways?
  const auto [weakest, strongest] = gradient_strengths(fit.normal);
  if (!(strongest > allowed * fit.normal.weight))
    return "nothing changes along the picture but what a gain or an offset changes";
  if (weakest < kFlattest * strongest) return "the picture changes in one direction only";
  return fit.converged ? "" : "no shift brings the pictures together";
}

/// The error of a fit that is there anyway.
double allowed_error(const PicturePair& pair) {
  return 3 * std::max(pair.noise * pair.noise, kFloatNoise * kFloatNoise);
}

/// The shift of a fit, and whether it is to be believed.
Registration shift_of(const PicturePair& pair, const ShiftFit& fit) {
  Registration result;
  const double allowed = allowed_error(pair);
  result.pixels = std::int64_t(fit.seen.size());
  result.why = undetermined(fit, allowed);
  if (!result.why.empty()) return result;
  const double weakest = gradient_strengths(fit.normal)[0];
  result.uncertainty = std::sqrt(std::max(fit.mean_error(), allowed) / 3 / weakest);
  if (result.uncertainty > kLargestUncertainty) {
    result.why = "the picture changes too little to tell a shift";
    return result;
  }
  result.determined = true;
  result.dx = fit.warp.dx, result.dy = fit.warp.dy;
  return result;
}

Registration estimate(const PicturePair& pair) {
  const ShiftFit fit = best_fit(pair);
  Registration result = shift_of(pair, fit);
  if (!result.determined) return result;
  result.explained = gone(error_before(pair, fit), fit.mean_error(), allowed_error(pair));
  const ShiftFit zoomed = refine(pair, fit.warp, 3);
  if (zoomed.converged) result.scale = zoomed.warp.scale;
  return result;
}

}  // namespace

Registration registration(const Picture& ours, const Picture& theirs,
                          std::span<const std::uint8_t> edge, double noise) {
  Registration unclear;
  if (ours.width != theirs.width || ours.height != theirs.height) {
    unclear.why = "the pictures differ in size";
    return unclear;
  }
  const double pixels = double(ours.pixels.size());
  const int stride = std::max(1, int(std::ceil(std::sqrt(pixels / kMostPixels))));
  PicturePair pair{ours, theirs, smooth_pixels(ours, edge), stride, noise};
  const Registration found = estimate(pair);
  if (!found.determined || std::hypot(found.dx, found.dy) > kLargestShift) return found;
  // Between flat pieces a pixel flips or stays: what stayed looks aligned whatever the shift.
  pair.smooth = without_creases(ours, std::move(pair.smooth));
  if (shift_of(pair, refine(pair, {found.dx, found.dy}, 2)).determined) return found;
  unclear.pixels = found.pixels;
  unclear.why = "what changes along the picture are creases between flat pieces, which do not tell";
  return unclear;
}

double explained_by_moving(const Picture& ours, const Picture& moved, const Picture& theirs,
                           std::span<const std::uint8_t> where, double noise) {
  const auto error = [&](const Picture& mine) {
    std::vector<ShiftObservation> seen;
    for (std::size_t i = 0; i < theirs.pixels.size(); ++i) {
      if (where[i] == 0 || !is_finite(ours.pixels[i]) || !is_finite(moved.pixels[i]) ||
          !is_finite(theirs.pixels[i]))
        continue;
      ShiftObservation& one = seen.emplace_back();
      for (int c = 0; c < 3; ++c)
        one.channels[std::size_t(c)] = {
            1, theirs.pixels[i][c], 0, 0, 0, mine.pixels[i][c] - theirs.pixels[i][c]};
    }
    const ShiftEquations normal = shift_equations(seen);
    return seen.empty() ? 0 : normal.error() / double(seen.size());
  };
  return gone(error(ours), error(moved), 3 * std::max(noise * noise, kFloatNoise * kFloatNoise));
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

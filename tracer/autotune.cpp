// autotune.cpp: doubling until the picture stands still, then looking for something cheaper.
#include "tracer/autotune.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tracer/area_sampling.h"
#include "tracer/cpu_clock.h"
#include "tracer/pixel_lattice.h"

namespace litmus {
namespace {

constexpr int kMostAreaSamples = 512, kMostGrid = 64, kMostPixelSamples = 256;
// Below the first number of samples that keeps the error: down to this share of it, in so many
// steps, unless one of them costs that many times what is known.
constexpr double kNearby = 0.7;
constexpr int kNearbyTries = 6;
constexpr double kNearbyPrice = 1.5;
constexpr double kLatticePrice = kLatticeGrids * (1 / 4. + 1 / 16.);  // of the finest picture
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Of the error allowed: what a judge may be off by itself. The errors of pixels fall slowly, so
// that of two numbers of samples close to each other only a sharp judge lets the smaller pass.
constexpr double kJudges = 0.1, kPixelJudges = 0.05;
constexpr double kWorthRepeating = 0.2;  // seconds: shorter times are taken three times
// Rounding of double precision on any scene that the loader accepts is far below this.
constexpr double kRounding = 1e-9;

/// Which numbers of samples a sampler knows between two powers of two.
enum class Between { All, Middle };

struct Measured {
  Rendering rendering;
  double seconds;
};

/// A picture that is exact enough to judge others, and what is left of its own error.
struct Judge {
  Picture picture;
  double own_error = kInfinity;
};

struct Tuner {
  const Scene& scene;
  const TuneOptions& options;
  Tuned result{};

  Measured measure(const TuneSettings& settings) const {
    double least = kInfinity;
    Measured measured;
    for (int repeat = 0; repeat < 3 && (repeat == 0 || least < kWorthRepeating); ++repeat) {
      const double start = cpu_seconds();
      measured.rendering = render(scene, settings, options.threads, true);
      least = std::min(least, cpu_seconds() - start);
    }
    measured.seconds = least;
    return measured;
  }

  double apart(const Picture& a, const Picture& b) const {
    return error_of(pixel_errors(a, b), options.metric);
  }

  /// Notes what was tried, and keeps it if it is the cheapest so far that keeps the error.
  bool offer(const TuneSettings& settings, double error, Measured measured) {
    result.tried.push_back({settings, error, measured.seconds});
    const bool keeps = error <= options.max_error;
    const bool better = keeps ? !result.met || measured.seconds < result.seconds
                              : !result.met && (result.tried.size() == 1 || error < result.error);
    if (better) {
      result.met = keeps;
      result.settings = settings, result.error = error, result.seconds = measured.seconds;
      result.rendering = std::move(measured.rendering);
    }
    return keeps;
  }

  /// Tries with(1), with(2), with(4), ... as far as they are cheaper than what is known; then those
  /// between the last that fails and the first that keeps the error, all of them or the middle one.
  /// The error of a grid does not fall at every step: a few with fewer samples are tried as well.
  template <class With>
  void climb(const Judge& judge, int most, Between between, With with) {
    bool cheaper = true;
    double price = 0;
    const auto keeps = [&](int n) {
      Measured one = measure(with(n));
      cheaper = !result.met || one.seconds < result.seconds;
      price = one.seconds;
      const double error = apart(one.rendering.whole, judge.picture) + judge.own_error;
      return offer(with(n), error, std::move(one));
    };
    int fails = 0, holds = 0;
    for (int n = 1; n <= most && cheaper && holds == 0; n *= 2) (keeps(n) ? holds : fails) = n;
    if (holds == 0) return;
    while (holds - fails > 1) {
      const int middle = (holds + fails) / 2;
      (keeps(middle) ? holds : fails) = middle;
      if (between == Between::Middle) return;
    }
    const int step = std::max(1, int(std::lround((1 - kNearby) * holds / kNearbyTries)));
    for (int n = fails - step; n >= std::max(1.0, kNearby * holds); n -= step) {
      keeps(n);
      if (price > kNearbyPrice * result.seconds) break;
    }
  }
};

/// Takes a lattice for the judge if less of its own error is left.
void sharpen(const Tuner& tuner, Judge& judge) {
  const int threads = tuner.options.threads;
  const Picture half = lattice_mean(tuner.scene, kMostPixelSamples / 4, threads);
  Picture mean = lattice_mean(tuner.scene, kMostPixelSamples / 2, threads);
  const double left = tuner.apart(half, mean) + kRounding;
  if (left < judge.own_error) judge = {std::move(mean), left};
}

/// Doubles whichever number of samples changes the picture more, until neither changes it by much
/// of what is allowed. Offers each setting before its doubling.
Judge find_judge(Tuner& tuner, bool area, bool pixels) {
  const double wanted = (pixels ? kPixelJudges : kJudges) * tuner.options.max_error;
  TuneSettings now{area ? Sampler::Certified : Sampler::Scene, area ? 1 : 0, 1, Precision::Double};
  Measured measured = tuner.measure(now);
  double own = kInfinity;
  while (measured.seconds < tuner.options.time_limit / 4) {
    TuneSettings more_area = now, more_pixels = now;
    more_area.area_samples *= 2, more_pixels.pixel_samples *= 2;
    std::optional<Measured> by_area, by_pixels;
    double area_change = 0, pixel_change = 0;
    if (area && now.area_samples < kMostAreaSamples) {
      by_area = tuner.measure(more_area);
      area_change = tuner.apart(by_area->rendering.whole, measured.rendering.whole);
    }
    if (pixels && now.pixel_samples < kMostPixelSamples) {
      by_pixels = tuner.measure(more_pixels);
      pixel_change = tuner.apart(by_pixels->rendering.whole, measured.rendering.whole);
    }
    if (!by_area && !by_pixels) break;
    own = 0.5 * area_change + pixel_change + kRounding;
    tuner.offer(now, area_change + pixel_change + own, std::move(measured));

    // Go on with the finer picture. Without the other doubling it is not as good as `own` says.
    const bool to_area = by_area && (!by_pixels || area_change >= pixel_change);
    now = to_area ? more_area : more_pixels;
    measured = std::move(to_area ? *by_area : *by_pixels);
    if (by_area && by_pixels) own += to_area ? pixel_change : area_change;
    if (own <= wanted) break;
  }
  Judge judge{std::move(measured.rendering.whole), own};
  const bool too_coarse = own > wanted && now.pixel_samples == kMostPixelSamples;
  if (too_coarse && !area && kLatticePrice * measured.seconds < tuner.options.time_limit)
    sharpen(tuner, judge);
  return judge;
}

/// Every sampler of area lights, with as many samples a pixel as the cheapest known has.
void climb_samplers(Tuner& tuner, const Judge& judge) {
  const int pixel_samples = tuner.result.settings.pixel_samples;
  const auto climb = [&](Sampler sampler, Precision precision) {
    // The certified sampler knows 2^k and 3 * 2^k only.
    const bool certified = sampler == Sampler::Certified;
    tuner.climb(judge, certified ? kMostAreaSamples : kMostGrid,
                certified ? Between::Middle : Between::All, [&](int n) {
                  return TuneSettings{sampler, n, pixel_samples, precision};
                });
  };
  climb(Sampler::Certified, Precision::Double);
  climb(Sampler::Gauss, Precision::Double);
  // A grid that costs too much in double may be the cheapest in float, so both are climbed.
  climb(Sampler::Centres, Precision::Double);
  climb(Sampler::Centres, Precision::Float);
}

}  // namespace

std::string words(const TuneSettings& s) {
  std::string text;
  if (s.sampler != Sampler::Scene)
    text = fmt::format("{} n = {}, ", sampler_name(s.sampler), s.area_samples);
  if (s.pixel_samples > 1) text += fmt::format("{0} x {0} samples a pixel, ", s.pixel_samples);
  return text + std::string(precision_name(s.precision));
}

Rendering render(const Scene& scene, const TuneSettings& settings, int threads, bool picture_only) {
  Scene changed = scene;
  changed.samples = settings.pixel_samples;
  return render(changed, {.precision = settings.precision,
                          .threads = threads,
                          .sampler = settings.sampler,
                          .area_samples = settings.area_samples,
                          .layers = !picture_only,
                          .edges = !picture_only});
}

Tuned tune(const Scene& scene, const TuneOptions& options) {
  Tuner tuner{scene, options};
  const bool area = integrates_area_lights(scene);
  const bool pixels = scene.samples > 1;
  if (!area && !pixels) {
    // Exact but for rounding: the only question is whether float will do.
    const TuneSettings exact{}, coarse{.precision = Precision::Float};
    Measured judge = tuner.measure(exact), in_float = tuner.measure(coarse);
    const double error = tuner.apart(in_float.rendering.whole, judge.rendering.whole) + kRounding;
    tuner.offer(exact, kRounding, std::move(judge));
    tuner.offer(coarse, error, std::move(in_float));
    return std::move(tuner.result);
  }
  const Judge judge = find_judge(tuner, area, pixels);
  if (!(judge.own_error < options.max_error)) return std::move(tuner.result);

  // What is known keeps the error with one number of samples a pixel; fewer may do.
  const TuneSettings known = tuner.result.settings;
  if (pixels) {
    tuner.climb(judge, known.pixel_samples, Between::All, [&](int n) {
      TuneSettings one = known;
      one.pixel_samples = n;
      return one;
    });
  }
  if (area) {
    climb_samplers(tuner, judge);
  } else {
    TuneSettings in_float = tuner.result.settings;
    in_float.precision = Precision::Float;
    Measured one = tuner.measure(in_float);
    const double error = tuner.apart(one.rendering.whole, judge.picture) + judge.own_error;
    tuner.offer(in_float, error, std::move(one));
  }
  return std::move(tuner.result);
}

}  // namespace litmus

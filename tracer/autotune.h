// autotune.h: the cheapest settings that keep an error.
#pragma once

#include <string>
#include <vector>

#include "tracer/error_metric.h"
#include "tracer/render.h"

namespace litmus {

/// What the tuner may turn.
struct TuneSettings {
  Sampler sampler = Sampler::Scene;  ///< Scene: there is no area light to sample
  int area_samples = 0;              ///< along each side of every area light
  int pixel_samples = 1;             ///< along each side of a pixel
  Precision precision = Precision::Double;
};

/// "certified n = 8, 2 x 2 samples a pixel, double".
std::string words(const TuneSettings& settings);

/// `picture_only`: without layers, signatures and flags, as cheap as it gets.
Rendering render(const Scene& scene, const TuneSettings& settings, int threads,
                 bool picture_only = false);

/// One setting that was measured.
struct Tried {
  TuneSettings settings;
  double error = 0;    ///< upper estimate, see tune()
  double seconds = 0;  ///< processor time of the picture, the least of up to 3
};

struct Tuned {
  bool met = false;          ///< whether the error is kept
  TuneSettings settings;     ///< the cheapest that keeps it; the most exact one tried if none does
  double error = 0;          ///< what is promised: an upper estimate of its error
  double seconds = 0;        ///< of its picture, processor time
  Rendering rendering;       ///< its picture
  std::vector<Tried> tried;  ///< in the order of trying
};

struct TuneOptions {
  double max_error = 1e-2;  ///< absolute, linear RGB
  ErrorMetric metric = ErrorMetric::Max;
  int threads = 0;
  /// Seconds of processor time for one picture (or lattice); past it nothing is doubled.
  double time_limit = 300;
};

/// Finds the cheapest settings whose picture keeps options.max_error.
///
/// The error is that against the picture that the scene stands for: area lights as whole
/// rectangles, the limit of slide 20's grid, not as the scene's number of samples; pixels as means
/// over their whole area where the scene has samples > 1, else their centres; exact arithmetic. So
/// a scene without an area light and with samples = 1 has the precision alone to choose.
///
/// The certified sampler's n and the samples of a pixel are doubled, one at a time, until the next
/// doubling changes the picture by a small part of the error allowed: that finer picture is the
/// judge. Its own error is at most half of that change where errors fall by a factor of 3 or more
/// at each doubling of n (measured: 3 to 4), and at most the change itself for pixel samples
/// (factor 2 or more); it is counted into every estimate. Where 256 samples along a pixel do not
/// get there and no area light is sampled as well, the judge is a lattice (pixel_lattice.h). Then
/// cheaper settings are tried against the judge: the samplers on a grid, all numbers of samples in
/// between, and float. Of those that keep the error the one that takes the least processor time
/// wins.
Tuned tune(const Scene& scene, const TuneOptions& options);

}  // namespace litmus

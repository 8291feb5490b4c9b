// flip.h: FLIP, how visible a difference is to somebody who flips between two pictures.
//
// For triage only, never a gate: it says what a person would notice, not what is right.
//
// Sources: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images" (2020), called [L]; Andersson, Nilsson, Shirley,
// Akenine-Moller, "Visualizing Errors in Rendered High Dynamic Range Images" (2021), called [H].
#pragma once

#include "scene/picture.h"

namespace litmus {

/// The observer's resolution in [L]: 0.7 m from a screen 0.7 m wide with 3840 pixels.
inline constexpr double kPixelsPerDegree = 67;

/// LDR-FLIP: the mean over the pixels of [L]'s error, from 0 (no visible difference) to 1. Values
/// are linear RGB as they would be shown, clipped to [0, 1]. A pixel that is not finite in either
/// picture is black in both (Difference counts it). 0 for pictures without pixels. Throws
/// SizeMismatch.
double ldr_flip(const Picture& ours, const Picture& theirs,
                double pixels_per_degree = kPixelsPerDegree);

/// The exposures at which two pictures are looked at: `count` of them, evenly from start to stop,
/// in stops (powers of two).
struct Exposures {
  double start = 0, stop = 0;
  int count = 2;
};

/// [H]'s choice: from where the brightest pixel's luminance is tone mapped to 0.85 to where the
/// median pixel's is, one exposure a stop and at least 2. Where the median is 0, as in most
/// pictures of a light's cone, [H] would need infinitely many: then the median is taken over the
/// pixels that are not black. At most kMaximumStops stops, from the start. A black picture is
/// looked at as it is (0 to 0). `theirs` is the reference of [H].
Exposures exposures_for(const Picture& theirs);
inline constexpr double kMaximumStops = 16;

/// HDR-FLIP: the mean over the pixels of the largest LDR-FLIP error among the exposures of
/// `exposures_for(theirs)`, tone mapped by [H]'s ACES curve. Otherwise as ldr_flip; negative values
/// count as 0.
double hdr_flip(const Picture& ours, const Picture& theirs,
                double pixels_per_degree = kPixelsPerDegree);

}  // namespace litmus

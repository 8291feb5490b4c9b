// triage.h: three figures that say how visible a difference is, to look at the worst first.
#pragma once

#include "scene/picture.h"

namespace litmus {

/// Never a gate: each of them is nearly blind to some errors (popular_gates_test.cpp).
struct Triage {
  double ldr_flip = 0;  ///< 0 no visible difference .. 1; flip.h
  double hdr_flip = 0;  ///< the same at the worst exposure; flip.h
  double ssim = 1;      ///< 1 the same structure .. -1; ssim.h
};

/// `theirs` is the reference, which gives HDR-FLIP its exposures. Throws SizeMismatch.
Triage triage(const Picture& ours, const Picture& theirs);

}  // namespace litmus

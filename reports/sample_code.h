// sample_code.h: the two readings of slide 5, its equation and its sample code, side by side.
#pragma once

#include <vector>

#include "reports/gallery.h"

namespace litmus {

/// Equation, sample code and |code - equation|, three panels a row: first one scene with every type
/// of light as a whole, then each light of it by itself, then the canonical scenes made for what
/// the two disagree about. Each caption gives the largest difference; what it says of the reasons
/// is in tests/reports/sample_code_test.cpp. Throws Refusal if a scene cannot be read.
std::vector<GalleryFigure> sample_code_figures(int threads = 0);

}  // namespace litmus

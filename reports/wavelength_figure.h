// wavelength_figure.h: what light per wavelength (slides 2-5) changes against red, green and blue.
#pragma once

#include "reports/gallery.h"

namespace litmus {

/// The chart of canonical scene w2 under D65 and under A: per wavelength, as a product of RGB
/// colours, and |product - per wavelength| with its largest value. Throws Refusal if the scene
/// cannot be read.
GalleryFigure wavelength_figure(int threads = 0);

}  // namespace litmus

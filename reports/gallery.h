// gallery.h: the seminar's figures, drawn by the tracer's formulas and rendered by the tracer.
#pragma once

#include <string>
#include <vector>

#include "reports/study.h"

namespace litmus {

/// A picture of a figure: either a PNG as a data URI, or a drawing as SVG.
struct GalleryPanel {
  std::string label, uri, svg;
};

struct GalleryFigure {
  std::string slides;  ///< "slide 12"
  std::string title, caption;
  std::vector<GalleryPanel> panels;
};

/// Whether the study covers every canonical scene that can be loaded here: then its report has the
/// gallery.
bool is_full_run(const Study& study);

/// The figures of slides 2-5 (wavelength), 7, 9, 12, 13, 14, 17, 18 and 20, made from the canonical
/// scenes w2 and x1-x4 (slide 5's equation and sample code: sample_code.h; with `threads` as in
/// RenderOptions). Without the data that w2 needs, without the first of them. Throws Refusal if one
/// of them cannot be read.
std::vector<GalleryFigure> gallery(int threads = 0);

}  // namespace litmus

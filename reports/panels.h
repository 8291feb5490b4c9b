// panels.h: what the figures of the report are put together from.
#pragma once

#include <string>

#include "reports/gallery.h"
#include "tracer/render.h"

namespace litmus {

inline constexpr int kPanelWidth = 160;  ///< of a figure's picture, pixels

/// A canonical scene by its name or id at a panel's width, 2 x 2 samples a pixel.
Scene panel_scene(const std::string& name);

Rendering rendered(const Scene& scene, int threads);

/// A picture with its label.
GalleryPanel panel(const std::string& label, const Picture& picture);

/// |a - b| per channel, of pictures of one size.
Picture apart(const Picture& a, const Picture& b);

/// The largest channel of all pixels; 0 for a picture that is black.
double brightest(const Picture& picture);

}  // namespace litmus

// render_terms.h: the terms of the equation as pictures.
#pragma once

#include "compare/image_io.h"
#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

/// ka, kd and ks of the material seen, then each light's terms, at the pixels' centres.
Layers term_layers(const Scene& scene);

/// The colours that turn the layers into the picture again, and how.
Metadata term_metadata(const Scene& scene);

}  // namespace litmus

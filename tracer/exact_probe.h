// exact_probe.h: single pixels in quad precision, to say who is right where two renderers differ.
#pragma once

#include "tracer/render.h"

namespace litmus {

/// What probe() shows, computed in quad precision and rounded once. A hundred times slower.
Probe exact_probe(const Scene& scene);

}  // namespace litmus

// envelope.h: moves a scene to where the reference renderers are accurate: near the origin, about
// 10 units in size. POV-Ray's tolerances are absolute (1e-3 for shadows, nothing beyond 1e7) and
// Cycles keeps its world in single precision. The picture does not change: attenuation depends on
// d/Range.
#pragma once

#include "scene/scene.h"

namespace litmus {

/// The map p -> (p - centre) * scale. `scale` is a power of two.
struct Envelope {
  Point centre{0};
  double scale = 1;
  bool identity() const { return scale == 1 && centre == Point(0); }
};

/// Whether the scene has the tag "unmoved" (scene/README.md): it shows where a renderer's own
/// limits are, so that it is exported where it stands and in its own unit.
bool stays_unmoved(const Scene& scene);

/// What into_envelope() does to a scene. Its extent is the box around the bounded objects and the
/// points where the camera's middle and corner rays meet planes, grown by the eye and the
/// positional lights as far as they lie within 16 radii (a farther one needs no precision of its
/// own). The identity where the extent has a radius of 0.5 to 200 and holds the origin within 2
/// radii: such a scene is exported in the numbers of its author. Otherwise the extent's centre goes
/// to the origin and its radius to 8..16.
Envelope envelope_of(const Scene& scene);

/// Half the diagonal of that extent; 0 for a scene without any.
double extent_radius(const Scene& scene);

/// A copy of the scene, moved and scaled with every length in it (ranges, sizes, the orthographic
/// height). An area light without a normal gets it first: from the light to the origin (slide 20).
/// Throws Refusal if such a light stands on the origin.
Scene into_envelope(const Scene& scene);

}  // namespace litmus

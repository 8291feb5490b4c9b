// alignment.h: whether a reference looks at the scene from where we do, made sure of by rendering
// again.
#pragma once

#include <span>

#include "compare/registration.h"
#include "reports/study.h"
#include "tracer/render.h"

namespace litmus {

/// The registration of a case's whole picture against a reference's. Where the shift found is over
/// kLargestShift, `scene` is rendered once more with its sample points moved by it (on top of
/// `options`), and `explained` is what that takes away from the squared difference, over the whole
/// picture and over the outlines of objects, the smaller of the two. Lamps that are off move
/// brightness and shadows, but no outline: a picture without outlines (a floor seen from above)
/// leaves a shift undetermined, and `why` says by how much.
///
/// `entry` has the layers that `scene` and `options` give, ambient first and the whole last;
/// `noise` as in `registration`.
Registration align(const Scene& scene, const RenderOptions& options, const Case& entry,
                   const Picture& theirs, double noise = 0);

/// Rows of one scene and reference that is unregistered: those that fail say so instead of blaming
/// the shading (unless a pixel is not finite), and the row of the whole picture fails.
void blame_the_camera(std::span<Comparison> rows, const Registration& registration);

}  // namespace litmus

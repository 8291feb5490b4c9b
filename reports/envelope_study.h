// envelope_study.h: one scene at many scales and places, by every renderer: where each stops
// showing the same picture.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "reference/drivers.h"

namespace litmus {

/// One renderer's picture of the moved scene against its own of the scene at the origin.
struct EnvelopePoint {
  std::string axis;      ///< "scale" or "offset"
  double value = 1;      ///< all lengths times this, or moved by this along (1, 1/2, 1/4), units
  std::string renderer;  ///< "litmus double", "litmus float", "POV-Ray", "Blender Cycles"
  double differing = 0;  ///< percent of the pixels that are off by more than 1/255 of white
  std::string failure;   ///< why there is no picture; then differing is 100
};

/// Scales 1e-6 to 1e6 and offsets 1e2 to 1e8, a decade each. The exporters do not move the scene
/// into the renderers' envelopes here (tag "unmoved", envelope.h). A renderer that is not installed
/// has points that say so. `progress` of the options names each renderer as it starts.
std::vector<EnvelopePoint> run_envelope_study(const ReferenceOptions& options,
                                              std::span<const Driver> drivers = drivers());

/// For people, a line per renderer and reason: "POV-Ray, scale 1e-06: it refused the scene".
std::vector<std::string> envelope_failures(const std::vector<EnvelopePoint>& points);

}  // namespace litmus

// cost_references.h: POV-Ray and Cycles on the axes of a cost study.
#pragma once

#include "reports/cost_measure.h"

namespace litmus {

/// Adds POV-Ray's grids of lamps (exact export), its area_light (native), Cycles' grids of lamps
/// and its AREA light (native) by samples a pixel. What is not installed or fails is noted in
/// study.missing.
void add_area_references(const Scene& scene, const CostTruth& truth, const CostOptions& options,
                         CostTopic& topic, CostStudy& study);

/// Adds the exact exports with n x n samples a pixel, and POV-Ray's own antialiasing.
void add_pixel_references(const Scene& scene, const CostTruth& truth, const CostOptions& options,
                          CostTopic& topic, CostStudy& study);

}  // namespace litmus

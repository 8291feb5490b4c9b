// rows.h: one layer against one reference, as rows with verdicts.
#pragma once

#include <string>
#include <vector>

#include "compare/difference.h"
#include "compare/tolerances.h"
#include "reports/study.h"
#include "tracer/render.h"

namespace litmus {

/// The figures of a difference as a row without a verdict.
Comparison row_of(const Difference& difference, std::string_view region,
                  const Tolerance& tolerance);

/// The rows of a layer, in order: interior, then of a light the regions of kLightRegions that have
/// pixels, edge, all. Each is judged by itself, by the tolerances of `reference`; "all" passes
/// where the others do. Edge pixels over the tolerance are explained by `probe`, in which the layer
/// has the index `layer_index`. Where a row fails, a `hint` says which factor or encoding would
/// explain the layer's difference (fit.h). Scene, reference, source and light are left to the
/// caller.
std::vector<Comparison> compare_layer(const CaseLayer& layer, std::size_t layer_index,
                                      const Picture& theirs, const std::string& reference,
                                      const Probe& probe);

}  // namespace litmus

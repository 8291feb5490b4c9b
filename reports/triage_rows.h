// triage_rows.h: how visible the differences of a study's failures are.
#pragma once

#include "reports/study.h"

namespace litmus {

/// Sets `triage` of the failing rows of whole pictures (light and region "all"). Where all is well
/// the figures say nothing, and they take longer than everything else that is done with a picture.
void add_triage(Study& study);

}  // namespace litmus

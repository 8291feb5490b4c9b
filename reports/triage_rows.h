// triage_rows.h: how visible the differences of a study's failures are.
#pragma once

#include "reports/study.h"

namespace litmus {

/// Sets `triage` of the failing rows of whole pictures (light and region "all"). Where all is well
/// the figures say nothing, and for all canonical scenes and both references they take 2 s.
void add_triage(Study& study);

}  // namespace litmus

// provenance.h: what a report was made with.
#pragma once

#include <span>

#include "reference/drivers.h"
#include "reports/study.h"

namespace litmus {

/// The program, the compiler, the machine, and the renderers among `drivers` that are installed.
/// `command`, `started` and `seconds` are the caller's to fill in.
Provenance provenance_of(std::span<const Driver* const> drivers);

}  // namespace litmus

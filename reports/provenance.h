// provenance.h: what a report was made with.
#pragma once

#include <span>

#include "reference/drivers.h"
#include "reports/study.h"

namespace litmus {

/// The program, the compiler, the machine, and the versions of the renderers among `drivers`. To
/// ask them takes as long as loading them; if they are not `asked`, their versions say so.
/// `command`, `started` and `seconds` are the caller's to fill in.
Provenance provenance_of(std::span<const Driver* const> drivers, bool asked = true);

}  // namespace litmus

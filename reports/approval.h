// approval.h: which failures a person may accept, and with what figures.
#pragma once

#include <string>
#include <vector>

#include "compare/tolerance_edit.h"
#include "reports/study.h"

namespace litmus {

/// Why the failing rows of a scene against a reference may not be approved, and what to do instead;
/// empty if they may. Refused are: rows that all pass, a run with a planted mistake, pixels that
/// are not finite, unregistered pictures, a renderer that failed or was not there, a closed form
/// that litmus disagrees with (then the mistake is ours), and candidates, which have no tolerance
/// of their own.
std::string approval_refusal(const Study& study, const std::string& scene,
                             const std::string& reference);

/// The failing rows of a scene against a reference that have a tolerance of their own: all but
/// those of the region "all".
std::vector<const Comparison*> failing_rows(const Study& study, const std::string& scene,
                                            const std::string& reference);

/// The changes of tolerances that let the rows pass, one for each reference and region, with
/// `reason`.
std::vector<ToleranceChange> raised_tolerances(std::span<const Comparison* const> rows,
                                               const std::string& reason);

/// "litmus approve s5-spot-tilted/blender --reason '...'", for the shell.
std::string approve_command(const Case& one, const std::string& reference);

}  // namespace litmus

// verdict.h: whether a difference is within its tolerance.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "compare/difference.h"
#include "compare/tolerances.h"

namespace litmus {

struct Verdict {
  bool pass = false;
  std::string reason;  ///< why it failed, or what a pass rests on; may be empty
};

/// Fails on any non-finite pixel whatever the tolerance, on max_abs or mean_abs over the tolerance,
/// and on a region without pixels unless it may be empty. Pixels over the tolerance pass where all
/// of them are `explained`, that is listed with their cause; then max_abs and mean_abs are not
/// judged.
Verdict judge(const Difference& difference, const Tolerance& tolerance, std::int64_t explained = 0);

/// The verdict on the whole picture: both regions pass.
Verdict combine(const Verdict& interior, const Verdict& edge);

/// The same over any regions; the reason names those that fail.
struct RegionVerdict {
  Region region;
  Verdict verdict;
};
Verdict combine(std::span<const RegionVerdict> regions);

}  // namespace litmus

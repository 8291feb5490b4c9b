// verdict.h: what a difference may be, and whether it is.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "compare/difference.h"

namespace litmus {

/// The largest figures that pass. They are absolute, in linear RGB where a fully lit white surface
/// is 1.
struct Tolerance {
  double max_abs = 0, mean_abs = 0;
  std::string_view reason;    ///< why these figures: what they have to cover
  bool may_be_empty = false;  ///< a region without pixels passes
};

struct NamedTolerance {
  std::string_view reference;  ///< "povray", "blender"
  Region region;               ///< Interior or Edge
  Tolerance tolerance;
};

/// All tolerances: the one place to review.
std::span<const NamedTolerance> tolerances();

/// The tolerance of a reference in a region. Region::All is held to the edge's, and is not judged
/// by itself (see `combine`). Throws Refusal if there is no such reference.
Tolerance find_tolerance(std::string_view reference, Region region);

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

}  // namespace litmus

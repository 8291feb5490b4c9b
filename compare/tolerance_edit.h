// tolerance_edit.h: new figures for tolerances.toml, with its comments and layout kept.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "compare/tolerances.h"

namespace litmus {

/// Raised figures are this many times what was seen: below kLargestMargin, and enough for another
/// machine's arithmetic.
inline constexpr double kRaisedMargin = 2;

/// What a [[tolerance]] is to say from now on.
struct ToleranceChange {
  std::string reference;
  Region region = Region::Interior;
  Tolerance tolerance;  ///< its reason is not used
  double seen_max = 0, seen_mean = 0;
  std::string reason;
};

/// `row` with figures that let these differences pass: what was seen grows to them, and what is
/// allowed to kRaisedMargin times that, where it is less. Rounded up to two digits (seen: three).
ToleranceChange raised(const NamedTolerance& row, double max_abs, double mean_abs,
                       std::string reason);

/// The file's text with the changes made, line by line; `rows` are what load_tolerances says of it.
/// Throws Refusal if a table or one of its lines is not found.
std::string edited_tolerances(std::string_view text, std::span<const NamedTolerance> rows,
                              std::span<const ToleranceChange> changes);

/// The lines that differ between two texts of equally many lines, as a unified diff without
/// context.
std::string line_diff(std::string_view file, std::string_view before, std::string_view after);

}  // namespace litmus

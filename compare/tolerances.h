// tolerances.h: what a difference may be. The values stand in compare/tolerances.toml, with their
// reasons and the largest errors seen.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/difference.h"

namespace litmus {

/// The largest figures that pass. They are absolute, in linear RGB where a fully lit white surface
/// is 1.
struct Tolerance {
  double max_abs = 0, mean_abs = 0;
  std::string_view reason;    ///< why these figures: what they have to cover
  bool may_be_empty = false;  ///< a region without pixels passes
};

/// One [[tolerance]] of the file. Its texts live as long as the program.
struct NamedTolerance {
  std::string_view reference;          ///< "povray", "blender"
  Region region;                       ///< any but All
  Tolerance tolerance;                 ///< may be empty, but for the interior
  double seen_max = 0, seen_mean = 0;  ///< the largest figures seen over the canonical scenes
  int line = 0;                        ///< in the file
};

/// All tolerances: those of `tolerances_file()`, read once.
std::span<const NamedTolerance> tolerances();

/// tolerances.toml in data_directory(), or in its folder compare/ in the source tree.
std::filesystem::path tolerances_file();

/// Reads such a file. Throws Refusal "file:line:column: key: ..." for an unknown or missing key, a
/// value that is no number >= 0, an error seen that is over its tolerance, a region that is given
/// twice, and a reference without one of its regions.
std::vector<NamedTolerance> load_tolerances(const std::filesystem::path& file);

/// The tolerance of a reference in a region. Region::All is held to the edge's, and is not judged
/// by itself (see `combine`). Throws Refusal if there is no such reference.
Tolerance find_tolerance(std::string_view reference, Region region);

/// A tolerance that is more than this many times what was seen hides a regression of that size.
inline constexpr double kLargestMargin = 4;

/// One sentence, with file and line, for each figure that is over kLargestMargin times what was
/// seen.
std::vector<std::string> tolerance_warnings(std::span<const NamedTolerance> rows,
                                            const std::filesystem::path& file);

}  // namespace litmus

// compare_samples.h: litmus compare --samples, two noisy renderers by their pictures.
#pragma once

#include <span>
#include <string>

namespace litmus {

/// Compares sets of files given by patterns (as *, ? and [] in a shell): ours, theirs, ours, theirs
/// and so on. Files with the same parts are compared part by part. All comparisons of one call are
/// judged together (Holm). Prints a table or JSON, and warnings on stderr. Returns the exit code.
/// Throws Refusal for a pattern without files, an odd number of patterns, and pictures that need
/// more than kMaximumSampleBytes together.
int compare_sample_files(std::span<const std::string> patterns, double negligible, bool json);

inline constexpr double kMaximumSampleBytes = 2e9;

}  // namespace litmus

// read_results.h: a results.json as a study again.
#pragma once

#include <filesystem>

#include "reports/study.h"

namespace litmus {

/// What a results.json says of its rows, cases, renderers and provenance; there are no pictures
/// and no rows for information. Throws Refusal "FILE: comparisons[3].max_abs: ..." with a
/// remedy for a file that is missing, no JSON, of another schema_version, without a needed member,
/// with one of another type, or with a row twice.
Study read_results(const std::filesystem::path& file);

}  // namespace litmus

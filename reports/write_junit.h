// write_junit.h: junit.xml, for continuous integration.
#pragma once

#include <filesystem>

#include "reports/study.h"

namespace litmus {

/// A test suite per scene, a test case per row. A failed row is a failure with its figures and
/// pixel, a skipped row is skipped with its reason; a renderer that failed is a test case with an
/// error and the end of its log. The last suite, "provenance", has no
/// tests but the properties that may differ where the inputs do not. Throws Refusal naming the
/// file.
void write_junit(const Study& study, const std::filesystem::path& file);

}  // namespace litmus

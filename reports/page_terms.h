// page_terms.h: slide 5 with numbers for every pixel of a scene, so that the page can explain one.
#pragma once

#include <string>
#include <vector>

#include "reports/study.h"

namespace litmus {

/// The terms of every light at every pixel's centre (half floats, packed as in packing.h), what
/// stops it there, the objects seen, and the colours of materials and lights, as JSON;
/// reports/web/terms.js reads it. A planted mistake (Case::control) is in the numbers and named.
/// Empty if the scene's file cannot be read any more, or is not what was rendered: numbers that do
/// not belong to the picture would explain nothing.
std::string terms_json(const Case& one);

/// terms_json for each case in the study's order, failing scenes first, as far as `budget` bytes
/// go; empty for the others.
std::vector<std::string> explained_cases(const Study& study, std::size_t budget);

}  // namespace litmus

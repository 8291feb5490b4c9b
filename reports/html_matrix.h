// html_matrix.h: the matrix of report.html, scene x light type x reference, as data for its template.
//
// A line is a light type of a scene. Its cells stand in three groups: the lights by themselves,
// and, once a scene, ambient light and the whole picture; each group has a column a reference.
#pragma once

#include <kainjow/mustache.hpp>

#include "reports/study.h"

namespace litmus {

/// The light types that occur, for the filter.
kainjow::mustache::data light_types_data(const Study& study);

/// The groups of columns that occur, each with all references.
kainjow::mustache::data matrix_heads(const Study& study);

/// The lines of one scene, a cell for each column.
kainjow::mustache::data matrix_lines(const Study& study, const Case& one);

}  // namespace litmus

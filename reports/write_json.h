// write_json.h: results.json, for machines. Its schema is reports/results.schema.json.
#pragma once

#include <filesystem>
#include <string>

#include "reports/study.h"

namespace litmus {

/// The whole study but its pictures. Numbers read back as the same doubles. Throws
/// std::invalid_argument if a figure is not finite: JSON cannot say so, and no figure may be.
std::string results_json(const Study& study, int indent = 2);

/// results_json in two parts, on one line each: all that identical inputs decide, with null for the
/// provenance, and the provenance.
std::string reproducible_json(const Study& study);
std::string provenance_json(const Study& study);

/// Writes results_json to the file, whole or not at all. Throws Refusal naming the file.
void write_json(const Study& study, const std::filesystem::path& file);

}  // namespace litmus

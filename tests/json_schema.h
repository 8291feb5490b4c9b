// json_schema.h: whether JSON is as a published schema says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace litmus {

/// What of the value does not match, each with its place; empty where all does. `file` is that of
/// the schema, from the repository's top folder.
std::vector<std::string> schema_mismatches(const std::string& file, const nlohmann::json& value);

}  // namespace litmus

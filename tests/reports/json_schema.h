// json_schema.h: the part of JSON Schema that the published schemas use.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace litmus {

inline bool has_type(const nlohmann::json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

/// What of the value does not match: type, enum, minimum, exclusiveMinimum, minItems, maxItems,
/// items, required, properties, additionalProperties, and allOf with if and then.
inline void check_schema(const nlohmann::json& schema, const nlohmann::json& value,
                         const std::string& at, std::vector<std::string>& errors) {
  if (schema.contains("type") && !has_type(value, schema["type"])) {
    errors.push_back(fmt::format("{}: not of type {}", at, schema["type"].get<std::string>()));
    return;
  }
  if (schema.contains("enum")) {
    bool known = false;
    for (const auto& one : schema["enum"]) known = known || one == value;
    if (!known) errors.push_back(at + ": not one of the enum");
  }
  if (schema.contains("minimum") && value.get<double>() < schema["minimum"].get<double>())
    errors.push_back(at + ": below the minimum");
  if (schema.contains("exclusiveMinimum") &&
      value.get<double>() <= schema["exclusiveMinimum"].get<double>())
    errors.push_back(at + ": not above the exclusive minimum");
  for (const auto& part : schema.value("allOf", nlohmann::json::array())) {
    std::vector<std::string> unlike;
    check_schema(part.at("if"), value, at, unlike);
    if (unlike.empty()) check_schema(part.at("then"), value, at, errors);
  }
  if (value.is_array()) {
    if (schema.contains("minItems") && value.size() < schema["minItems"].get<std::size_t>())
      errors.push_back(at + ": too few items");
    if (schema.contains("maxItems") && value.size() > schema["maxItems"].get<std::size_t>())
      errors.push_back(at + ": too many items");
    for (std::size_t i = 0; i < value.size(); ++i)
      check_schema(schema.at("items"), value[i], fmt::format("{}[{}]", at, i), errors);
  }
  if (!value.is_object()) return;
  for (const auto& key : schema.value("required", nlohmann::json::array()))
    if (!value.contains(key.get<std::string>()))
      errors.push_back(fmt::format("{}.{}: missing", at, key.get<std::string>()));
  for (const auto& [key, member] : value.items()) {
    const auto& properties = schema.value("properties", nlohmann::json::object());
    const auto& others = schema.value("additionalProperties", nlohmann::json(true));
    if (properties.contains(key))
      check_schema(properties[key], member, at + "." + key, errors);
    else if (others.is_object())
      check_schema(others, member, at + "." + key, errors);
    else if (others == false)
      errors.push_back(fmt::format("{}.{}: not in the schema", at, key));
  }
}

}  // namespace litmus

// json_schema.cpp: validation by valijson.
#include "tests/json_schema.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "test_paths.h"

namespace litmus {

std::vector<std::string> schema_mismatches(const std::string& file, const nlohmann::json& value) {
  using valijson::adapters::NlohmannJsonAdapter;
  std::ifstream stream(std::string(LITMUS_SOURCE "/") + file);
  const nlohmann::json text = nlohmann::json::parse(stream);
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(NlohmannJsonAdapter(text), schema);
  valijson::ValidationResults results;
  valijson::Validator().validate(schema, NlohmannJsonAdapter(value), &results);
  std::vector<std::string> errors;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    std::string place;
    for (const std::string& step : error.context) place += step;
    errors.push_back(place + ": " + error.description);
  }
  return errors;
}

}  // namespace litmus

// read_results.cpp: reads results.json, strictly, and names the place of what is wrong.
#include "reports/read_results.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/difference.h"
#include "scene/document.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kRemedy = "make it with `litmus run` of this version";

/// A value of the file, and how it is called there.
struct Place {
  const fs::path& file;
  std::string name;  ///< "comparisons[3].max_abs"; empty for the root
  const json& value;

  [[noreturn]] void refuse(const std::string& what) const {
    throw Refusal(fmt::format("{}: {}{}{}; {}", file.string(), name, name.empty() ? "" : ": ", what,
                              kRemedy));
  }
  bool has(const char* key) const { return value.is_object() && value.contains(key); }
  Place operator[](const char* key) const {
    if (!value.is_object()) refuse("must be an object");
    const std::string place = name.empty() ? key : name + "." + key;
    const auto found = value.find(key);
    if (found == value.end()) throw_missing(place);
    return {file, place, *found};
  }
  std::vector<Place> items() const {
    if (!value.is_array()) refuse("must be an array");
    std::vector<Place> places;
    for (std::size_t i = 0; i < value.size(); ++i)
      places.push_back({file, fmt::format("{}[{}]", name, i), value[i]});
    return places;
  }
  std::string text() const {
    if (!value.is_string()) refuse("must be a text");
    return value.get<std::string>();
  }
  double number() const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) refuse("must be a number");
    return value.get<double>();
  }
  double not_negative() const {
    const double result = number();
    if (result < 0) refuse("must be a number >= 0");
    return result;
  }
  std::int64_t count() const {
    if (!value.is_number_integer() || value.get<double>() < 0)
      refuse("must be a whole number >= 0");
    return value.get<std::int64_t>();
  }
  std::string word(std::initializer_list<const char*> words) const {
    const std::string result = text();
    for (const char* each : words)
      if (result == each) return result;
    refuse(fmt::format("must be one of {}, not \"{}\"", fmt::join(words, ", "), result));
  }

 private:
  [[noreturn]] void throw_missing(const std::string& place) const {
    throw Refusal(fmt::format("{}: {}: is missing; {}", file.string(), place, kRemedy));
  }
};

Comparison read_row(const Place& place) {
  Comparison row;
  row.scene = place["scene"].text(), row.reference = place["reference"].text();
  row.source = place["source"].word({"live", "stored", "computed", ""});
  row.light = place["light"].text(), row.light_type = place["light_type"].text();
  row.region = place["region"].text();
  row.pixels = place["pixels"].count(), row.nonfinite = place["nonfinite"].count();
  for (const auto& metric : kMetrics<Comparison>) {
    const Place figure = place[std::string(metric.name).c_str()];
    row.*metric.member = metric.name == "bias" ? figure.number() : figure.not_negative();
  }
  row.over_tolerance = place["over_tolerance"].count(), row.explained = place["explained"].count();
  row.tolerance = place["tolerance"].not_negative();
  row.mean_tolerance = place["mean_tolerance"].not_negative();
  row.verdict = place["verdict"].word({"pass", "fail", "skipped"});
  row.reason = place["reason"].text();
  return row;
}

CaseReference read_reference(const Place& place) {
  CaseReference reference;
  reference.reference = place["reference"].text();
  reference.source = place["source"].word({"live", "stored", "computed", ""});
  reference.version = place["version"].text(), reference.command = place["command"].text();
  reference.failure = place["failure"].text();
  const Place registration = place["registration"];
  if (!registration["determined"].value.is_boolean())
    registration["determined"].refuse("must be true or false");
  reference.registration.determined = registration["determined"].value.get<bool>();
  reference.registration.dx = registration["shift_x"].number();
  reference.registration.dy = registration["shift_y"].number();
  reference.registration.scale = registration["scale"].number();
  reference.registration.explained = registration["explained"].number();
  return reference;
}

Case read_case(const Place& place) {
  Case one;
  one.scene = place["scene"].text(), one.file = place["file"].text();
  one.width = int(place["width"].count()), one.height = int(place["height"].count());
  for (const Place& reference : place["references"].items())
    one.references.push_back(read_reference(reference));
  return one;
}

void read_seconds(const Place& rendering, std::vector<Case>& cases) {
  std::map<std::string, Case*> by_scene;
  for (Case& one : cases) by_scene[one.scene] = &one;
  for (const Place& place : rendering.items()) {
    const auto found = by_scene.find(place["scene"].text());
    if (found == by_scene.end()) place["scene"].refuse("is not among the cases");
    found->second->seconds = place["seconds"].not_negative();
    const Place references = place["references"];
    for (CaseReference& reference : found->second->references)
      if (references.has(reference.reference.c_str()))
        reference.seconds = references[reference.reference.c_str()].not_negative();
  }
}

json parsed(const fs::path& file) {
  std::string text;
  try {
    text = read_limited(file);
  } catch (const std::runtime_error& wrong) {
    throw Refusal(fmt::format("{}: {}; {}", file.string(), wrong.what(), kRemedy));
  }
  try {
    return json::parse(text);
  } catch (const json::parse_error& wrong) {
    // "[json.exception.parse_error.101] parse error at line 3, column 7: ...": from its place on.
    const std::string what = wrong.what();
    const std::size_t at = what.find("at line");
    throw Refusal(fmt::format("{}: is no JSON: {}; {}", file.string(),
                              at == std::string::npos ? what : what.substr(at), kRemedy));
  }
}

}  // namespace

Study read_results(const fs::path& file) {
  const json document = parsed(file);
  const Place root{file, "", document};
  if (!document.is_object() || !document.contains("schema_version"))
    root.refuse("has no schema_version, so it is no results.json");
  if (document["schema_version"] != kResultsSchemaVersion)
    root["schema_version"].refuse(fmt::format("is {}, and this litmus reads {}",
                                              document["schema_version"].dump(),
                                              kResultsSchemaVersion));
  Study study;
  const Place provenance = root["provenance"];
  study.provenance.litmus_version = provenance["litmus_version"].text();
  study.provenance.commit = provenance["commit"].text();
  study.provenance.command = provenance["command"].text();
  study.provenance.cpu = provenance["cpu"].text();
  for (const Place& one : root["cases"].items()) study.cases.push_back(read_case(one));
  read_seconds(provenance["rendering"], study.cases);
  for (const Place& one : root["candidates"].items())
    study.candidates.push_back({one["name"].text(), one["encoding"].text(), 1, ""});
  std::set<std::array<std::string, 4>> known;
  for (const Place& place : root["comparisons"].items()) {
    Comparison row = read_row(place);
    if (!known.insert({row.scene, row.reference, row.light, row.region}).second)
      place.refuse("is there twice");
    study.comparisons.push_back(std::move(row));
  }
  return study;
}

}  // namespace litmus

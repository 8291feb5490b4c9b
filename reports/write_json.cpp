// write_json.cpp: results.json, for machines.
#include "reports/write_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "compare/difference.h"
#include "compare/whole_file.h"

namespace litmus {
namespace {
using nlohmann::ordered_json;

double finite(double value, const std::string& where) {
  if (!std::isfinite(value))
    throw std::invalid_argument(where + " is not finite and cannot be written as JSON");
  return value;
}

// How long each scene took: by us, and by each renderer that drew it.
ordered_json rendering_json(const Study& study) {
  ordered_json rendering = ordered_json::array();
  for (const Case& one : study.cases) {
    ordered_json references = ordered_json::object();
    for (const CaseReference& r : one.references)
      references[r.reference] = finite(r.seconds, one.scene + "." + r.reference + ".seconds");
    rendering.push_back({{"scene", one.scene},
                         {"seconds", finite(one.seconds, one.scene + ".seconds")},
                         {"references", references}});
  }
  return rendering;
}

ordered_json slower_json(const BaselineReport& report) {
  ordered_json slower = ordered_json::array();
  for (const SpeedChange& change : report.slower)
    slower.push_back({{"scene", change.scene},
                      {"reference", change.reference},
                      {"was", finite(change.was, "slower.was")},
                      {"now", finite(change.now, "slower.now")}});
  return slower;
}

ordered_json provenance_object(const Study& study) {
  const Provenance& p = study.provenance;
  ordered_json versions = ordered_json::object();
  for (const auto& [name, version] : p.versions) versions[name] = version;
  ordered_json json{{"litmus_version", p.litmus_version},
                    {"commit", p.commit},
                    {"compiler", p.compiler},
                    {"flags", p.flags},
                    {"cpu", p.cpu},
                    {"system", p.system},
                    {"command", p.command},
                    {"started", p.started},
                    {"threads", p.threads},
                    {"seconds", finite(p.seconds, "provenance.seconds")},
                    {"versions", versions},
                    {"rendering", rendering_json(study)}};
  if (study.baseline) json["slower"] = slower_json(*study.baseline);
  return json;
}

ordered_json registration_json(const Registration& r, const std::string& where) {
  return {{"determined", r.determined},
          {"shift_x", finite(r.dx, where + ".shift_x")},
          {"shift_y", finite(r.dy, where + ".shift_y")},
          {"scale", finite(r.scale, where + ".scale")},
          {"explained", finite(r.explained, where + ".explained")},
          {"why", r.why}};
}

ordered_json case_json(const Case& one) {
  ordered_json references = ordered_json::array();
  for (const CaseReference& r : one.references)
    references.push_back(
        {{"reference", r.reference},
         {"source", r.source},
         {"version", r.version},
         {"command", r.command},
         {"failure", r.failure},
         {"registration", registration_json(r.registration, one.scene + "." + r.reference)}});
  return {{"scene", one.scene},   {"file", one.file},         {"about", one.about},
          {"tags", one.tags},     {"warnings", one.warnings}, {"width", one.width},
          {"height", one.height}, {"references", references}};
}

ordered_json comparison_json(const Comparison& row) {
  ordered_json json{{"scene", row.scene},   {"reference", row.reference},   {"source", row.source},
                    {"light", row.light},   {"light_type", row.light_type}, {"region", row.region},
                    {"pixels", row.pixels}, {"nonfinite", row.nonfinite}};
  for (const auto& metric : kMetrics<Comparison>)
    json[std::string(metric.name)] =
        finite(row.*metric.member, row.scene + "." + std::string(metric.name));
  json["max_at"] = row.max_at;
  json["over_tolerance"] = row.over_tolerance;
  json["explained"] = row.explained;
  json["tolerance"] = finite(row.tolerance, row.scene + ".tolerance");
  json["mean_tolerance"] = finite(row.mean_tolerance, row.scene + ".mean_tolerance");
  json["verdict"] = row.verdict;
  json["reason"] = row.reason;
  json["hint"] = row.hint;
  json["suspect"] = row.suspect;
  json["causes"] = row.causes;
  if (row.triage)
    json["triage"] = {{"ldr_flip", finite(row.triage->ldr_flip, row.scene + ".ldr_flip")},
                      {"hdr_flip", finite(row.triage->hdr_flip, row.scene + ".hdr_flip")},
                      {"ssim", finite(row.triage->ssim, row.scene + ".ssim")}};
  if (row.blame)
    json["blame"] = {{"verdict", row.blame->verdict},
                     {"pixels", row.blame->pixels},
                     {"ours", row.blame->ours},
                     {"theirs", row.blame->theirs},
                     {"ill_conditioned", row.blame->ill_conditioned},
                     {"our_error", finite(row.blame->our_error, row.scene + ".our_error")},
                     {"their_error", finite(row.blame->their_error, row.scene + ".their_error")}};
  json["bands"] = row.bands;
  json["against"] = row.against;
  return json;
}

ordered_json baseline_json(const BaselineReport& report) {
  ordered_json changes = ordered_json::array(), versions = ordered_json::array();
  for (const BaselineChange& change : report.changes)
    changes.push_back({{"kind", change.kind},
                       {"scene", change.scene},
                       {"reference", change.reference},
                       {"light", change.light},
                       {"light_type", change.light_type},
                       {"region", change.region},
                       {"figure", change.figure},
                       {"was", finite(change.was, change.scene + ".was")},
                       {"now", finite(change.now, change.scene + ".now")},
                       {"limit", finite(change.limit, change.scene + ".limit")},
                       {"why", change.why}});
  for (const VersionChange& change : report.versions)
    versions.push_back({{"reference", change.reference}, {"was", change.was}, {"now", change.now}});
  return {{"file", report.file},         {"regression", is_regression(report)},
          {"compared", report.compared}, {"still_failing", report.still_failing},
          {"added", report.added},       {"changes", changes},
          {"versions", versions}};
}

// A byte that is not UTF-8 becomes U+FFFD.
std::string text_of(const ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json results_object(const Study& study, ordered_json provenance) {
  ordered_json json{
      {"schema_version", kResultsSchemaVersion}, {"verdict", overall_verdict(study)},
      {"provenance", std::move(provenance)},     {"warnings", study.warnings},
      {"cases", ordered_json::array()},          {"comparisons", ordered_json::array()},
      {"informative", ordered_json::array()},    {"pairs", ordered_json::array()},
      {"candidates", ordered_json::array()}};
  for (const Case& one : study.cases) json["cases"].push_back(case_json(one));
  for (const Comparison& row : study.comparisons)
    json["comparisons"].push_back(comparison_json(row));
  for (const Comparison& row : study.informative)
    json["informative"].push_back(comparison_json(row));
  for (const Comparison& row : study.pairs) json["pairs"].push_back(comparison_json(row));
  for (const CandidateNote& one : study.candidates)
    json["candidates"].push_back({{"name", one.name},
                                  {"encoding", one.encoding},
                                  {"exposure", one.exposure},
                                  {"note", one.note}});
  if (study.baseline) json["baseline"] = baseline_json(*study.baseline);
  return json;
}

}  // namespace

std::string results_json(const Study& study, int indent) {
  return text_of(results_object(study, provenance_object(study)), indent);
}

std::string reproducible_json(const Study& study) {
  return text_of(results_object(study, nullptr), -1);
}

std::string provenance_json(const Study& study) { return text_of(provenance_object(study), -1); }

void write_json(const Study& study, const std::filesystem::path& file) {
  write_whole(file, results_json(study) + "\n");
}

}  // namespace litmus

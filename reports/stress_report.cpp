// stress_report.cpp: stress.json.
#include "reports/stress_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/whole_file.h"
#include "reports/stress_page.h"

namespace litmus {
namespace {
using nlohmann::ordered_json;

double finite(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::max();
}

ordered_json finite(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double value : values) list.push_back(finite(value));
  return list;
}

ordered_json row_json(const StressRow& row) {
  ordered_json json{{"id", row.id},
                    {"group", row.group},
                    {"what", row.what},
                    {"scalar", row.scalar},
                    {"domain", row.domain},
                    {"metric", row.metric},
                    {"samples", row.samples},
                    {"seen", finite(row.seen)},
                    {"bound", row.bound},
                    {"control", row.control},
                    {"control_seen", finite(row.control_seen)},
                    {"judged", row.judged},
                    {"holds", holds(row)}};
  if (row.curve)
    json["curve"] = {{"y_label", row.curve->y_label},    {"logarithmic", row.curve->logarithmic},
                     {"x_label", row.curve->x_label},    {"low", row.curve->low},
                     {"high", row.curve->high},          {"robust", finite(row.curve->robust)},
                     {"naive", finite(row.curve->naive)}};
  return json;
}

}  // namespace

bool passes(const StressReport& report) {
  return std::all_of(report.rows.begin(), report.rows.end(), holds);
}

std::string stress_json(const StressReport& report) {
  const Provenance& p = report.provenance;
  ordered_json json{{"schema_version", kStressSchemaVersion},
                    {"passes", passes(report)},
                    {"provenance",
                     {{"litmus_version", p.litmus_version},
                      {"commit", p.commit},
                      {"compiler", p.compiler},
                      {"flags", p.flags},
                      {"cpu", p.cpu},
                      {"command", p.command},
                      {"seconds", p.seconds}}},
                    {"samples", report.samples},
                    {"rays", report.rays},
                    {"rows", ordered_json::array()},
                    {"envelopes", ordered_json::array()}};
  for (const StressRow& row : report.rows) json["rows"].push_back(row_json(row));
  for (const EnvelopePoint& point : report.envelopes)
    json["envelopes"].push_back({{"axis", point.axis},
                                 {"value", point.value},
                                 {"renderer", point.renderer},
                                 {"differing", point.differing},
                                 {"failure", point.failure}});
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace);
}

void write_stress(const StressReport& report, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_whole(folder / "stress.json", stress_json(report) + "\n");
  write_whole(folder / "stress.html", stress_page(report));
}

}  // namespace litmus

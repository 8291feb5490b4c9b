// stress_report.h: the results of litmus stress, for machines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/envelope_study.h"
#include "reports/study.h"
#include "stress/stress.h"

namespace litmus {

inline constexpr int kStressSchemaVersion = 1;

struct StressReport {
  Provenance provenance;
  std::uint64_t samples = 0, rays = 0;  ///< as asked for
  std::vector<StressRow> rows;
  std::vector<EnvelopePoint> envelopes;  ///< empty unless asked for
};

/// Whether every figure keeps its bound and every control breaks it.
bool passes(const StressReport& report);

/// stress.json (reports/stress.schema.json). A result that is not finite is written as the largest
/// double.
std::string stress_json(const StressReport& report);

/// Writes DIR/stress.json and DIR/stress.html; the folder is made if it is missing.
void write_stress(const StressReport& report, const std::filesystem::path& folder);

}  // namespace litmus

// provenance_json.h: what a report of costs was made with, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "reports/study.h"

namespace litmus {

/// An object with every member of the provenance, its text clean; `versions` is a list of objects
/// with "name" and "version".
nlohmann::ordered_json provenance_fields(const Provenance& p);

}  // namespace litmus

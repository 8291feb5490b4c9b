// write_cost.h: a cost study for machines and for people.
#pragma once

#include <string>

#include "reports/cost.h"

namespace litmus {

/// cost.json; its schema is reports/cost.schema.json.
std::string cost_json(const CostStudy& study);

/// cost.html: one self-contained page with tables, plots and sentences.
std::string cost_html(const CostStudy& study);

}  // namespace litmus

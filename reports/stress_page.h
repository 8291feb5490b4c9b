// stress_page.h: stress.html, hard cases for people: naive against robust.
#pragma once

#include <string>

#include "reports/stress_report.h"

namespace litmus {

/// A self-contained page without scripts, in the report's style.
std::string stress_page(const StressReport& report);

}  // namespace litmus

// stress.cpp: all experiments in a row.
#include "stress/stress.h"

#include <iterator>

namespace litmus {

bool holds(const StressRow& row) {
  return !row.judged || (row.seen <= row.bound && row.control_seen > row.bound);
}

std::vector<StressRow> run_stress(const StressOptions& options) {
  struct Part {
    const char* name;
    std::vector<StressRow> (*run)(const StressOptions&);
  };
  const Part parts[] = {{"formulas", stress_formulas},
                        {"shadow rays", stress_shadows},
                        {"meshes", stress_leaks},
                        {"pictures", stress_pictures}};
  std::vector<StressRow> rows;
  for (const Part& part : parts) {
    options.progress(part.name);
    std::vector<StressRow> more = part.run(options);
    rows.insert(rows.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
  }
  return rows;
}

}  // namespace litmus

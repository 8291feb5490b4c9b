// stress.cpp: when a figure of an experiment holds.
#include "stress/stress.h"

namespace litmus {

bool holds(const StressRow& row) {
  return !row.judged || (row.seen <= row.bound && row.control_seen > row.bound);
}

}  // namespace litmus

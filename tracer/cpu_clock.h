// cpu_clock.h: the processor time of the whole program.
#pragma once

#include <ctime>

namespace litmus {

/// Seconds that all threads of the program have computed so far. Unlike the wall clock it does not
/// count what other programs do at the same time.
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

}  // namespace litmus

// sweep.h: runs an experiment's samples on all threads and adds up their tallies.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cstdint>

namespace litmus {

/// Calls body(i, tally) for i in [0, count). `Tally` starts empty and has `add(const Tally&)`,
/// whose result must not depend on the order (maxima and counts).
template <class Tally, class Body>
Tally sweep(std::uint64_t count, const Tally& empty, const Body& body) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, count, 1024), empty,
      [&](const tbb::blocked_range<std::uint64_t>& range, Tally tally) {
        for (std::uint64_t i = range.begin(); i < range.end(); ++i) body(i, tally);
        return tally;
      },
      [](Tally a, const Tally& b) {
        a.add(b);
        return a;
      });
}

}  // namespace litmus

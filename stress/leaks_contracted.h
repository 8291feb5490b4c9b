// leaks_contracted.h: the rays of leak_rays.h in a second build of the intersections, for this
// machine's processor and with multiplications and additions contracted at the compiler's will.
#pragma once

#include <cstdint>

namespace litmus_contracted {

/// Rays of the meshes with numbers in [first, last) that leak out of the watertight and of the
/// Moeller-Trumbore intersection, added to `leaks[0]` and `leaks[1]`.
void count_leaks_float(std::uint64_t first, std::uint64_t last, std::uint64_t leaks[2]);
void count_leaks_double(std::uint64_t first, std::uint64_t last, std::uint64_t leaks[2]);

/// What the build needs of the processor; readable without it.
struct Needs {
  bool fma, avx2, avx512;
};
extern const Needs kNeeds;

}  // namespace litmus_contracted

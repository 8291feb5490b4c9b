// leaks_contracted.cpp: compiled for this machine's processor with contraction. All of litmus that
// it sees gets a namespace of its own, so that no function built like this is linked elsewhere.
#define litmus litmus_contracted

#include "stress/leaks_contracted.h"

#include "stress/leak_rays.h"

namespace litmus_contracted {
namespace {

template <Real R>
void count_leaks(std::uint64_t first, std::uint64_t last, std::uint64_t leaks[2]) {
  for (std::uint64_t i = first; i < last; ++i) {
    Draw draw(200 + sizeof(R), i);
    const ClosedMesh<R> mesh = closed_mesh<R>(draw, i % 2 ? 1e5 : 0);
    for (int ray = 0; ray < kRaysPerMesh; ++ray) {
      const Ray<R> aimed = aimed_ray(draw, mesh);
      leaks[0] += leaks_watertight(mesh, aimed);
      leaks[1] += leaks_moeller_trumbore(mesh, aimed);
    }
  }
}

constexpr bool kFma =
#ifdef __FMA__
    true;
#else
    false;
#endif
constexpr bool kAvx2 =
#ifdef __AVX2__
    true;
#else
    false;
#endif
constexpr bool kAvx512 =
#ifdef __AVX512F__
    true;
#else
    false;
#endif

}  // namespace

const Needs kNeeds{kFma, kAvx2, kAvx512};

void count_leaks_float(std::uint64_t first, std::uint64_t last, std::uint64_t leaks[2]) {
  count_leaks<float>(first, last, leaks);
}
void count_leaks_double(std::uint64_t first, std::uint64_t last, std::uint64_t leaks[2]) {
  count_leaks<double>(first, last, leaks);
}

}  // namespace litmus_contracted

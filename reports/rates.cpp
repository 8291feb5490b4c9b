// rates.cpp: chains of operations side by side, as many as keep every unit busy.
#include "reports/rates.h"

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#include <immintrin.h>

#include <algorithm>

#include "tracer/cpu_clock.h"
#endif

namespace litmus {

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
namespace {

constexpr int kChains = 12, kSteps = 200'000;

/// Runs step(chain, i) on 12 chains, none of which waits for another, and returns the steps a
/// second.
#define LITMUS_CHAINS(vector, start, step)                                    \
  vector x[kChains];                                                          \
  _Pragma("GCC unroll 12") for (int k = 0; k < kChains; ++k) x[k] = start;    \
  const double begin = cpu_seconds();                                         \
  for (int i = 0; i < kSteps; ++i) {                                          \
    _Pragma("GCC unroll 12") for (int k = 0; k < kChains; ++k) {              \
      x[k] = step;                                                            \
      asm volatile("" : "+v"(x[k]));                                          \
    }                                                                         \
  }                                                                           \
  return double(kSteps) * kChains * double(sizeof(vector) / sizeof(double)) / \
         (cpu_seconds() - begin);

#define LITMUS_RATES(name, isa, vector, set, mul, add, div, root)                    \
  [[gnu::target(isa), gnu::optimize("O3")]] double name##_sums() {                   \
    const vector near_one = set(0.999999), little = set(1e-9);                       \
    LITMUS_CHAINS(vector, set(1.5), k % 2 ? mul(x[k], near_one) : add(x[k], little)) \
  }                                                                                  \
  [[gnu::target(isa), gnu::optimize("O3")]] double name##_divisions() {              \
    const vector two = set(2.0);                                                     \
    LITMUS_CHAINS(vector, set(1.5), div(two, x[k]))                                  \
  }                                                                                  \
  [[gnu::target(isa), gnu::optimize("O3")]] double name##_roots() {                  \
    LITMUS_CHAINS(vector, set(1.5), root(x[k]))                                      \
  }

LITMUS_RATES(wide, "avx512f", __m512d, _mm512_set1_pd, _mm512_mul_pd, _mm512_add_pd, _mm512_div_pd,
             _mm512_sqrt_pd)
LITMUS_RATES(half, "avx2", __m256d, _mm256_set1_pd, _mm256_mul_pd, _mm256_add_pd, _mm256_div_pd,
             _mm256_sqrt_pd)

double best_of(double (*rate)()) {
  double best = 0;
  for (int i = 0; i < 5; ++i) best = std::max(best, rate());
  return best;
}

}  // namespace

ArithmeticRates arithmetic_rates() {
  if (__builtin_cpu_supports("avx512f"))
    return {best_of(wide_sums), best_of(wide_divisions), best_of(wide_roots)};
  if (__builtin_cpu_supports("avx2"))
    return {best_of(half_sums), best_of(half_divisions), best_of(half_roots)};
  return {};
}
#else
ArithmeticRates arithmetic_rates() { return {}; }
#endif

}  // namespace litmus

// self_check_test.cpp: the start-up check finds what libraries do to a process.
#include "tracer/self_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <thread>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace litmus {
namespace {
using testing::HasSubstr;

/// The fault that a thread of its own has after `spoil`.
template <class Spoil>
std::string fault_after(Spoil spoil) {
  std::string fault;
  std::thread([&] {
    spoil();
    fault = arithmetic_fault();
  }).join();
  return fault;
}

TEST(ArithmeticFault, IsNoneHere) { EXPECT_EQ(arithmetic_fault(), ""); }

TEST(ArithmeticFault, IsAChangedRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    EXPECT_THAT(fault_after([&] { std::fesetround(mode); }), HasSubstr("rounding mode"));
}

#if defined(__x86_64__)
TEST(ArithmeticFault, IsFlushingSubnormalNumbersToZero) {
  EXPECT_THAT(fault_after([] { _mm_setcsr(_mm_getcsr() | 0x8000); }), HasSubstr("(FTZ)"));
}

TEST(ArithmeticFault, IsReadingSubnormalNumbersAsZero) {
  EXPECT_THAT(fault_after([] { _mm_setcsr(_mm_getcsr() | 0x0040); }), HasSubstr("(DAZ)"));
}
#endif

}  // namespace
}  // namespace litmus

// packing_test.cpp: packed pictures keep their values.
#include "reports/packing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace litmus {
namespace {

// The value of a half float's bits, by its definition.
double half_value(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, digits = bits & 1023;
  const double size = exponent == 31 ? (digits ? std::nan("") : INFINITY)
                      : exponent     ? std::ldexp(1024 + digits, exponent - 25)
                                     : std::ldexp(digits, -24);
  return bits & 0x8000 ? -size : size;
}

TEST(HalfBits, AreThoseOfTheStandard) {
  EXPECT_EQ(half_bits(0), 0x0000);
  EXPECT_EQ(half_bits(-0.0), 0x8000);
  EXPECT_EQ(half_bits(1), 0x3c00);
  EXPECT_EQ(half_bits(-2), 0xc000);
  EXPECT_EQ(half_bits(65504), 0x7bff);
  EXPECT_EQ(half_bits(std::ldexp(1, -14)), 0x0400) << "the smallest normal number";
  EXPECT_EQ(half_bits(std::ldexp(1, -24)), 0x0001) << "the smallest number";
  EXPECT_EQ(half_bits(1.0 / 3), 0x3555);
  EXPECT_EQ(half_bits(INFINITY), 0x7c00);
  EXPECT_EQ(half_bits(65520), 0x7c00) << "halfway past the largest number";
  EXPECT_TRUE(std::isnan(half_value(half_bits(std::nan("")))));
}

TEST(HalfBits, AreTheNearestForEveryHalfAndBetween) {
  for (int bits = 0; bits < 0x7bff; ++bits) {
    const double low = half_value(std::uint16_t(bits)), high = half_value(std::uint16_t(bits + 1));
    ASSERT_EQ(half_bits(low), bits);
    ASSERT_EQ(half_bits(low + 0.49 * (high - low)), bits);
    ASSERT_EQ(half_bits(low + 0.51 * (high - low)), bits + 1);
  }
}

TEST(AsUnpacked, KeepsElevenBitsOfWhatIsNotFarBelowTheLargest) {
  Picture picture(2, 1);
  picture.at(0, 0) = {1.0 / 3, 40000, 0};
  picture.at(1, 0) = {-1e-3, 1e-12, INFINITY};
  const Picture left = as_unpacked(picture);
  EXPECT_EQ(left.at(0, 0).x, half_value(half_bits(1.0 / 3)));
  EXPECT_EQ(left.at(0, 0).y, half_value(half_bits(40000)));
  EXPECT_EQ(left.at(1, 0).x, half_value(half_bits(-1e-3)));
  EXPECT_EQ(left.at(1, 0).y, 0);
  EXPECT_EQ(left.at(1, 0).z, INFINITY);
}

}  // namespace
}  // namespace litmus

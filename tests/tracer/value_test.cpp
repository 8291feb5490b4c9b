// value_test.cpp: vectors of every scalar.
#include "tracer/value.h"

#include <gtest/gtest.h>

namespace litmus {
namespace {

TEST(Direction, KeepsTheLengthOfAVectorWhoseSquareOverflows) {
  const Direction<double> d = direction_of(Vec<double>{3e200, 0, 4e200});
  EXPECT_DOUBLE_EQ(d.length, 5e200);
  EXPECT_DOUBLE_EQ(d.unit.x, 0.6);
  EXPECT_DOUBLE_EQ(d.unit.z, 0.8);
}

TEST(Direction, KeepsTheLengthOfAVectorWhoseSquareUnderflows) {
  const Direction<float> d = direction_of(Vec<float>{0, 3e-38f, 4e-38f});
  EXPECT_FLOAT_EQ(d.length, 5e-38f);
  EXPECT_FLOAT_EQ(d.unit.y, 0.6f);
}

TEST(Direction, IsTheSameBitByBitForAnyPowerOfTwo) {
  const Vec<double> v{0.3, -0.7, 0.11};
  for (int k = -1000; k <= 1000; k += 7) {
    const Vec<double> scaled{std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
    ASSERT_EQ(normalize(scaled), normalize(v)) << "2^" << k;
  }
}

TEST(Direction, OfAZeroVectorIsZero) {
  const Direction<double> d = direction_of(Vec<double>{});
  EXPECT_EQ(d.length, 0);
  EXPECT_EQ(d.unit, (Vec<double>{}));
}

TEST(Doubt, KnowsOfEverySquareThatOverOrUnderflows) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double square : {0.0, 5e-324, 0x1p-1022, 0x1p-600, 0x1p600, kInfinity, std::nan("")}) {
    Doubt<double> doubt;
    doubt.note(1.0), doubt.note(square), doubt.note(2.0);
    EXPECT_TRUE(doubt.where()) << square;
  }
  for (const double square : {0x1p-511, 1e-100, 0.99, 1.0, 3.0, 1e100, 0x1p512}) {
    Doubt<double> doubt;
    doubt.note(square);
    EXPECT_FALSE(doubt.where()) << square;
  }
}

TEST(Doubt, LeavesNoVectorWhosePlainDirectionDiffers) {
  for (int k = -1000; k <= 1000; ++k) {
    const Vec<double> v{std::ldexp(0.3, k), std::ldexp(-0.7, k), std::ldexp(0.11, k)};
    Doubt<double> doubt;
    const Direction<double> plain = direction_of(v, &doubt), careful = direction_of(v);
    EXPECT_EQ(doubt.where(), k < -255 || k > 256) << "2^" << k;
    if (!doubt.where()) {
      EXPECT_EQ(plain.unit, careful.unit) << "2^" << k;
    }
  }
}

TEST(Doubt, AgreesWithThePlainDirectionAtTheEndsOfItsRange) {
  // A component that scaling would make subnormal tells which way was taken.
  for (const double large : {0x1p255, 0x1p256, 0x1.6p256, 0x1p257}) {
    const Vec<double> v{large, 0x1.23456789abcdep-400, 0};
    Doubt<double> doubt;
    const Vec<double> plain = direction_of(v, &doubt).unit;
    if (!doubt.where()) {
      EXPECT_EQ(plain, direction_of(v).unit) << large;
    }
    EXPECT_EQ(doubt.where(), large > 0x1.6p256) << large;
  }
}

TEST(DifferenceOfProducts, KeepsTheDigitsThatPlainArithmeticCancels) {
  const double a = 1 + 0x1p-30, b = 1 - 0x1p-30;
  EXPECT_EQ(a * b - 1.0 * 1.0, 0.0);  // the control: 1 - 2^-60 rounds to 1
  EXPECT_EQ(difference_of_products(a, b, 1.0, 1.0), -0x1p-60);
}

}  // namespace
}  // namespace litmus

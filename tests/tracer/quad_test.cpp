#include "tracer/quad.h"

#include <gtest/gtest.h>

namespace litmus {
namespace {

using Limits = std::numeric_limits<Quad>;

TEST(Quad, HoldsExactly113Bits) {
  EXPECT_GT(1 + Limits::epsilon(), Quad(1));
  EXPECT_EQ(1 + Limits::epsilon() / 2, Quad(1));
  EXPECT_EQ(ldexp(Quad(1), 1 - Limits::digits), Limits::epsilon());
}

TEST(Quad, HasTheRangeOfLongDouble) {
  EXPECT_EQ(Limits::max() * 2, Limits::infinity());
  EXPECT_EQ(ldexp(Quad(0.5), Limits::min_exponent), Limits::min());
  EXPECT_EQ(Quad(std::numeric_limits<long double>::min()), Limits::min());
  EXPECT_GT(Limits::max(), Quad(std::numeric_limits<long double>::max()));
}

TEST(Quad, IsNotOrderedWithWhatIsNotANumber) {
  const Quad nan = Limits::quiet_NaN();
  EXPECT_FALSE(nan < 1 || nan > 1 || nan == nan);
  EXPECT_TRUE(nan != nan);
}

TEST(Quad, RoundsToDoubleAndTowardsZeroToIntegers) {
  EXPECT_EQ(double(1 + Limits::epsilon()), 1.0);
  EXPECT_EQ(int(Quad(-2.75)), -2);
}

TEST(Quad, FunctionsUndoEachOtherTo33Digits) {
  const Quad x = Quad(7) / 5, least = 16 * Limits::epsilon();
  EXPECT_LT(abs(exp(log(x)) - x), least);
  EXPECT_LT(abs(log1p(expm1(x)) - x), least);
  EXPECT_LT(abs(sqrt(x) * sqrt(x) - x), least);
  EXPECT_LT(abs(atan2(sin(x), cos(x)) - x), least);
  EXPECT_LT(abs(tan(x) * cos(x) - sin(x)), least);
}

}  // namespace
}  // namespace litmus

// vector_math_test.cpp: the functions' errors against quad precision, and packets against scalars.
#include "tracer/vector_math.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/tracer/ulp.h"
#include "tracer/twin.h"

namespace litmus {
namespace {

template <class R>
class VectorMath : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(VectorMath, Scalars);

constexpr int kSamples = 50000;

/// The largest error of ours(x) in ulp for x = draw(0..1), where the true value is a normal number.
template <class R, class Draw, class Ours, class Exact>
double largest_error(Draw draw, Ours ours, Exact exact) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  double largest = 0;
  for (int i = 0; i < kSamples; ++i) {
    const R x = R(draw(uniform(random)));
    largest = std::max(largest, error_in_ulp<R>(ours(x), exact(Quad(x))));
  }
  return largest;
}

TYPED_TEST(VectorMath, ExponentialIsRightToOneUlp) {
  using R = TypeParam;
  const double most = std::is_same_v<R, float> ? 87 : 708;
  const auto exact = [](const Quad& x) { return exp(x); };
  EXPECT_LE(largest_error<R>([&](double u) { return most * (2 * u - 1); }, exp_of<R>, exact), 1);
  EXPECT_LE(largest_error<R>([&](double u) { return -u * u * u; }, exp_of<R>, exact), 1);
}

TYPED_TEST(VectorMath, ExponentialUnderflowsGraduallyAndOverflowsToInfinity) {
  using R = TypeParam;
  const R least = std::numeric_limits<R>::denorm_min(),
          infinity = std::numeric_limits<R>::infinity();
  EXPECT_EQ(exp_of(std::log(least) + R(0.1)), least);
  EXPECT_EQ(exp_of(-infinity), R(0));
  EXPECT_EQ(exp_of(R(-1e30)), R(0));
  EXPECT_EQ(exp_of(infinity), infinity);
  EXPECT_EQ(exp_of(R(0)), R(1));
  EXPECT_TRUE(std::isnan(exp_of(std::numeric_limits<R>::quiet_NaN())));
}

TYPED_TEST(VectorMath, ExponentialLessOneIsRightToItsBound) {
  using R = TypeParam;
  const auto exact = [](const Quad& x) { return expm1(x); };
  for (const double most : {1e-6, 0.3, 1.0, 3.0, 80.0}) {
    EXPECT_LE(largest_error<R>([&](double u) { return -most * u; }, expm1_of<R>, exact), 1.2)
        << most;
  }
  EXPECT_EQ(expm1_of(R(0)), R(0));
  EXPECT_EQ(expm1_of(-std::numeric_limits<R>::infinity()), R(-1));
}

TYPED_TEST(VectorMath, LogarithmIsRightToOneUlp) {
  using R = TypeParam;
  const auto exact = [](const Quad& x) { return log(x); };
  const double least = std::numeric_limits<R>::min_exponent - 20;  // subnormals are among them
  const double most = std::numeric_limits<R>::max_exponent;
  const auto wide = [&](double u) { return std::exp2(least + (most - least) * u); };
  EXPECT_LE(largest_error<R>(wide, log_of<R>, exact), 1);
  EXPECT_LE(largest_error<R>([](double u) { return 0.5 + u; }, log_of<R>, exact), 1);
  EXPECT_EQ(log_of(R(1)), R(0));
  EXPECT_EQ(log_of(R(0)), -std::numeric_limits<R>::infinity());
  EXPECT_LE(error_in_ulp<R>(log_of(std::numeric_limits<R>::denorm_min()),
                            log(Quad(std::numeric_limits<R>::denorm_min()))),
            1);
}

TYPED_TEST(VectorMath, LogarithmOfOneMoreIsRightToOneUlp) {
  using R = TypeParam;
  const auto exact = [](const Quad& x) { return log1p(x); };
  EXPECT_LE(largest_error<R>([](double u) { return -u; }, log1p_of<R>, exact), 1);
  EXPECT_LE(largest_error<R>([](double u) { return u; }, log1p_of<R>, exact), 1);
  EXPECT_LE(largest_error<R>([](double u) { return -std::exp2(-60 * u); }, log1p_of<R>, exact), 1);
  EXPECT_EQ(log1p_of(R(0)), R(0));
  EXPECT_EQ(log1p_of(R(-1)), -std::numeric_limits<R>::infinity());
}

/// What a sum of two numbers adds to x: less than half a unit in its last place.
template <class V>
V low_part(const V& x) {
  return x * (kUnit<Scalar<V>> * Scalar<V>(0.7));
}

TYPED_TEST(VectorMath, LogarithmOfASumIsRightToOneUlp) {
  using R = TypeParam;
  const auto ours = [](R x) { return log_of_sum(x, low_part(x)); };
  const auto exact = [](const Quad& x) { return log(x + Quad(low_part(R(x)))); };
  EXPECT_LE(largest_error<R>([](double u) { return 1 - u; }, ours, exact), 1);
  EXPECT_LE(largest_error<R>([](double u) { return std::exp2(-60 * u); }, ours, exact), 1);
  EXPECT_EQ(log_of_sum(R(1), R(-1e-20)), R(-1e-20));
}

TYPED_TEST(VectorMath, CompensatedDotProductKeepsItsDigitsWhereThePlainOneLosesThem) {
  using R = TypeParam;
  double largest = 0, plain = 0;
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < kSamples; ++i) {
    const Vec<R> a{R(uniform(random)), R(uniform(random)), R(uniform(random))};
    Vec<R> b{R(uniform(random)), R(uniform(random)), R(0)};
    b.z = R((uniform(random) / 1000 - a.x * b.x - a.y * b.y) / a.z);
    const Quad exact = Quad(a.x) * Quad(b.x) + Quad(a.y) * Quad(b.y) + Quad(a.z) * Quad(b.z);
    largest = std::max(largest, error_in_ulp<R>(compensated_dot(a, b).value, exact));
    plain = std::max(plain, error_in_ulp<R>(dot(a, b), exact));
  }
  EXPECT_LE(largest, 1);
  EXPECT_GT(plain, 100);
}

TYPED_TEST(VectorMath, ArcTangentIsRightInBothQuadrants) {
  using R = TypeParam;
  const double pi = std::numbers::pi;
  for (const double least : {1e-30, 0.1, 3.0}) {  // small angles, and those near pi
    double largest = 0;
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < kSamples; ++i) {
      const double angle = least < 1 ? least * std::pow(pi / least, uniform(random))
                                     : least + (pi - least) * uniform(random);
      const R y = R(3 * std::sin(angle)), x = R(3 * std::cos(angle));
      largest = std::max(largest, error_in_ulp<R>(atan2_of(y, x), atan2(Quad(y), Quad(x))));
    }
    EXPECT_LE(largest, 1.4) << least;
  }
}

TYPED_TEST(VectorMath, ArcTangentKnowsItsCorners) {
  using R = TypeParam;
  EXPECT_EQ(atan2_of(R(0), R(2)), R(0));
  EXPECT_EQ(atan2_of(R(0), R(0)), R(0));
  EXPECT_EQ(atan2_of(R(0), R(-2)), std::numbers::pi_v<R>);
  EXPECT_EQ(atan2_of(R(2), R(0)), std::numbers::pi_v<R> / 2);
  EXPECT_EQ(atan2_of(R(2), R(2)), std::numbers::pi_v<R> / 4);
}

/// Whether a packet P of the numbers draw(0..1) has the bits of the scalars.
template <class P, class Draw, class Function>
void expect_same_bits_in(Draw draw, Function function) {
  using R = Scalar<P>;
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < kSamples; i += kLanes<P>) {
    P x;
    for (int k = 0; k < kLanes<P>; ++k) set_lane(x, k, R(draw(uniform(random))));
    const P y = function(x);
    for (int k = 0; k < kLanes<P>; ++k) {
      ASSERT_EQ(bits_of(lane(y, k)), bits_of(function(lane(x, k)))) << lane(x, k);
    }
  }
}

template <class R, class Draw, class Function>
void expect_same_bits(Draw draw, Function function) {
  expect_same_bits_in<NativePacket<R>>(draw, function);
  expect_same_bits_in<Twin<NativePacket<R>>>(draw, function);
}

TYPED_TEST(VectorMath, OfAPacketHasTheBitsOfTheScalars) {
  using R = TypeParam;
  expect_same_bits<R>([](double u) { return 800 * (2 * u - 1); }, [](auto x) { return exp_of(x); });
  expect_same_bits<R>([](double u) { return -4 * u; }, [](auto x) { return expm1_of(x); });
  expect_same_bits<R>([](double u) { return std::exp2(300 * u - 150); },
                      [](auto x) { return log_of(x); });
  expect_same_bits<R>([](double u) { return -u; }, [](auto x) { return log1p_of(x); });
  expect_same_bits<R>([](double u) { return 1 - u; },
                      [](auto x) { return log_of_sum(x, low_part(x)); });
  expect_same_bits<R>([](double u) { return 8 * u - 4; },
                      [](auto x) {
                        return compensated_dot<decltype(x)>({x, x, x}, {x, -x, x}).rest;
                      });
  expect_same_bits<R>([](double u) { return 8 * u - 4; },
                      [](auto x) { return atan2_of(decltype(x)(x * x), x); });
}

}  // namespace
}  // namespace litmus

// shade_test.cpp: slide 5 against closed forms.
#include "tracer/shade.h"

#include <gtest/gtest.h>

namespace litmus {
namespace {

using V = Vec<double>;
const V kUp{0, 0, 1};

V tilted(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

TEST(SpecularPower, IsOneAtTheMirrorDirection) {
  for (const double shininess : {1.0, 32.0, 1e6}) {
    EXPECT_NEAR(specular_power(tilted(0.4), tilted(-0.4), kUp, shininess), 1, 1e-9);
    EXPECT_LE(specular_power(tilted(0.4), tilted(-0.4), kUp, shininess), 1.0);
  }
}

TEST(SpecularPower, IsTheCosineOfTheHalfVectorToItsPower) {
  for (const double shininess : {0.5, 7.3, 80.0}) {
    EXPECT_NEAR(specular_power(tilted(0.5), tilted(0.1), kUp, shininess),
                std::pow(std::cos(0.3), shininess), 1e-14);
  }
}

TEST(SpecularPower, IsZeroForAHalfVectorBehindTheSurface) {
  EXPECT_EQ(specular_power(-kUp, tilted(2.0), kUp, 7.3), 0.0);
}

TEST(SpecularPower, IsZeroWhereTheEyeLooksStraightIntoTheLight) {
  EXPECT_EQ(specular_power(tilted(0.3), -tilted(0.3), kUp, 2.0), 0.0);
}

TEST(SpecularPower, OfShininessZeroIsOne) {
  EXPECT_EQ(specular_power(tilted(0.5), tilted(0.1), kUp, 0.0), 1.0);
}

TEST(SpecularPower, KeepsItsDigitsForALargeShininess) {
  const float angle = 1e-3f, shininess = 1e6f;
  const Vec<float> l{std::sin(angle), 0, std::cos(angle)}, e{-0.0f, 0, 1}, n{0, 0, 1};
  const double exact = std::exp(1e6 * std::log(std::cos(0.5e-3)));
  const Vec<float> h = normalize(l + e);
  EXPECT_GT(std::fabs(std::pow(dot(h, n), shininess) - exact),
            1e-3);  // the control: pow of a rounded cosine
  EXPECT_NEAR(specular_power(l, e, n, shininess), exact, 1e-6);
}

TEST(SpecularPower, KeepsItsDigitsFarFromABroadPeak) {
  double largest = 0, largest_by_difference = 0;
  for (int i = 0; i < 2000; ++i) {
    const double turn = 0.001 * i;  // so that no component is 0
    const V n{std::sin(turn), 0, std::cos(turn)};
    const V h{-std::sin(1.42 - turn), 0, std::cos(1.42 - turn)};
    const V apart = n - h;
    const auto exact = [](const V& v) { return Vec<Quad>{Quad(v.x), Quad(v.y), Quad(v.z)}; };
    const Quad cosine =
        dot(exact(h), exact(n)) / sqrt(dot(exact(h), exact(h)) * dot(exact(n), exact(n)));
    const double by_difference = std::exp(std::log1p(-dot(apart, apart) / 2));
    largest = std::max(largest, double(fabs(Quad(power_of_cosine(h, n, 1.0)) / cosine - 1)));
    largest_by_difference =
        std::max(largest_by_difference, double(fabs(Quad(by_difference) / cosine - 1)));
  }
  const double unit = std::numeric_limits<double>::epsilon();
  EXPECT_LE(largest, 3 * unit);
  EXPECT_GT(largest_by_difference, 5 * unit);  // the control: 1 - |n - h|^2 / 2 everywhere
}

TEST(EquationTerms, AreNothingForALightBehindTheSurface) {
  const V l = tilted(1.6), e = tilted(-1.0);
  const auto terms = equation_terms(dot(l, kUp), specular_power(l, e, kUp, 10.0), 1.0);
  EXPECT_EQ(terms.diffuse, 0.0);
  EXPECT_EQ(terms.specular, 0.0);
}

TEST(SampleCodeTerms, KeepTheHighlightOfALightBehindTheSurface) {
  const V l = tilted(1.6), e = tilted(-1.0);
  const auto terms = sample_code_terms(dot(l, kUp), specular_power(l, e, kUp, 10.0), 1.0);
  EXPECT_EQ(terms.diffuse, 0.0);
  EXPECT_NEAR(terms.specular, std::pow(std::cos(0.3), 10), 1e-14);
}

TEST(Reflected, AddsDiffuseAndSpecular) {
  EXPECT_DOUBLE_EQ(reflected(Terms<double>{0.5, 0.25}, 0.8, 2.0, 0.4, 3.0), 0.5 * 1.6 + 0.25 * 1.2);
}

}  // namespace
}  // namespace litmus

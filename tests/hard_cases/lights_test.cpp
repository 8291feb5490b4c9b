// lights_test.cpp: hard cases of lights (L), of Blinn-Phong (B) and of area lights (A) that no
// other test has; docs/hard-cases.md lists all.
#include "tracer/lights.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <thread>

#include "stress/naive.h"
#include "stress/random.h"
#include "stress/ulp.h"
#include "tests/tracer/scenes.h"
#include "tracer/render.h"
#include "tracer/shade.h"

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace litmus {
namespace {

constexpr double kPi = std::numbers::pi;
using V = Vec<double>;

V at_angle(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

Quad exact_decay(double alpha, double cutoff, double exponent) {
  return -expm1(Quad(exponent) * log(Quad(alpha) / Quad(cutoff)));
}

double center_of(const Scene& scene) {
  return render(scene).whole.at(scene.width / 2, scene.height / 2).x;
}

TEST(HardCaseL03, AnAngleNearPiKeepsItsDigits) {
  for (const double off : {1e-3, 1e-6, 1e-9}) {
    const V a{0, 0, 1}, b{std::sin(off), 0, -std::cos(off)};
    const Quad truth = atan2(Quad(b.x), Quad(b.z));
    EXPECT_LE(ulps(angle_between(a, b), truth), 1.5) << off;
  }
}

TEST(HardCaseL04, AnAxisOfAnyPowerOfTwoHasTheSameAngle) {
  const V axis{0.3, -0.2, -0.9}, to{0.1, 0.4, -2};
  const double expected = angle_between(axis, to);
  for (int k = -20; k <= 20; ++k)
    EXPECT_EQ(angle_between(std::ldexp(1.0, k) * axis, std::ldexp(1.0, -k) * to), expected) << k;
}

TEST(HardCaseL05, ASpotOfATenthOfADegreeIsRightToAMillionthInFloat) {
  const float cutoff = float(0.1 * kPi / 180);
  double robust = 0, usual = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Draw draw(5, i);
    const V axis = draw.direction(), side = draw.across(axis);
    const double alpha = draw.uniform(0, double(cutoff));
    const V to = std::cos(alpha) * axis + std::sin(alpha) * side;
    const Vec<float> a{float(axis.x), float(axis.y), float(axis.z)},
        b{float(to.x), float(to.y), float(to.z)};
    const V qa{a.x, a.y, a.z}, qb{b.x, b.y, b.z};
    const double truth = std::max(0.0, 1 - angle_between(qa, qb) / double(cutoff));
    robust =
        std::max(robust, std::fabs(double(spot_decay(angle_between(a, b), cutoff, 1.0f)) - truth));
    const float naive = naive::spot_decay(naive::angle_between(a, b), cutoff, 1.0f);
    if (!(std::fabs(double(naive) - truth) <= usual))
      usual = std::isnan(naive) ? 1 : std::fabs(double(naive) - truth);
  }
  EXPECT_LE(robust, 1e-6);
  EXPECT_GT(usual, 0.01);  // the control
}

TEST(HardCaseL08, OneUnitInsideTheCutoffIsSmallAndPositive) {
  for (const double exponent : {1e-6, 1.0, 1e3}) {
    const double inside = std::nextafter(0.4, 0.0);
    EXPECT_GT(spot_decay(inside, 0.4, exponent), 0.0) << exponent;
    EXPECT_LE(ulps(spot_decay(inside, 0.4, exponent), exact_decay(inside, 0.4, exponent)), 4);
    EXPECT_EQ(spot_decay(std::nextafter(0.4, 1.0), 0.4, exponent), 0.0);
  }
}

TEST(HardCaseL11, AHugeExponentIsOneInsideTheCutoff) {
  for (const double exponent : {1e6, 1e30, 1e300}) {
    EXPECT_EQ(spot_decay(0.2, 0.4, exponent), 1.0);
    EXPECT_EQ(spot_decay(0.4, 0.4, exponent), 0.0);
  }
  EXPECT_LE(ulps(spot_decay(0.39999, 0.4, 1e6), exact_decay(0.39999, 0.4, 1e6)), 4);
}

TEST(HardCaseL13, ACutoffOfNinetyDegreesLightsTheHemisphere) {
  Lamp<double> spot;
  spot.cone = true, spot.axis = {0, 0, -1}, spot.cutoff = kPi / 2, spot.exponent = 2;
  EXPECT_GT(incident(spot, V{1, 0, -1e-9}).intensity, 0.0);
  EXPECT_EQ(incident(spot, V{1, 0, 1e-9}).intensity, 0.0);
}

TEST(HardCaseL14, ACutoffBeyondNinetyDegreesIsFiniteUpToPi) {
  for (const double cutoff : {kPi * 2 / 3, kPi}) {
    Lamp<double> spot;
    spot.cone = true, spot.axis = {0, 0, -1}, spot.cutoff = cutoff, spot.exponent = 1;
    EXPECT_NEAR(incident(spot, V{1, 0, 0}).intensity, 1 - kPi / 2 / cutoff, 1e-15);
    EXPECT_EQ(incident(spot, V{0, 0, 1}).intensity, 0.0);  // straight behind: alpha = pi
  }
}

TEST(HardCaseL16, ALightOnAPointThatIsSeenAddsNothingThere) {
  Scene scene = floor_from_above(17);
  scene.ambient = Color(0.25);
  scene.lights = {bulb({0, 0, 0}, {1, 1, 1})};
  EXPECT_EQ(center_of(scene), 0.25);
}

TEST(HardCaseL18, ALightOneToTheThirtyAwayHasADirection) {
  Lamp<float> lamp;
  lamp.origin = {3e29f, 0, 4e29f};
  lamp.attenuated = true, lamp.quadratic = 1;
  const auto light = incident(lamp, Vec<float>{});
  EXPECT_FLOAT_EQ(light.direction.x, 0.6f);
  EXPECT_EQ(light.intensity, 0.0f);
}

TEST(HardCaseL20, NoAssociationOverflowsWhereTheOtherDoesNot) {
  const float x = 1e25f;
  EXPECT_TRUE(std::isnan(0.0f * (x * x)));  // the control: 1 + Q (x x) for Q = 0
  EXPECT_EQ(quadratic_attenuation(x, 0.0f), 1.0f);
  EXPECT_FLOAT_EQ(quadratic_attenuation(x, 1e-30f) * 1e20f, 1.0f);
}

TEST(HardCaseL24, AHugeCoefficientIsDarkExceptAtTheLight) {
  EXPECT_EQ(quadratic_attenuation(0.0, 1e300), 1.0);
  EXPECT_EQ(quadratic_attenuation(1e300, 1e300), 0.0);
  EXPECT_EQ(linear_attenuation(0.0f, 1e38f), 1.0f);
  EXPECT_LT(linear_attenuation(1.0f, 1e38f), 1e-37f);
}

TEST(HardCaseL26, TheProductOfBothAttenuationsIsWithinSevenUnits) {
  double worst = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Draw draw(26, i);
    const double x = draw.decades(1e-10, 1e10), l = draw.decades(1e-3, 1e3),
                 q = draw.decades(1e-3, 1e3);
    const Quad truth = 1 / ((1 + Quad(l) * x) * (1 + Quad(q) * x * x));
    worst = std::max(worst, ulps(linear_attenuation(x, l) * quadratic_attenuation(x, q), truth));
  }
  EXPECT_LE(worst, 7);
}

TEST(HardCaseL27, InThePracticalRangeTheSlidesFormIsAsGood) {
  double robust = 0, slides = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Draw draw(27, i);
    const double range = draw.decades(1e-3, 1e6), d = draw.decades(1e-6, 1e7), q = draw.uniform();
    const Quad r(range), truth = r * r / (r * r + Quad(q) * d * d);
    robust = std::max(robust, ulps(quadratic_attenuation(d / range, q), truth));
    slides = std::max(slides, ulps(naive::quadratic_attenuation(range, d, q), truth));
  }
  EXPECT_LE(robust, 5);
  EXPECT_LE(slides, 5);  // the rearrangement buys range, not digits
}

TEST(HardCaseL29, AColourOverOneIsNotClamped) {
  Scene scene = floor_from_above(3);
  scene.lights = {sun({0, 0, -1})};
  scene.lights[0].diffuse = Color(1e4);
  EXPECT_EQ(center_of(scene), 0.8 * 1e4);
}

TEST(HardCaseL30, ASunOfAnyPowerOfTwoIsTheSameSun) {
  Scene scene = floor_from_above(3);
  scene.lights = {sun({0.3, -0.2, -0.7})};
  const double expected = center_of(scene);
  for (const int k : {-300, -40, 40, 300}) {
    scene.lights = {sun(std::ldexp(1.0, k) * Vector(0.3, -0.2, -0.7))};
    EXPECT_EQ(center_of(scene), expected) << k;
  }
}

TEST(HardCaseB01, ANegativeBaseOfAFractionalPowerIsNoNumberAndNotUsed) {
  const V l = at_angle(2.4), e = at_angle(1.5), n{0, 0, 1};
  const V h = normalize(l + e);
  ASSERT_LT(dot(h, n), 0);
  EXPECT_TRUE(std::isnan(naive::specular_power(h, n, 7.3)));  // the control
  EXPECT_EQ(specular_power(l, e, n, 7.3), 0.0);
}

TEST(HardCaseB03, ShininessZeroIsGatedToo) {
  const V n{0, 0, 1};
  const auto specular = [&](const V& l) {
    return equation_terms(dot(l, n), specular_power(l, at_angle(-1), n, 0.0), 1.0).specular;
  };
  EXPECT_EQ(specular(at_angle(1.6)), 0.0);
  EXPECT_EQ(specular(at_angle(1.5)), 1.0);
}

TEST(HardCaseB05, AnUnderflowingPowerIsNothing) {
  const V n{0, 0, 1}, h = at_angle(kPi / 3);
  const double plain = power_of_cosine(h, n, 1e6);
  EXPECT_LE(plain, 1e-300);
#if defined(__x86_64__)
  double flushed = 1;
  std::thread([&] {
    _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, subnormals are zero
    flushed = power_of_cosine(h, n, 1e6);
  }).join();
  EXPECT_NEAR(flushed, plain, 1e-30);
#endif
}

TEST(HardCaseB06, NoHighlightIsAboveOne) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Draw draw(6, i);
    const V d = draw.direction();
    const Vec<float> n = normalize(Vec<float>{float(d.x), float(d.y), float(d.z)});
    ASSERT_LE(power_of_cosine(n, n, 1e6f), 1.0f);
    ASSERT_EQ(power_of_cosine(n, n, 1e6f), 1.0f);
  }
}

TEST(HardCaseB08, AnEyeAlmostOppositeTheLightIsFinite) {
  for (const double off : {1e-5, 1e-8, 1e-12, 1e-16}) {
    const double s = specular_power(at_angle(0.3), -at_angle(0.3 + off), V{0, 0, 1}, 50.0);
    EXPECT_TRUE(s >= 0 && s <= 1) << off;
  }
}

TEST(HardCaseB09, GrazingLightIsNeverNegative) {
  for (const double height : {1e-8, 1e-12, 1e-16, 0.0, -0.0, -1e-16}) {
    const V l = normalize(V{1, 0, height}), n{0, 0, 1};
    const auto terms = equation_terms(dot(l, n), specular_power(l, n, n, 5.0), 1.0);
    EXPECT_GE(terms.diffuse, 0.0) << height;
    EXPECT_EQ(terms.diffuse > 0, height > 0) << height;
  }
}

TEST(HardCaseB10, ANormalOfAnyLengthGivesTheSamePicture) {
  Scene scene = floor_from_above(5);
  scene.lights = {bulb({0.3, 0.2, 1})};
  const auto expected = render(scene).whole.pixels;
  std::get<Plane>(scene.objects[0].shape).normal = {0, 0, 3};
  EXPECT_EQ(render(scene).whole.pixels, expected);
}

TEST(HardCaseB15, NoLightPassesWhereTheTwoNormalsDisagree) {
  Scene scene = seen_from_above(5);
  // A face that looks up with normals that lean over by 80 degrees, lit from the side below it.
  const Vector lean{std::sin(1.4), 0, std::cos(1.4)};
  scene.objects.push_back(
      {"face", Mesh{{{-5, -5, 0}, {5, -5, 0}, {0, 9, 0}}, {lean, lean, lean}, {{0, 1, 2}}}, 0,
       true});
  scene.lights = {sun(-Vector(std::sin(1.7), 0, std::cos(1.7)))};
  EXPECT_EQ(center_of(scene), 0.0);
  scene.lights = {sun(-Vector(std::sin(1.5), 0, std::cos(1.5)))};
  EXPECT_GT(center_of(scene), 0.7);  // the control: above the face, the interpolated normal shades
}

TEST(HardCaseA04, RightSwingsByNinetyDegreesNearThePole) {
  AreaLight x, y;
  x.normal = Vector(1e-6, 0, 1), y.normal = Vector(0, 1e-6, 1);
  EXPECT_EQ(area_frame<double>(x).right, (V{0, 1, 0}));
  EXPECT_EQ(area_frame<double>(y).right, (V{-1, 0, 0}));
}

TEST(HardCaseA08, ALineOfLightsIsSymmetricAboutItsCentre) {
  AreaLight line;
  line.point.origin = {0, 0, 2}, line.normal = Vector(0, 0, -1);
  line.width = 3, line.height = 1, line.columns = 1, line.rows = 64;
  const auto samples = area_samples<double>(line);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].x, 0.0);
    EXPECT_EQ(samples[i].y, -samples[samples.size() - 1 - i].y);
  }
}

TEST(HardCaseA09, AnAreaLightOfSizeZeroIsAPointLight) {
  Scene scene = floor_from_above(9);
  scene.lights = {bulb({0.4, -0.3, 1.7}, {2, 0.5, 0.25})};
  const auto point = render(scene).whole.pixels;
  AreaLight area;
  area.point = {{0.4, -0.3, 1.7}, {2, 0.5, 0.25}}, area.normal = Vector(0, 0.6, -0.8);
  area.width = area.height = 0, area.columns = area.rows = 3;
  scene.lights = {make_light(area)};
  const auto pixels = render(scene).whole.pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i) ASSERT_NEAR(pixels[i].x, point[i].x, 1.2e-16);
}

TEST(HardCaseA13, SamplesBelowTheSurfaceAddNothing) {
  Scene scene = floor_from_above(9);
  AreaLight area;
  area.point.origin = {0.05, 0.03, 0}, area.normal = Vector(1, 0, 0);
  area.width = area.height = 2, area.columns = 2, area.rows = 2;
  scene.lights = {make_light(area)};
  // Two samples are above the floor; the others, mirrored, are below.
  Scene above = scene;
  above.lights.clear();
  for (const V& s : area_samples<double>(area))
    if (s.z > 0) above.lights.push_back(bulb({s.x, s.y, s.z}));
  ASSERT_EQ(above.lights.size(), 2u);
  const auto all = render(scene).whole.pixels, upper = render(above).whole.pixels;
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_NEAR(4 * all[i].x, upper[i].x, 1e-15);
}

TEST(HardCaseA14, AnyGridConservesTheIntensity) {
  for (const int n : {1, 3, 7, 49, 64}) {
    Scene scene = floor_from_above(3);
    AreaLight area;
    area.point.origin = {0, 0, 2}, area.normal = Vector(0, 0, -1);
    area.width = area.height = 0, area.columns = area.rows = n;
    scene.lights = {make_light(area)};
    EXPECT_NEAR(center_of(scene), 0.8, 2e-16) << n;
  }
}

}  // namespace
}  // namespace litmus

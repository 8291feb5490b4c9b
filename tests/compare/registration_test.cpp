// registration_test.cpp: shifts that are known exactly, and differences that are no shift.
#include "compare/registration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/exponential.hpp>
#include <limits>

namespace litmus {
namespace {
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Field = std::function<glm::dvec3(double x, double y)>;

/// A field at the pixels' centres, x to the right and y down, moved by (dx, dy).
Picture picture_of(const Field& field, double dx = 0, double dy = 0, int width = 96,
                   int height = 72) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) picture.at(x, y) = field(x - dx, y - dy);
  return picture;
}

/// Two pools of light, one higher than wide.
glm::dvec3 pools(double x, double y) {
  const double a = std::exp(-((x - 30) * (x - 30) + (y - 40) * (y - 40)) / 300);
  const double b = std::exp(-((x - 62) * (x - 62) / 200 + (y - 25) * (y - 25) / 500));
  return {0.1 + 0.8 * a + 0.1 * b, 0.1 + 0.3 * a + 0.4 * b, 0.2 * a + 0.9 * b};
}

glm::dvec3 disc(double x, double y) {
  const double u = (x - 47.3) / 25, v = (y - 35.8) / 25, z2 = 1 - u * u - v * v;
  return z2 > 0 ? glm::dvec3(0.2 + 0.3 * u - 0.4 * v + 0.5 * std::sqrt(z2)) : glm::dvec3(0.15);
}

/// 1 beside the disc's outline, as by a signature.
std::vector<std::uint8_t> outline(const Picture& picture, double dx) {
  std::vector<std::uint8_t> edge;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      edge.push_back(std::fabs(std::hypot(x - dx - 47.3, y - 35.8) - 25) < 1.5);
  return edge;
}

TEST(Registration, OfEqualPicturesIsNoShift) {
  const Picture picture = picture_of(pools);
  const Registration r = registration(picture, picture);
  EXPECT_TRUE(r.determined) << r.why;
  EXPECT_LT(std::hypot(r.dx, r.dy), 1e-6);
  EXPECT_NEAR(r.scale, 1, 1e-6);
  EXPECT_EQ(unregistered(r), "");
}

TEST(Registration, FindsShiftsToAHundredthOfAPixelAndCallsThoseOverAFiftieth) {
  for (const double length : {0.5, 0.03, 0.01})
    for (const double angle : {0.0, 0.8, 2.5, 4.0}) {
      const double dx = length * std::cos(angle), dy = length * std::sin(angle);
      const Registration r = registration(picture_of(pools, dx, dy), picture_of(pools));
      EXPECT_TRUE(r.determined) << r.why;
      EXPECT_NEAR(r.dx, dx, 1e-3);
      EXPECT_NEAR(r.dy, dy, 1e-3);
      EXPECT_GT(r.explained, 0.99);
      EXPECT_EQ(unregistered(r).empty(), length < 0.02) << length;
    }
}

TEST(Registration, SaysWhichWayOursIsMoved) {
  EXPECT_THAT(unregistered(registration(picture_of(pools, -0.5, 0), picture_of(pools))),
              StartsWith("unregistered: shifted by (-0.5, 0) px"));
  EXPECT_THAT(unregistered(registration(picture_of(pools, 0, 0.25), picture_of(pools))),
              StartsWith("unregistered: shifted by (0, 0.25) px"));
}

TEST(Registration, FindsShiftsOfSeveralPixels) {
  const Registration r = registration(picture_of(pools, 4.3, -2.6), picture_of(pools));
  EXPECT_NEAR(r.dx, 4.3, 1e-2);
  EXPECT_NEAR(r.dy, -2.6, 1e-2);
  EXPECT_NE(unregistered(r), "");
}

TEST(Registration, IsNotMisledByGainAndOffsetPerChannel) {
  Picture ours = picture_of(pools, 0.03, 0);
  for (glm::dvec3& p : ours.pixels) p = glm::dvec3(1.3, 0.9, 0.3) * p + glm::dvec3(0.05, 0, 0.1);
  const Registration r = registration(ours, picture_of(pools));
  EXPECT_NEAR(r.dx, 0.03, 1e-3);
  EXPECT_NE(unregistered(r), "");
}

TEST(Registration, UsesPiecesBetweenHardEdges) {
  const Picture ours = picture_of(disc, 0.5, 0);
  const Registration r = registration(ours, picture_of(disc), outline(ours, 0.5));
  EXPECT_NEAR(r.dx, 0.5, 1e-3);
  EXPECT_NEAR(r.dy, 0, 1e-3);
  EXPECT_NE(unregistered(r), "");
}

TEST(Registration, FindsHalfAPixelUnderAByteOfQuantisation) {
  Picture ours = picture_of(pools, -0.5, 0), theirs = picture_of(pools);
  for (glm::dvec3& p : theirs.pixels)
    for (int c = 0; c < 3; ++c) p[c] = std::round(p[c] * 255) / 255;
  const Registration r = registration(ours, theirs, {}, 1 / (255 * std::sqrt(12.0)));
  EXPECT_NEAR(r.dx, -0.5, 1e-2);
  EXPECT_NE(unregistered(r), "");
}

TEST(Registration, SkipsPixelsThatAreNotFinite) {
  Picture ours = picture_of(pools, 0.03, 0), theirs = picture_of(pools);
  ours.at(30, 30).x = std::numeric_limits<double>::quiet_NaN();
  theirs.at(50, 40) = glm::dvec3(std::numeric_limits<double>::infinity());
  const Registration r = registration(ours, theirs);
  EXPECT_NEAR(r.dx, 0.03, 1e-3);
  EXPECT_NE(unregistered(r), "");
}

TEST(Registration, ReportsAScale) {
  const Field larger = [](double x, double y) {
    return pools(47.5 + (x - 47.5) / 1.01, 35.5 + (y - 35.5) / 1.01);
  };
  EXPECT_NEAR(registration(picture_of(larger), picture_of(pools)).scale, 1.01, 2e-4);
}

TEST(Registration, IsNotDeterminedByPicturesThatDoNotSay) {
  const auto of = [](const Field& field) {
    return registration(picture_of(field, 0.5, 0), picture_of(field));
  };
  const Registration constant = of([](double, double) { return glm::dvec3(0.4); });
  EXPECT_FALSE(constant.determined);
  EXPECT_THAT(constant.why, HasSubstr("nothing changes"));
  const Registration ramp = of([](double x, double y) { return glm::dvec3(0.01 * x + 0.02 * y); });
  EXPECT_FALSE(ramp.determined);  // an offset does the same
  EXPECT_THAT(ramp.why, HasSubstr("offset"));
  const Registration stripes = of([](double x, double) { return glm::dvec3(std::sin(0.2 * x)); });
  EXPECT_FALSE(stripes.determined);
  EXPECT_THAT(stripes.why, HasSubstr("one direction only"));
  EXPECT_EQ(unregistered(stripes), "");
}

TEST(Registration, CannotTellFromFlatFacets) {
  // Each of 8 x 8 pixels: half a pixel moves no pixel's centre out of most of them.
  const Field facets = [](double x, double y) {
    const double column = std::floor((x + 0.3) / 8), row = std::floor((y + 0.3) / 8);
    return glm::dvec3(0.5 + 0.4 * std::sin(1.7 * column + 0.9 * row));
  };
  for (const double shift : {0.0, 0.2}) {
    const Registration r = registration(picture_of(facets, shift, 0), picture_of(facets));
    EXPECT_FALSE(r.determined) << shift;
    EXPECT_THAT(r.why, HasSubstr("creases between flat pieces")) << shift;
  }
}

TEST(Registration, IsNotDeterminedBetweenSizesOrWithoutSmoothPixels) {
  EXPECT_THAT(registration(picture_of(pools), picture_of(pools, 0, 0, 96, 71)).why,
              HasSubstr("differ in size"));
  const Picture picture = picture_of(pools);
  const std::vector<std::uint8_t> all(picture.pixels.size(), 1);
  EXPECT_THAT(registration(picture, picture, all).why, HasSubstr("0 pixels are smooth"));
  EXPECT_FALSE(registration({}, {}).determined);
}

/// Our side has a mistake that is no shift.
void expect_no_shift(const Field& mistaken) {
  const Registration r = registration(picture_of(mistaken), picture_of(pools));
  EXPECT_EQ(unregistered(r), "") << r.explained;
}

TEST(Unregistered, IsNeverSaidOfAMistakeInTheShading) {
  expect_no_shift([](double x, double y) { return 1.01 * pools(x, y) + 0.015; });
  expect_no_shift([](double x, double y) { return glm::pow(pools(x, y), glm::dvec3(1.03)); });
  // One of the two lamps is 0.3 pixels off.
  expect_no_shift([](double x, double y) {
    const double b = std::exp(-((x - 62.3) * (x - 62.3) / 200 + (y - 25) * (y - 25) / 500));
    const double was = std::exp(-((x - 62) * (x - 62) / 200 + (y - 25) * (y - 25) / 500));
    return pools(x, y) + (b - was) * glm::dvec3(0.1, 0.4, 0.9);
  });
  // A cone ends too late.
  expect_no_shift([](double x, double y) {
    const double r = std::hypot(x - 30, y - 40);
    return pools(x, y) * (r > 20 && r < 22 ? 1.5 : 1.0);
  });
  // A blemish.
  expect_no_shift([](double x, double y) {
    return pools(x, y) + (x > 40 && x < 53 && y > 20 && y < 33 ? 0.05 : 0.0);
  });
}

TEST(ExplainedByMoving, IsTheWholeDifferenceForAShiftAndNothingForAnotherMistake) {
  const Picture ours = picture_of(disc, 0.03, 0), theirs = picture_of(disc);
  const std::vector<std::uint8_t> all(ours.pixels.size(), 1);
  EXPECT_DOUBLE_EQ(explained_by_moving(ours, theirs, theirs, all), 1);
  EXPECT_LT(explained_by_moving(ours, picture_of(disc, 0.5, 0), theirs, all), 0.01);
  EXPECT_EQ(explained_by_moving(theirs, theirs, theirs, all), 0);
}

TEST(ExplainedByMoving, LooksOnlyWhereItIsTold) {
  const Picture ours = picture_of(disc, 0.5, 0), theirs = picture_of(disc);
  EXPECT_EQ(
      explained_by_moving(ours, theirs, theirs, std::vector<std::uint8_t>(ours.pixels.size(), 0)),
      0);
}

}  // namespace
}  // namespace litmus

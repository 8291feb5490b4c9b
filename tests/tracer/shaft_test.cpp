// shaft_test.cpp: what is proven about a pyramid holds for every ray in it.
#include "tracer/shaft.h"

#include <gtest/gtest.h>

#include <random>
#include <span>

namespace litmus {
namespace {

using V3 = Vec<double>;

struct Random {
  std::mt19937_64 engine{11};
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  V3 point(double size) {
    return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
  }
};

/// A small base about 3 away: not right-angled, in any direction.
Shaft random_shaft(Random& random, double size) {
  return shaft_to(random.point(3), random.point(size), random.point(size));
}

bool meets(const Shaft& shaft, double u, double v, const auto& object) {
  const Ray<double> ray{{}, shaft.center + u * shaft.across + v * shaft.up};
  if constexpr (requires { object.normal; }) {
    const double t = intersect(object, ray);
    return t > 0 && t < 1;
  } else {
    const Chord<double> chord = intersect(object, ray);
    if (chord.enter > chord.leave) return false;
    return (chord.enter > 0 && chord.enter < 1) || (chord.leave > 0 && chord.leave < 1);
  }
}

struct Count {
  int clear = 0, blocked = 0, undecided = 0, needless = 0;
};

/// Checks the verdict by rays over the whole base, its border included.
void check(const Shaft& shaft, const auto& object, Count& count) {
  constexpr int kRays = 12;
  int met = 0;
  for (int i = 0; i <= kRays; ++i)
    for (int j = 0; j <= kRays; ++j)
      met += meets(shaft, 2.0 * i / kRays - 1, 2.0 * j / kRays - 1, object);
  const int all = (kRays + 1) * (kRays + 1);
  switch (sight_past(shaft, object)) {
    case Sight::Clear:
      ++count.clear;
      EXPECT_EQ(met, 0);
      break;
    case Sight::Blocked:
      ++count.blocked;
      EXPECT_EQ(met, all);
      break;
    case Sight::Undecided:
      ++count.undecided;
      count.needless += met == 0 || met == all;
      break;
  }
}

TEST(SightPast, IsTrueOfEveryRayPastASphere) {
  Random random;
  Count count;
  for (int i = 0; i < 4000; ++i)
    check(random_shaft(random, 0.4), SphereSurface<double>{random.point(2), random(0.1, 2)}, count);
  EXPECT_GT(count.clear, 500);
  EXPECT_GT(count.blocked, 100);
  EXPECT_LT(count.needless, count.undecided / 3);
}

TEST(SightPast, IsTrueOfEveryRayPastABox) {
  Random random;
  Count count;
  for (int i = 0; i < 4000; ++i) {
    const V3 corner = random.point(2), size = random.point(1.5);
    check(random_shaft(random, 0.4),
          BoxSurface<double>{corner,
                             corner + V3{std::fabs(size.x), std::fabs(size.y), std::fabs(size.z)}},
          count);
  }
  EXPECT_GT(count.clear, 500);
  EXPECT_GT(count.blocked, 50);
  EXPECT_LT(count.needless, count.undecided / 4) << "the planes through its edges are tight";
}

TEST(SightPast, IsTrueOfEveryRayPastAPlane) {
  Random random;
  Count count;
  for (int i = 0; i < 4000; ++i)
    check(random_shaft(random, 0.4),
          PlaneSurface<double>{random.point(2), normalize(random.point(1))}, count);
  EXPECT_GT(count.clear, 500);
  EXPECT_GT(count.blocked, 500);
  EXPECT_EQ(count.needless, 0) << "its corners say everything";
}

TEST(MayMeet, IsFalseOnlyBesideAnEdge) {
  Random random;
  int beside = 0, needless = 0;
  for (int i = 0; i < 4000; ++i) {
    const Shaft shaft = random_shaft(random, 0.4);
    const V3 a = random.point(2), b = a + random.point(1);
    // Points of the edge inside the pyramid: their line of sight ends on the base beyond them.
    bool inside = false;
    for (int k = 0; k <= 200 && !inside; ++k) {
      const V3 p = a + (k / 200.0) * (b - a);
      const PlaneSurface<double> base{shaft.center, shaft.axes[4].normal};
      const double t = intersect(base, Ray<double>{{}, p});
      if (!(t >= 1)) continue;
      inside = true;
      for (std::size_t side = 0; side < 4; ++side) {
        const Shaft::Axis& axis = shaft.axes[side];
        const double at = dot(axis.normal, p) * t;
        inside = inside && at >= axis.low - 1e-9 && at <= axis.high + 1e-9;
      }
    }
    const bool may = may_meet(shaft, a, b);
    EXPECT_TRUE(may || !inside);
    beside += !may, needless += may && !inside;
  }
  EXPECT_GT(beside, 3000);
  EXPECT_LT(needless, 200);
}

/// The share of the base that a part leaves.
double left_by(const HiddenPart& part) {
  Moments moments{1};
  add_visible(moments, Polygon::square(), std::span(&part.set, 1));
  return moments.share();
}

double seen_past(const Shaft& shaft, const auto& object, int rays) {
  double seen = 0;
  for (int k = 0; k < rays; ++k)
    for (int j = 0; j < rays; ++j)
      seen += !meets(shaft, (2 * k + 1.0) / rays - 1, (2 * j + 1.0) / rays - 1, object);
  return seen / (rays * rays);
}

TEST(HiddenPart, IsTheShareThatABoxHidesExactly) {
  Random random;
  int partly = 0;
  for (int i = 0; i < 3000; ++i) {
    const Shaft shaft = shaft_to({random(-1, 1), random(-1, 1), 3}, {0.5, 0, 0}, {0, 0.4, 0});
    const V3 corner{random(-1, 1), random(-1, 1), random(0.5, 1.5)};
    const BoxSurface<double> box{corner, corner + V3{random(0.1, 1), random(0.1, 1), 0.4}};
    if (sight_past(shaft, box) != Sight::Undecided) continue;
    ++partly;
    const HiddenPart part = hidden_part(shaft, box);
    EXPECT_NEAR(left_by(part), seen_past(shaft, box, 50), 0.03);
    EXPECT_EQ(part.uncertain, 0);
  }
  EXPECT_GT(partly, 300);
}

TEST(HiddenPart, IsTheShareThatASphereHidesWithinWhatIsUncertain) {
  Random random;
  int partly = 0, around = 0;
  for (int i = 0; i < 3000; ++i) {
    const Shaft shaft = shaft_to({random(-1, 1), random(-1, 1), 3}, {0.5, 0, 0}, {0, 0.4, 0});
    const SphereSurface<double> sphere{{random(-1, 1), random(-1, 1), random(1, 2)},
                                       random(0.05, 0.7)};
    if (sight_past(shaft, sphere) != Sight::Undecided) continue;
    ++partly;
    const double grid = 4.0 / 100;  // what a row of rays may be off
    const HiddenPart coarse = hidden_part(shaft, sphere, 0.7),
                     fine = hidden_part(shaft, sphere, 0.1);
    EXPECT_NEAR(left_by(fine), seen_past(shaft, sphere, 100), fine.uncertain + grid / 4);
    EXPECT_NEAR(left_by(coarse), left_by(fine), coarse.uncertain + fine.uncertain);
    EXPECT_LT(fine.uncertain, 0.02);
    around += fine.set.count == kMostSides;
  }
  EXPECT_GT(partly, 300);
  EXPECT_GT(around, 20) << "some lie wholly before the base";
}

TEST(HiddenPart, OfASphereAroundTheBaseOrTheApexIsNotKnown) {
  const Shaft shaft = shaft_to({0, 0, 3}, {0.5, 0, 0}, {0, 0.4, 0});
  EXPECT_EQ(hidden_part(shaft, SphereSurface<double>{{0, 0, 3}, 0.2}, 0.1).set.count, 0);
  EXPECT_EQ(hidden_part(shaft, SphereSurface<double>{{0, 0, 0.1}, 0.2}, 0.1).set.count, 0);
  EXPECT_GT(hidden_part(shaft, SphereSurface<double>{{0, 0, 1}, 0.2}, 0.1).set.count, 0);
}

TEST(SeenEdge, CrossesAPolygonOnlyBetweenItsEnds) {
  const Shaft shaft = shaft_to({0, 0, 2}, {1, 0, 0}, {0, 1, 0});
  const Polygon square = Polygon::square();
  EXPECT_TRUE(may_cross(square, seen_edge(shaft, {-2, 0.1, 1}, {2, 0.1, 1})));
  EXPECT_TRUE(may_cross(square, seen_edge(shaft, {0, 0.1, 1}, {0.2, 0.3, 1.5})));
  EXPECT_FALSE(may_cross(square, seen_edge(shaft, {0.6, 0.1, 1}, {2, 0.1, 1}))) << "begins beyond";
  EXPECT_FALSE(may_cross(square, seen_edge(shaft, {-2, 0.6, 1}, {2, 0.6, 1}))) << "beside";
}

}  // namespace
}  // namespace litmus

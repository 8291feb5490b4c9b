// intersect_test.cpp: rays against closed forms, edges and far surfaces.
#include "tracer/intersect.h"

#include <gtest/gtest.h>

#include <random>

namespace litmus {
namespace {

using V = Vec<double>;

TEST(SphereIntersection, HasBothEndsOfTheChord) {
  const auto chord = intersect(SphereSurface<double>{{0, 0, 5}, 2}, Ray<double>{{}, {0, 0, 1}});
  EXPECT_DOUBLE_EQ(chord.enter, 3);
  EXPECT_DOUBLE_EQ(chord.leave, 7);
}

TEST(SphereIntersection, FromInsideLeavesAhead) {
  const auto chord = intersect(SphereSurface<double>{{}, 2}, Ray<double>{{0.5, 0, 0}, {1, 0, 0}});
  EXPECT_DOUBLE_EQ(chord.enter, -2.5);
  EXPECT_DOUBLE_EQ(chord.leave, 1.5);
}

TEST(SphereIntersection, CountsATangentAsAHit) {
  const auto chord = intersect(SphereSurface<double>{{}, 1}, Ray<double>{{-10, 1, 0}, {1, 0, 0}});
  EXPECT_DOUBLE_EQ(chord.enter, 10);
  EXPECT_LE(chord.enter, chord.leave);
}

TEST(SphereIntersection, FindsASmallSphereFarAwayInFloat) {
  const float distance = 1e3f, aim = 0.999f;
  const Ray<float> ray{{}, {aim / distance, 0, 1}};
  const auto chord = intersect(SphereSurface<float>{{0, 0, distance}, 1}, ray);
  ASSERT_LE(chord.enter, chord.leave);
  EXPECT_NEAR(chord.enter, distance - std::sqrt(1 - aim * aim), 0.01);
}

TEST(SphereIntersection, ScalesWithAnUnnormalisedDirection) {
  const auto chord =
      intersect(SphereSurface<double>{{0, 0, 5}, 2}, Ray<double>{{}, {0, 0, 0x1p-20}});
  EXPECT_EQ(chord.enter, 3 * 0x1p20);
}

TEST(PlaneIntersection, MissesWhenParallel) {
  EXPECT_LT(intersect(PlaneSurface<double>{{}, {0, 0, 1}}, Ray<double>{{0, 0, 1}, {1, 0, 0}}), 0);
}

TEST(BoxIntersection, SurvivesARayInThePlaneOfAFace) {
  const BoxSurface<double> box{{0, 0, 0}, {1, 1, 1}};
  const auto chord = intersect(box, Ray<double>{{-1, 0, 0.5}, {1, 0, 0}});
  EXPECT_EQ(chord.enter, 1);
  EXPECT_EQ(chord.leave, 2);
}

TEST(BoxIntersection, NamesTheFacesOfTheChord) {
  const auto chord =
      intersect(BoxSurface<double>{{-1, -1, -1}, {1, 1, 1}}, Ray<double>{{0, 0, 5}, {0, 0, -1}});
  EXPECT_EQ(chord.enter_face, 5);
  EXPECT_EQ(chord.leave_face, 4);
}

// ---- The balls around them -------------------------------------------------------------------

/// Rays towards what is hardest for a cull: points within a few roundings of a solid's outline.
template <class R>
class MayMeet : public testing::Test {
 protected:
  struct Tally {
    int met = 0, lost = 0, culled = 0;
  };

  R random(double low, double high) {
    return R(std::uniform_real_distribution<double>(low, high)(engine_));
  }
  Vec<R> vector(double size) {
    return {random(-size, size), random(-size, size), random(-size, size)};
  }
  /// 1, but for a relative error between 1e-18 and 1e-1 to either side.
  R nearly_one() {
    const double apart = std::pow(10.0, double(random(-18, -1)));
    return R(random(0, 1) < R(0.5) ? 1 + apart : 1 - apart);
  }
  template <class Solid>
  void add(const Solid& solid, const Ray<R>& ray, Tally& tally) {
    const Chord<R> chord = intersect(solid, ray);
    const bool meets = chord.enter <= chord.leave && chord.leave > 0;
    const bool kept = may_meet(ball_around(solid), ray);
    tally.met += meets, tally.lost += meets && !kept, tally.culled += !kept;
  }

 private:
  std::mt19937 engine_{5};
};

using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(MayMeet, Scalars);

TYPED_TEST(MayMeet, LosesNoSphere) {
  using R = TypeParam;
  typename TestFixture::Tally tally;
  for (int i = 0; i < 100'000; ++i) {
    const SphereSurface<R> sphere{this->vector(10), R(std::pow(10.0, double(this->random(-3, 1))))};
    const Vec<R> origin = this->vector(20), towards = normalize(sphere.center - origin);
    const Vec<R> aside = normalize(cross(towards, this->vector(1)));
    const Vec<R> target = sphere.center + (sphere.radius * this->nearly_one()) * aside;
    this->add(sphere, {origin, target - origin}, tally);
    // From the surface, to the outside and to the inside.
    const Vec<R> start = sphere.center + (sphere.radius * this->nearly_one()) * towards;
    this->add(sphere, {start, this->vector(1)}, tally);
  }
  EXPECT_EQ(tally.lost, 0);
  EXPECT_GT(tally.met, 50'000);
  EXPECT_GT(tally.culled, 4'000);
}

TYPED_TEST(MayMeet, LosesNoBox) {
  using R = TypeParam;
  typename TestFixture::Tally tally;
  for (int i = 0; i < 100'000; ++i) {
    const R size = R(std::pow(10.0, double(this->random(-3, 1))));
    const Vec<R> min = this->vector(10);
    const Vec<R> max = min + Vec<R>{size * this->random(0.1, 1), size, size};
    const BoundedBox<R> box{{min, max}, box_ball(min, max)};
    const Vec<R> corner = box.ball.center + this->nearly_one() * (max - box.ball.center);
    const Vec<R> origin = this->vector(20);
    this->add(box, {origin, corner - origin}, tally);
    this->add(box, {corner, this->vector(1)}, tally);
  }
  EXPECT_EQ(tally.lost, 0);
  EXPECT_GT(tally.met, 20'000);
  EXPECT_GT(tally.culled, 4'000);
}

TEST(TriangleIntersection, GivesTheBarycentricWeightsOfThePoint) {
  const std::array<V, 3> triangle{V{0, 0, 2}, V{4, 0, 2}, V{0, 4, 2}};
  const Ray<double> ray{{1, 2, 0}, {0, 0, 1}};
  const auto hit = intersect(triangle, ray, ShearedRay<double>(ray.direction));
  EXPECT_DOUBLE_EQ(hit.t, 2);
  EXPECT_DOUBLE_EQ(hit.u, 0.25);
  EXPECT_DOUBLE_EQ(hit.v, 0.25);
  EXPECT_DOUBLE_EQ(hit.w, 0.5);
}

TEST(TriangleIntersection, LetsNothingThroughASharedEdge) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const V a{0.1, 0.2, 1}, b{1.3, -0.4, 1.7}, c{0.2, 1.5, 1.1}, d{1.9, 1.2, 0.8};
  for (int i = 0; i < 20000; ++i) {
    const double t = uniform(random);
    const Ray<double> ray{{0.7, 0.5, -3}, (1 - t) * b + t * c - V{0.7, 0.5, -3}};
    const ShearedRay<double> sheared(ray.direction);
    const bool left = intersect({a, b, c}, ray, sheared).t > 0;
    const bool right = intersect({d, c, b}, ray, sheared).t > 0;
    ASSERT_TRUE(left || right) << "at " << t;
  }
}

TEST(TriangleIntersection, MissesBesideTheTriangle) {
  const std::array<V, 3> triangle{V{0, 0, 2}, V{4, 0, 2}, V{0, 4, 2}};
  const Ray<double> ray{{3, 3, 0}, {0, 0, 1}};
  EXPECT_LT(intersect(triangle, ray, ShearedRay<double>(ray.direction)).t, 0);
}

TEST(TriangleIntersection, NeverHitsADegenerateTriangle) {
  const std::array<V, 3> line{V{0, 0, 2}, V{1, 0, 2}, V{2, 0, 2}};
  const Ray<double> ray{{1, 0, 0}, {0, 0, 1}};
  EXPECT_LT(intersect(line, ray, ShearedRay<double>(ray.direction)).t, 0);
}

}  // namespace
}  // namespace litmus

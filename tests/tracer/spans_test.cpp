// spans_test.cpp: a ball is seen where its span says, and hardly anywhere else.
#include "tracer/spans.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/tracer/scenes.h"
#include "tracer/camera.h"

namespace litmus {
namespace {

Scene floor_in_perspective() {
  Scene scene = floor_from_above(64);
  scene.camera.projection = Projection::Perspective;
  return scene;
}

struct SpanRays {
  int outside = 0;  ///< rays that meet the ball outside of its span
  int inside = 0, needless = 0;
};

/// All rays of all rows of a picture towards balls in front of the eye, beside and behind it.
template <Real R>
SpanRays look_at_balls(double away) {
  Scene scene = floor_in_perspective();
  scene.camera.eye += Vector(away, 0, 0), scene.camera.target += Vector(away, 0, 0);
  const Plan<R> plan = lower<R>(scene);
  std::mt19937_64 engine{5};
  std::uniform_real_distribution<double> place(-6, 6), size(0.01, 2);
  SpanRays found;
  for (int ball = 0; ball < 300; ++ball) {
    const SphereSurface<R> sphere{
        Vec<R>{R(away + place(engine)), R(place(engine)), R(place(engine) + 8)}, R(size(engine))};
    for (int y = 0; y < 64; ++y) {
      const R up = -screen<R>(R(y), 64);
      const Span<R> span = span_of(plan.view, up, ball_around(sphere));
      for (int x = 0; x < 64; ++x) {
        const R across = screen<R>(R(x), 64);
        const Chord<R> chord = intersect(sphere, camera_ray<R, R>(plan.view, across, up));
        const bool met = chord.enter <= chord.leave && chord.leave > 0;
        const bool within = across >= span.low && across <= span.high;
        found.outside += met && !within;
        found.inside += met, found.needless += within && !met;
      }
    }
  }
  return found;
}

TEST(SpanOf, HoldsEveryRayThatMeetsTheBall) {
  for (const double away : {0.0, 1e5}) {
    const SpanRays exact = look_at_balls<double>(away), rounded = look_at_balls<float>(away);
    EXPECT_EQ(exact.outside, 0) << away;
    EXPECT_EQ(rounded.outside, 0) << away;
    EXPECT_GT(exact.inside, 1000) << away;
  }
}

TEST(SpanOf, HoldsFewOthersBeforeTheEye) {
  const Plan<double> plan = lower<double>(floor_in_perspective());
  const Vec<double> middle = plan.view.eye + 5.0 * plan.view.forward;
  const Span<double> span = span_of(plan.view, 0.0, Ball<double>{middle, 1});
  const double half = std::tan(std::asin(0.2)) / std::sqrt(dot(plan.view.right, plan.view.right));
  EXPECT_NEAR(span.low, -half, 1e-9);
  EXPECT_NEAR(span.high, half, 1e-9);
}

TEST(SpanOf, IsEmptyWhereTheRowPassesTheBall) {
  const Plan<double> plan = lower<double>(floor_in_perspective());
  const Vec<double> middle = plan.view.eye + 5.0 * plan.view.forward;
  const Span<double> span = span_of(plan.view, 0.9, Ball<double>{middle, 0.1});
  EXPECT_GT(span.low, span.high);
}

}  // namespace
}  // namespace litmus

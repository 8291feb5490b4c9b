// closed_form_shadow_test.cpp: each inequality against a walk along the way in small steps.
#include "reference/closed_form_shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace litmus {
namespace {

bool inside(const Sphere& s, const ExactVec& p) {
  return glm::length(p - ExactVec(s.center)) < s.radius;
}
bool inside(const Box& b, const ExactVec& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < b.min[axis] || p[axis] > b.max[axis]) return false;
  return true;
}

/// Whether the walk is ever inside; a solid that it only grazes may be stepped over.
template <class Solid>
bool met(const Solid& solid, const Passage& passage) {
  constexpr int kSteps = 4000;
  const ExactVec way = passage.sun ? passage.to * Exact(20) : passage.to - passage.from;
  for (int i = 0; i <= kSteps; ++i)
    if (inside(solid, passage.from + way * (Exact(i) / kSteps))) return true;
  return false;
}

/// Random ways past the solid; a margin keeps out those that the walk cannot decide.
template <class Solid>
void expect_as_walked(const Solid& solid, const Solid& smaller, const Solid& larger, bool sun) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-2, 2);
  const auto point = [&] { return ExactVec(any(random), any(random), any(random)); };
  int blocked = 0, open = 0;
  for (int i = 0; i < 400; ++i) {
    const ExactVec from = point(), to = sun ? glm::normalize(point()) : point();
    const Passage passage{from, to, sun};
    if (inside(larger, from) || (!sun && inside(larger, to))) continue;
    const bool surely_met = met(smaller, passage), surely_free = !met(larger, passage);
    if (!surely_met && !surely_free) continue;
    const Way way = passage_by({"solid", solid, 0}, passage);
    ASSERT_EQ(way, surely_met ? Way::Blocked : Way::Open) << i;
    ++(surely_met ? blocked : open);
  }
  EXPECT_GT(blocked, 20);
  EXPECT_GT(open, 20);
}

TEST(PassageBySphere, IsHeldWhereAWalkMeetsIt) {
  for (const bool sun : {false, true})
    expect_as_walked(Sphere{{0.2, -0.1, 0.3}, 0.8}, {{0.2, -0.1, 0.3}, 0.79},
                     {{0.2, -0.1, 0.3}, 0.81}, sun);
}

TEST(PassageBySphere, IsOpenBehindTheLampAndBeforeThePoint) {
  const Object ball{"ball", Sphere{{0, 0, 3}, 0.5}, 0};
  EXPECT_EQ(passage_by(ball, {{0, 0, 0}, {0, 0, 2}}), Way::Open);
  EXPECT_EQ(passage_by(ball, {{0, 0, 4}, {0, 0, 5}}), Way::Open);
  EXPECT_EQ(passage_by(ball, {{0, 0, 0}, {0, 0, 4}}), Way::Blocked);
  EXPECT_EQ(passage_by(ball, {{0, 0, 4}, {0, 0, 1}, true}), Way::Open);
}

TEST(PassageBySphere, IsHeldBetweenInsideAndOutside) {
  const Object shell{"shell", Sphere{{0, 0, 0}, 1}, 0};
  EXPECT_EQ(passage_by(shell, {{0, 0, 0.5}, {0, 0, 2}}), Way::Blocked);
  EXPECT_EQ(passage_by(shell, {{0, 0, 2}, {0, 0, 0.5}}), Way::Blocked);
  EXPECT_EQ(passage_by(shell, {{0, 0, 0.5}, {0, 0.5, 0}}), Way::Open);
  EXPECT_EQ(passage_by(shell, {{0, 0, 0.5}, {0, 0, 1}, true}), Way::Blocked);
}

TEST(PassageBySphere, IsUnsureAtATangent) {
  const Object ball{"ball", Sphere{{1, 0, 0}, 1}, 0};
  EXPECT_EQ(passage_by(ball, {{0, 0, -3}, {0, 0, 3}}), Way::Unsure);
  EXPECT_EQ(passage_by(ball, {{1e-6, 0, -3}, {1e-6, 0, 3}}), Way::Blocked);
  EXPECT_EQ(passage_by(ball, {{-1e-6, 0, -3}, {-1e-6, 0, 3}}), Way::Open);
}

TEST(PassageByBox, IsHeldWhereAWalkMeetsIt) {
  for (const bool sun : {false, true})
    expect_as_walked(Box{{-0.6, -0.5, -0.7}, {0.8, 0.5, 0.4}},
                     Box{{-0.58, -0.48, -0.68}, {0.78, 0.48, 0.38}},
                     Box{{-0.62, -0.52, -0.72}, {0.82, 0.52, 0.42}}, sun);
}

TEST(PassageByBox, IsOpenForAPointOnItsFace) {
  const Object block{"block", Box{{0, 0, 0}, {1, 1, 1}}, 0};
  EXPECT_EQ(passage_by(block, {{0.5, 0.5, 1}, {0.7, 0.5, 3}}), Way::Open);
  EXPECT_EQ(passage_by(block, {{0.5, 0.5, 0}, {0.5, 0.5, 3}}), Way::Blocked);
  EXPECT_EQ(passage_by(block, {{0.5, 0.5, 0}, {0, 0, 1}, true}), Way::Blocked);
}

TEST(PassageByPlane, IsHeldBetweenItsSides) {
  const Object floor{"floor", Plane{{0, 0, 0}, {0, 0, 1}}, 0};
  EXPECT_EQ(passage_by(floor, {{0, 0, 1}, {1, 2, 3}}), Way::Open);
  EXPECT_EQ(passage_by(floor, {{0, 0, -1}, {1, 2, 3}}), Way::Blocked);
  EXPECT_EQ(passage_by(floor, {{0, 0, 0}, {1, 2, 3}}), Way::Open);
  EXPECT_EQ(passage_by(floor, {{0, 0, -1}, {0, 0, 1}, true}), Way::Blocked);
  EXPECT_EQ(passage_by(floor, {{0, 0, 1}, {0, 0, 1}, true}), Way::Open);
}

TEST(PassageByTriangle, IsHeldWhereItCrossesInsideItsEdges) {
  const Object flat{"flat", Triangle{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}}, 0};
  const Object turned{"turned", Triangle{{0, 0, 1}, {0, 2, 1}, {2, 0, 1}}, 0};
  for (const Object& triangle : {flat, turned})
    for (int i = -3; i < 12; ++i)
      for (int j = -3; j < 12; ++j) {
        // The crossing at height 1 of the way to (0.5, 0.5, 3) is two thirds of the floor point
        // and one third of the lamp.
        const Exact x = 0.301L * i, y = 0.307L * j;
        const Exact u = x * 2 / 3 + 0.5L / 3, v = y * 2 / 3 + 0.5L / 3;
        const bool crosses = u > 0 && v > 0 && u + v < 2;
        ASSERT_EQ(passage_by(triangle, {{x, y, 0}, {0.5, 0.5, 3}}),
                  crosses ? Way::Blocked : Way::Open);
        ASSERT_EQ(passage_by(triangle, {{x, y, 0}, {0.5, 0.5, 0.9}}), Way::Open);
      }
}

TEST(PassageThrough, AsksEveryObjectButTheSkipped) {
  Scene scene;
  scene.objects = {{"floor", Plane{}, 0}, {"ball", Sphere{{0, 0, 2}, 0.5}, 0, false}};
  const Passage up{{0, 0, 0}, {0, 0, 4}};
  const Obstacles all = obstacles(scene, {{0, 0, 4}}), seen = obstacles(scene, {{0, 0, 4}}, true);
  EXPECT_EQ(passage_through(all, up, nullptr), Way::Blocked);
  EXPECT_EQ(passage_through(all, up, &scene.objects[1]), Way::Open);
  EXPECT_EQ(passage_through(seen, up, nullptr), Way::Open);  // it is not seen
}

/// Shapes whose boundaries the ways of the next test cross, a mesh among them.
std::vector<Object> shapes() {
  Mesh fan;
  for (int i = 0; i <= 12; ++i)
    fan.vertices.push_back({0.8 * std::cos(i * 0.5), 0.9 * std::sin(i * 0.5), 0.1 * (i % 3)});
  for (std::int32_t i = 0; i + 2 < 13; ++i) fan.triangles.push_back({i, i + 1, (i * 5) % 13});
  return {{"ball", Sphere{{0.1, -0.2, 0.1}, 0.6}, 0},
          {"block", Box{{-0.5, -0.4, -0.3}, {0.4, 0.6, 0.2}}, 0},
          {"blind", Triangle{{-0.7, -0.6, 0}, {0.8, -0.5, 0.1}, {0.1, 0.9, -0.2}}, 0},
          {"floor", Plane{{0, 0, 0.05}, {0.2, -0.1, 1}}, 0},
          {"fan", fan, 0}};
}

/// What double precision and the map of facets are asked first must not change an answer: that of
/// extended precision over all facets, for places at every distance from the shapes.
TEST(PassageThrough, AnswersAsExtendedPrecisionDoes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  for (const Object& object : shapes())
    for (const double far : {0.0, 2.0, 1e3, 1e6}) {
      int blocked = 0, open = 0;
      for (int end = 0; end < 20; ++end)
        for (const bool sun : {false, true}) {
          const ExactVec away = glm::normalize(ExactVec(any(random), any(random), any(random)));
          const ExactVec to(glm::dvec3(sun ? away : away * Exact(far)));
          Scene scene;
          scene.objects = {object};
          const Obstacles one = obstacles(scene, {glm::dvec3(to), sun});
          for (int i = 0; i < 200; ++i) {
            const ExactVec from(any(random), any(random), any(random));
            const Way way = passage_by(object, {from, to, sun});
            ASSERT_EQ(passage_through(one, {from, to, sun}, nullptr), way) << object.name << far;
            blocked += way == Way::Blocked, open += way == Way::Open;
          }
        }
      EXPECT_GT(blocked, 20) << object.name;
      EXPECT_GT(open, 20) << object.name;
    }
}

TEST(PassageThrough, IsSureOfASphereFarFromItsLamp) {
  // As seen from 1e6 units the sphere is two millionths wide; its edge is as sharp as ever.
  const Object ball{"ball", Sphere{{0, 0, 1}, 0.5}, 0};
  EXPECT_EQ(passage_by(ball, {{0.499999, 0, 0}, {0, 0, 1e6}}), Way::Blocked);
  EXPECT_EQ(passage_by(ball, {{0.500001, 0, 0}, {0, 0, 1e6}}), Way::Open);
}

}  // namespace
}  // namespace litmus

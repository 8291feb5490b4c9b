// rays_test.cpp: hard cases of intersections (I), of shadow rays (S) and of the environment (C)
// that no other test has; docs/hard-cases.md lists all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "scene/mesh.h"
#include "stress/random.h"
#include "test_paths.h"
#include "tests/scene/scratch_scene.h"
#include "tests/tracer/scenes.h"
#include "tracer/closest.h"
#include "tracer/render.h"
#include "tracer/self_check.h"
#include "tracer/visibility.h"

namespace litmus {
namespace {

using V = Vec<double>;

Lamp<double> lamp_at(const V& origin) {
  Lamp<double> lamp;
  lamp.origin = origin;
  return lamp;
}

/// Whether a lamp is hidden from the first point along a ray.
bool dark(const Plan<double>& plan, const V& from, const V& toward, const V& lamp) {
  const Hit<double> hit = closest_hit(plan, {from, toward - from});
  EXPECT_NE(hit.kind, Kind::None);
  return occluded(plan, hit, incident(lamp_at(lamp), hit.point));
}

Plan<double> plan_of(std::vector<decltype(Object::shape)> shapes) {
  Scene scene = seen_from_above();
  for (auto& shape : shapes)
    scene.objects.push_back(
        {"thing " + std::to_string(scene.objects.size()), std::move(shape), 0, true});
  return lower<double>(scene);
}

// I-02, I-10
TEST(HardCaseI02, ASmallSphereTenMillionUnitsAwayIsHitOnItsSurface) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Draw draw(2, i);
    const double aim = draw.uniform(0, 0.999), distance = 1e7;
    const auto chord = intersect(SphereSurface<double>{{0, 0, distance}, 1},
                                 Ray<double>{{}, {aim / distance, 0, 1}});
    ASSERT_LE(chord.enter, chord.leave);
    const double x = chord.enter * aim / distance, z = chord.enter - distance;
    ASSERT_NEAR(std::hypot(x, z), 1, 1e-6);
  }
}

TEST(HardCaseI10, ASphereWhoseSquareOverflowsOrUnderflowsIsHit) {
  for (const float radius : {1e25f, 1e-25f}) {
    const auto chord =
        intersect(SphereSurface<float>{{0, 0, 4 * radius}, radius}, Ray<float>{{}, {0, 0, 1}});
    EXPECT_FLOAT_EQ(chord.enter, 3 * radius);
    EXPECT_FLOAT_EQ(chord.leave, 5 * radius);
  }
}

TEST(HardCaseI12, ARayAlmostAlongAPlaneMeetsItFarAway) {
  const PlaneSurface<double> plane{{}, {0, 0, 1}};
  for (const double slope : {1e-12, 1e-100, 1e-300}) {
    const double t = intersect(plane, Ray<double>{{0, 0, 1}, {1, 0, -slope}});
    EXPECT_TRUE(std::isfinite(t) && t > 0) << slope;
    EXPECT_DOUBLE_EQ(t, 1 / slope);
  }
}

TEST(HardCaseI16, TheOrderOfTrianglesDoesNotDecideWhatIsHit) {
  Mesh ball = icosphere({0, 0, 0}, 1, 2, false);
  Mesh reversed = ball;
  std::reverse(reversed.triangles.begin(), reversed.triangles.end());
  const Plan<double> a = plan_of({ball}), b = plan_of({reversed});
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Draw draw(16, i);
    const auto& corners = ball.triangles[std::size_t(draw.below(int(ball.triangles.size())))];
    const Point p = ball.vertices[std::size_t(corners[0])],
                q = ball.vertices[std::size_t(corners[1])];
    const V eye = 3.0 * draw.direction(), aim = V(draw.below(2) ? p : (p + q) / 2.0);
    const Hit<double> one = closest_hit(a, {eye, aim - eye}),
                      other = closest_hit(b, {eye, aim - eye});
    ASSERT_EQ(one.kind == Kind::None, other.kind == Kind::None);
    if (one.kind != Kind::None) {
      ASSERT_NEAR(one.t, other.t, 1e-14);
    }
  }
}

TEST(HardCaseI18, ASliverIsHitWithinItsCornersAndHasItsNormal) {
  const Plan<double> plan = plan_of({Triangle{{0, 0, 1}, {1, 0, 1}, {0.5, 1e-6, 1}}});
  int hits = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Draw draw(18, i);
    const V eye{draw.uniform(-2, 2), draw.uniform(-2, 2), draw.uniform(2, 5)};
    const V aim{draw.uniform(0, 1), draw.uniform(0, 1e-6), 1};
    const Hit<double> hit = closest_hit(plan, {eye, aim - eye});
    if (hit.kind == Kind::None) continue;
    ++hits;
    ASSERT_NEAR(hit.t, 1, 1e-9);
    ASSERT_NEAR(hit.geometric.z, 1, 1e-12);
  }
  EXPECT_GT(hits, 5000);
}

TEST(HardCaseI21, AFlatMeshIsHitAtTheCornersOfItsBox) {
  const Plan<double> plan =
      plan_of({Mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {}, {{0, 1, 2}, {0, 2, 3}}}});
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Draw draw(21, i);
    // A rounding error of the ray within the corner: there the box is met at its very edge.
    const double x = draw.below(2) ? 1e-9 : 1 - 1e-9, y = draw.below(2) ? 1e-9 : 1 - 1e-9;
    const V corner{x, y, 0};
    const V eye{draw.uniform(0, 1), draw.uniform(0, 1), draw.decades(0.1, 1e6)};
    ASSERT_NE(closest_hit(plan, {eye, corner - eye}).kind, Kind::None) << i;
  }
}

TEST(HardCaseI23, ARayThatIsNoNumberMissesAtOnce) {
  const Plan<double> plan = plan_of({icosphere({0, 0, 0}, 1, 3, false), Sphere{}, Box{}, Plane{}});
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const auto start = std::chrono::steady_clock::now();
  for (const double bad : {nan, infinity, -infinity}) {
    for (int i = 0; i < 6; ++i) {
      double numbers[6] = {0.1, 0.2, 5, 0.3, 0.1, -1};
      numbers[i] = bad;
      const Ray<double> ray{{numbers[0], numbers[1], numbers[2]},
                            {numbers[3], numbers[4], numbers[5]}};
      const Hit<double> hit = closest_hit(plan, ray);
      EXPECT_FALSE(std::isnan(hit.t)) << i;
    }
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST(HardCaseB14, NoFacetOfASmoothBallShadowsItself) {
  for (const int level : {1, 2, 3, 4}) {
    const Plan<double> plan = plan_of({icosphere({0, 0, 0}, 1, level, true)});
    int lit = 0;
    for (std::uint64_t i = 0; i < 3000; ++i) {
      Draw draw(std::uint64_t(140 + level), i);
      const V eye = 4.0 * draw.direction(), aim = 0.9 * draw.direction();
      const Hit<double> hit = closest_hit(plan, {eye, aim - eye});
      if (hit.kind == Kind::None) continue;
      Lamp<double> sun;
      sun.directional = true, sun.toward = draw.direction();
      if (!(dot(sun.toward, hit.geometric) > 0 && dot(sun.toward, hit.normal) > 0)) continue;
      ++lit;
      ASSERT_FALSE(occluded(plan, hit, incident(sun, hit.point))) << level;
    }
    EXPECT_GT(lit, 500);
  }
}

TEST(HardCaseS08, ASphereThatTouchesTheLightFromBehindCastsNoShadow) {
  const Plan<double> plan = plan_of({Plane{}, Sphere{{0, 0, 3}, 1}});
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Draw draw(8, i);
    const V seen{draw.uniform(-3, 3), draw.uniform(-3, 3), 0};
    ASSERT_FALSE(dark(plan, seen + V{0, 0, 0.5}, seen, {0, 0, 2})) << i;
  }
  EXPECT_TRUE(dark(plan, {0.1, 0, 0.5}, {0.1, 0, 0}, {0, 0, 2.1}));  // the control: inside of it
}

TEST(HardCaseS09, ALightInsideAClosedBodyLightsOnlyItsInside) {
  for (const decltype(Object::shape)& body :
       {decltype(Object::shape)(Sphere{{0, 0, 2}, 1}),
        decltype(Object::shape)(Box{{-1, -1, 1}, {1, 1, 3}}),
        decltype(Object::shape)(icosphere({0, 0, 2}, 1, 2, false))}) {
    const Plan<double> plan = plan_of({body, Plane{}});
    EXPECT_TRUE(dark(plan, {2, 0.3, 0.5}, {2, 0.3, 0}, {0, 0, 2}));   // the floor outside
    EXPECT_FALSE(dark(plan, {0, 0, 2}, {0.3, 0.2, 5}, {0, 0, 2.1}));  // the wall inside
  }
}

TEST(HardCaseS11, APointOnAnEdgeOfTwoFacesIsNotShadowedByTheNeighbour) {
  Mesh cube{{{-1, -1, -1},
             {1, -1, -1},
             {1, 1, -1},
             {-1, 1, -1},
             {-1, -1, 1},
             {1, -1, 1},
             {1, 1, 1},
             {-1, 1, 1}},
            {},
            {{0, 2, 1},
             {0, 3, 2},
             {4, 5, 6},
             {4, 6, 7},
             {0, 1, 5},
             {0, 5, 4},
             {1, 2, 6},
             {1, 6, 5},
             {2, 3, 7},
             {2, 7, 6},
             {3, 0, 4},
             {3, 4, 7}}};
  const Plan<double> plan = plan_of({cube});
  int lit = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Draw draw(11, i);
    const auto& corners = cube.triangles[std::size_t(draw.below(12))];
    const double along = draw.uniform();
    const V aim = V((1 - along) * cube.vertices[std::size_t(corners[0])] +
                    along * cube.vertices[std::size_t(corners[1])]);
    const V eye = 5.0 * draw.direction();
    const Hit<double> hit = closest_hit(plan, {eye, aim - eye});
    if (hit.kind == Kind::None || dot(hit.geometric, hit.point) < 0) continue;
    const Incident<double> light = incident(lamp_at(9.0 * draw.direction()), hit.point);
    if (!(dot(light.direction, hit.geometric) > 1e-7)) continue;
    ++lit;
    ASSERT_FALSE(occluded(plan, hit, light)) << i;
  }
  EXPECT_GT(lit, 4000);
}

// S-12, S-13
TEST(HardCaseS12, ALightInOrBelowTheSurfaceAddsExactlyNothing) {
  for (const double height : {0.0, -1e-12, -1.0}) {
    Scene scene = floor_from_above(9);
    scene.lights = {bulb({0.05, 0.03, height})};
    // An orthographic eye above: the floor faces up, the light does not reach it.
    for (const auto& pixel : render(scene).whole.pixels) ASSERT_EQ(pixel, Color(0)) << height;
  }
}

TEST(HardCaseS14, ALightJustAboveAPlaneLightsItByTheClosedForm) {
  Scene scene = floor_from_above(16);
  const double height = 1e-4;
  scene.lights = {bulb({0, 0, height})};
  const Rendering result = render(scene);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const Point p = floor_point(scene, x, y);
      const double cosine = height / std::sqrt(height * height + p.x * p.x + p.y * p.y);
      ASSERT_NEAR(result.whole.at(x, y).x / (0.8 * cosine), 1, 1e-14);
    }
  }
}

TEST(HardCaseS15, AShadowOfTheSunReachesAsFarAsTheSceneDoes) {
  const Plan<double> plan = plan_of({Plane{}, Sphere{{0, 0, 1e12}, 1}});
  Lamp<double> sun;
  sun.directional = true, sun.toward = {0, 0, 1};
  const auto hidden = [&](double x) {
    const Hit<double> hit = closest_hit(plan, {{x, 0, 3}, {0, 0, -1}});
    return occluded(plan, hit, incident(sun, hit.point));
  };
  EXPECT_TRUE(hidden(0.5));
  EXPECT_FALSE(hidden(1.5));
}

TEST(HardCaseS16, APenumbraIsAWholeNumberOfSamples) {
  // The sample code adds the ambient light once for each sample in view, which counts them.
  Scene scene = floor_from_above(48);
  scene.shading = Shading::SampleCode;
  scene.ambient = Color(1);
  scene.materials[0].diffuse = Color(0);
  scene.objects.push_back({"ball", Sphere{{0, 0, 1.5}, 0.5}, 0, false});
  AreaLight panel;
  panel.point.origin = {0, 0, 4}, panel.normal = Vector(0, 0, -1);
  panel.width = panel.height = 1, panel.columns = panel.rows = 8;
  scene.lights = {make_light(panel)};
  int partial = 0;
  const Rendering result = render(scene);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) {
      const double seen = result.whole.at(x, y).x;
      ASSERT_EQ(seen, std::round(seen));
      ASSERT_TRUE(seen >= 0 && seen <= 64);
      partial += seen > 0 && seen < 64;
      // From the middle of the shadow outwards no sample is lost again.
      if (x >= 24 && x < 47) {
        ASSERT_LE(seen, result.whole.at(x + 1, y).x);
      }
    }
  }
  EXPECT_GT(partial, 100);
}

TEST(HardCaseC05, CMakeRefusesFastMath) {
  const ScratchFolder folder;
  const std::string log = (folder.path() / "log").string();
  const std::string command = "cmake -S '" LITMUS_SOURCE "' -B '" +
                              (folder.path() / "build").string() +
                              "' -DCMAKE_CXX_FLAGS=-ffast-math > '" + log + "' 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0);
  std::ifstream file(log);
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(file), {}),
              testing::HasSubstr("remove -ffast-math"));
}

TEST(HardCaseC06, WorkerThreadsComputeAsTheMainThreadDoes) {
  std::atomic<int> faults = 0;
  tbb::parallel_for(0, 1000, [&](int) { faults += !arithmetic_fault().empty(); });
  EXPECT_EQ(faults, 0);
}

}  // namespace
}  // namespace litmus

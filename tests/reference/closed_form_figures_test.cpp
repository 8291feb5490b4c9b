// closed_form_figures_test.cpp: areas, peaks and the rectangle's integral by other routes.
#include "reference/closed_form_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/closed_form_view.h"
#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

/// The mean of H/d over n x n cells of the rectangle: the sum over a grid of lamps. `corners` puts
/// them from edge to edge.
Exact grid_mean(std::array<Exact, 2> x, std::array<Exact, 2> y, Exact H, int n, bool corners) {
  Exact total = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Exact u = corners ? Exact(i) / (n - 1) : (i + 0.5L) / n,
                  v = corners ? Exact(j) / (n - 1) : (j + 0.5L) / n;
      const Exact px = x[0] + (x[1] - x[0]) * u, py = y[0] + (y[1] - y[0]) * v;
      total += H / std::sqrt(px * px + py * py + H * H);
    }
  return total / (Exact(n) * n);
}

constexpr std::array<Exact, 2> kX{-0.8L, 0.2L}, kY{-0.1L, 0.7L};
constexpr Exact kHeight = 1.5L;

TEST(RectangleMeanCosine, IsTheIntegralByGauss) {
  // Five-point Gauss-Legendre on 8 x 8 parts.
  constexpr std::array<Exact, 5> node{
      -0.906179845938663992797626878299L, -0.538469310105683091036314420700L, 0,
      0.538469310105683091036314420700L, 0.906179845938663992797626878299L},
      weight{0.236926885056189087514264040720L, 0.478628670499366468041291514836L,
             0.568888888888888888888888888889L, 0.478628670499366468041291514836L,
             0.236926885056189087514264040720L};
  Exact total = 0;
  constexpr int kParts = 8;
  for (int i = 0; i < kParts * 5; ++i)
    for (int j = 0; j < kParts * 5; ++j) {
      const auto at = [](std::array<Exact, 2> side, int part, Exact n) {
        const Exact width = (side[1] - side[0]) / kParts;
        return side[0] + (part + 0.5L + n / 2) * width;
      };
      const Exact x = at(kX, i / 5, node[std::size_t(i % 5)]),
                  y = at(kY, j / 5, node[std::size_t(j % 5)]);
      total += weight[std::size_t(i % 5)] * weight[std::size_t(j % 5)] * kHeight /
               std::sqrt(x * x + y * y + kHeight * kHeight);
    }
  EXPECT_NEAR(double(rectangle_mean_cosine(kX, kY, kHeight)), double(total / (4 * kParts * kParts)),
              1e-15);
}

TEST(RectangleMeanCosine, IsApproachedBySecondOrderFromCentresAndByFirstFromCorners) {
  const Exact exact = rectangle_mean_cosine(kX, kY, kHeight);
  for (const bool corners : {false, true}) {
    const Exact coarse = grid_mean(kX, kY, kHeight, 32, corners) - exact,
                fine = grid_mean(kX, kY, kHeight, 64, corners) - exact;
    EXPECT_NEAR(double(coarse / fine), corners ? 2 : 4, corners ? 0.05 : 0.01);
  }
}

TEST(RectangleMeanCosine, IsMetByRichardsonToTheFourthOrder) {
  const Exact exact = rectangle_mean_cosine(kX, kY, kHeight);
  const auto richardson = [&](int n) {
    return (4 * grid_mean(kX, kY, kHeight, 2 * n, false) - grid_mean(kX, kY, kHeight, n, false)) /
           3;
  };
  EXPECT_NEAR(double((richardson(8) - exact) / (richardson(16) - exact)), 16, 0.5);
  EXPECT_LE(std::fabs(double(richardson(32) - exact)), 1e-9);
}

TEST(RectangleMeanCosine, StaysWithinTheBoundOfTheMidpointRule) {
  for (int n = 1; n < 20; ++n) {
    const double hx = double(kX[1] - kX[0]) / n, hy = double(kY[1] - kY[0]) / n;
    const double bound = (hx * hx + hy * hy) / double(24 * kHeight * kHeight);
    EXPECT_LE(std::fabs(double(grid_mean(kX, kY, kHeight, n, false) -
                               rectangle_mean_cosine(kX, kY, kHeight))),
              bound);
  }
  // The corners' grid does not.
  EXPECT_GT(std::fabs(double(grid_mean(kX, kY, kHeight, 8, true) -
                             rectangle_mean_cosine(kX, kY, kHeight))),
            (1.0 / 64 + 0.64 / 64) / double(24 * kHeight * kHeight));
}

Scene wide_floor() {
  Scene scene;
  scene.width = scene.height = 300;
  scene.camera.projection = Projection::Orthographic;
  scene.camera.eye = {0, 0, 10}, scene.camera.up = {0, 1, 0}, scene.camera.height = 6;
  scene.materials = {{"matte", Color(1), Color(1), Color(0), 1}};
  scene.objects = {{"floor", Plane{}, 0}};
  return scene;
}

TEST(ShadowArea, IsThatOfThePixelsInsideTheCylinders) {
  Scene scene = wide_floor();
  scene.objects.push_back({"ball", Sphere{{0.3, 0.1, 1.2}, 0.6}, 0, false});
  scene.objects.push_back({"small", Sphere{{-1.2, -0.4, 0.7}, 0.2}, 0, false});
  scene.lights = {light_of(DirectionalLight{{-0.6, -0.35, -1}})};
  std::vector<Figure> figures;
  measure_shadow_area(scene, figures);
  ASSERT_EQ(figures.size(), 1u);
  const ExactVec sun = exact_lamps(scene.lights[0]).front().place;
  const Obstacles in_the_way = obstacles(scene, {glm::dvec3(sun), true});
  Picture picture(scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const auto seen = floor_point(scene.objects[0], sight(view_of(scene), x, y));
      const Way way = passage_through(in_the_way, {seen->at, sun, true}, &scene.objects[0]);
      picture.at(x, y) = glm::dvec3(way == Way::Blocked ? 0 : 1);
    }
  const double measured = figures[0].measure(picture);
  EXPECT_NEAR(measured, figures[0].exact, figures[0].tolerance);
  EXPECT_NEAR(measured, figures[0].exact, 0.01 * figures[0].exact);  // far inside the bound
  // The control: a shadow a tenth larger is not within it.
  EXPECT_GT(std::fabs(1.1 * measured - figures[0].exact), figures[0].tolerance);
}

TEST(HighlightPeak, IsWhereTheHalfVectorIsTheNormal) {
  Scene scene = wide_floor();
  scene.camera.eye = {-3, -4, 6}, scene.camera.up = {0, 0, 1};
  scene.materials[0].diffuse = Color(0);
  scene.lights = {light_of(PointLight{{0.9, 0.7, 2.2}, {}})};
  std::vector<Figure> figures;
  measure_highlight(scene, figures);
  ASSERT_EQ(figures.size(), 1u);
  Picture picture(scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const auto seen = floor_point(scene.objects[0], sight(view_of(scene), x, y));
      const ExactVec l = glm::normalize(ExactVec(0.9L, 0.7L, 2.2L) - seen->at);
      picture.at(x, y) = glm::dvec3(double(glm::normalize(l + seen->eye).z));
    }
  EXPECT_LE(figures[0].measure(picture), figures[0].tolerance);
  std::rotate(picture.pixels.begin(), picture.pixels.begin() + 2, picture.pixels.end());
  EXPECT_GT(figures[0].measure(picture), figures[0].tolerance);  // two pixels aside
}

TEST(Figures, RefuseScenesThatLackWhatTheyNeed) {
  Scene scene = wide_floor();
  std::vector<Figure> figures;
  EXPECT_THROW(measure_shadow_area(scene, figures), Refusal);
  EXPECT_THROW(measure_highlight(scene, figures), Refusal);  // a matte floor
  EXPECT_THROW(measure_rectangle_limit(scene, figures), Refusal);
}

}  // namespace
}  // namespace litmus

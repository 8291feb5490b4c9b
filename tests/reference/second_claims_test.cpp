// second_claims_test.cpp: the oracles of whole pictures and of figures on every scene that names
// them, by a route that shares nothing with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "reference/closed_form_surfaces.h"
#include "tests/reference/second_derivation.h"

namespace litmus {
namespace {

// ---- Darkness ----------------------------------------------------------------------------------

/// The solid angle of all the scene's triangles from a point, in full turns of 4 pi (van Oosterom
/// and Strackee 1983), each turned so that it faces away from `middle`.
double turns_around(const Scene& scene, const ExactVec& from, const ExactVec& middle) {
  Exact sum = 0;
  for (const Object& object : scene.objects) {
    const auto* mesh = std::get_if<Mesh>(&object.shape);
    if (!mesh) continue;
    for (const auto& [i, j, k] : mesh->triangles) {
      const ExactVec p(mesh->vertices[std::size_t(i)]), q(mesh->vertices[std::size_t(j)]),
          r(mesh->vertices[std::size_t(k)]);
      const Exact side = glm::dot(glm::cross(q - p, r - p), p - middle) < 0 ? -1 : 1;
      const ExactVec a = p - from, b = q - from, c = r - from;
      const Exact la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      sum +=
          side * 2 *
          std::atan2(glm::dot(a, glm::cross(b, c)), la * lb * lc + glm::dot(a, b) * lc +
                                                        glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
  }
  return double(sum / (4 * std::numbers::pi_v<Exact>));
}

/// A convex closed surface of triangles has the eye inside and the lamp outside.
bool walls_apart(const Scene& scene, const PlainLamp& lamp) {
  const ExactVec eye(scene.camera.eye);
  const ExactVec away = lamp.sun ? eye + lamp.place * Exact(1e6) : lamp.place;
  return std::fabs(turns_around(scene, eye, eye) - 1) < 1e-9 &&
         std::fabs(turns_around(scene, away, eye)) < 1e-9;
}

bool behind_all_planes(const Scene& scene, const PlainLamp& lamp) {
  for (const Object& object : scene.objects) {
    if (!object.camera_visible) continue;
    const auto* plane = std::get_if<Plane>(&object.shape);
    if (!plane) return false;
    const ExactVec n(plane->normal), p(plane->point);
    const Exact eye = glm::dot(ExactVec(scene.camera.eye) - p, n);
    const Exact there = lamp.sun ? glm::dot(lamp.place, n) : glm::dot(lamp.place - p, n);
    if (eye * there > 0) return false;
  }
  return true;
}

bool in_a_closed_ball(const Scene& scene, const PlainLamp& lamp) {
  return !lamp.sun && std::ranges::any_of(scene.objects, [&](const Object& object) {
    const auto* ball = std::get_if<Sphere>(&object.shape);
    return ball && glm::distance(lamp.place, ExactVec(ball->center)) < ball->radius &&
           glm::distance(scene.camera.eye, ball->center) > ball->radius;
  });
}

bool absorbed(const Scene& scene, const Light& light) {
  return std::ranges::all_of(scene.materials, [&](const Material& m) {
    return m.diffuse * light.diffuse == Color(0) && m.specular * light.specular == Color(0);
  });
}

/// Each light of a dark scene has no power, is of a colour that nothing reflects, is behind all
/// that is seen, or is shut off from the eye by a closed surface.
TEST(SecondDerivation, OfDark) {
  for (const Scene* scene : naming(Oracle::Dark))
    for (const Light& light : scene->lights) {
      if (light.intensity == 0 || absorbed(*scene, light)) continue;
      for (const PlainLamp& lamp : plain_lamps(light))
        EXPECT_TRUE(behind_all_planes(*scene, lamp) || in_a_closed_ball(*scene, lamp) ||
                    walls_apart(*scene, lamp))
            << scene->name << ", " << light.name;
    }
}

TEST(SecondDerivation, OfDarkNoticesAHoleInTheRoomAndALampInside) {
  Scene room = load_scene(find_scene("v6"));
  const PlainLamp sun = plain_lamps(room.lights[0])[0];
  EXPECT_TRUE(walls_apart(room, sun));
  EXPECT_FALSE(walls_apart(room, {false, ExactVec(0.3L, 0.2L, 1.5L)}));
  std::get<Mesh>(room.objects[0].shape).triangles.pop_back();
  EXPECT_FALSE(walls_apart(room, sun));
}

// ---- Ambient light ---------------------------------------------------------------------------

/// The scene with one source of ambient light alone: its own (0), or that of a light.
Scene with_one_source(Scene scene, std::size_t source) {
  if (source > 0) scene.ambient = Color(0);
  for (std::size_t k = 0; k < scene.lights.size(); ++k)
    if (k + 1 != source) scene.lights[k].ambient = Color(0);
  scene.expect = {Oracle::Ambient};
  return scene;
}

bool holds(const Scene& scene, const Color& value) {
  return *closed_form(scene).claims.at(0).holds(0, 0, value);
}

/// Ambient light adds up: a material's level is the sum of its levels in the scenes that have one
/// of the sources each, and each of these is the source times ka.
TEST(SecondDerivation, OfAmbient) {
  for (const Scene* scene : naming(Oracle::Ambient)) {
    Scene whole = *scene;
    whole.expect = {Oracle::Ambient};
    EXPECT_TRUE(holds(whole, Color(0))) << scene->name;
    for (const Object& object : scene->objects) {
      const Color ka = scene->materials[std::size_t(object.material)].ambient;
      Color sum(0);
      for (std::size_t source = 0; source <= scene->lights.size(); ++source) {
        const Color alone = ka * (source == 0 ? scene->ambient
                                              : scene->lights[source - 1].intensity *
                                                    scene->lights[source - 1].ambient);
        EXPECT_TRUE(holds(with_one_source(*scene, source), alone)) << scene->name;
        sum += alone;
      }
      EXPECT_TRUE(holds(whole, sum)) << scene->name;
      if (sum != Color(0)) {
        EXPECT_FALSE(holds(whole, sum * 1.0001)) << scene->name;
      }
    }
  }
}

// ---- Figures -----------------------------------------------------------------------------------

/// The area inside the outline of a projected great circle: the shoelace formula over 100,000
/// corners.
TEST(SecondDerivation, OfShadowArea) {
  for (const Scene* scene : naming(Oracle::ShadowArea)) {
    const ExactVec l = plain_lamps(scene->lights[0])[0].place;
    const ExactVec u = glm::normalize(glm::cross(l, ExactVec(1, 0, 0))), v = glm::cross(l, u);
    double area = 0;
    for (const Object& object : scene->objects) {
      const auto* ball = std::get_if<Sphere>(&object.shape);
      if (!ball) continue;
      constexpr int kCorners = 100'000;
      const auto corner = [&](int i) {
        const Exact t = 2 * std::numbers::pi_v<Exact> * i / kCorners;
        const ExactVec p =
            ExactVec(ball->center) + Exact(ball->radius) * (std::cos(t) * u + std::sin(t) * v);
        return p - p.z / l.z * l;
      };
      Exact twice = 0;
      for (int i = 0; i < kCorners; ++i) {
        const ExactVec a = corner(i), b = corner(i + 1);
        twice += a.x * b.y - a.y * b.x;
      }
      area += std::fabs(double(twice / 2));
    }
    for (const Figure& figure : closed_form(*scene).figures)
      if (figure.oracle == Oracle::ShadowArea) {
        EXPECT_NEAR(figure.exact, area, 1e-8) << scene->name;
      }
  }
}

/// A picture of (h.n) of each lamp, pixel by pixel, peaks within the figure's tolerance; moved by
/// two pixels it does not.
TEST(SecondDerivation, OfHighlightPeak) {
  for (const Scene* scene : naming(Oracle::Highlight)) {
    const ClosedFormView view = view_of(*scene);
    for (const Figure& figure : closed_form(*scene).figures) {
      if (figure.oracle != Oracle::Highlight) continue;
      const ExactVec lamp = plain_lamps(scene->lights[figure.layer - 1])[0].place;
      Picture picture(scene->width, scene->height);
      for (int y = 0; y < scene->height; ++y)
        for (int x = 0; x < scene->width; ++x) {
          const Sight ray = sight(view, x, y);
          const ExactVec at = ray.start - ray.start.z / ray.along.z * ray.along;
          const ExactVec l = glm::normalize(lamp - at);
          picture.at(x, y) =
              glm::dvec3(double((l.z - ray.along.z) / std::sqrt(2 - 2 * glm::dot(l, ray.along))));
        }
      EXPECT_LE(figure.measure(picture), figure.tolerance) << scene->name;
      std::rotate(picture.pixels.begin(), picture.pixels.begin() + 2, picture.pixels.end());
      EXPECT_GT(figure.measure(picture), figure.tolerance) << scene->name;
    }
  }
}

/// The mean of H/d over the picture and the rectangle, by Simpson's rule in the rectangle.
TEST(SecondDerivation, OfRectangleLimit) {
  for (const Scene* scene : naming(Oracle::RectangleLimit)) {
    const ClosedFormView view = view_of(*scene);
    for (const Figure& figure : closed_form(*scene).figures) {
      if (figure.oracle != Oracle::RectangleLimit) continue;
      const Light& light = scene->lights[figure.layer - 1];
      const AreaLight& area = std::get<AreaLight>(light.shape);
      constexpr int kParts = 8;  // intervals a side, Simpson's weights 1 4 2 4 ... 1
      Exact total = 0;
      for (int y = 0; y < scene->height; ++y)
        for (int x = 0; x < scene->width; ++x) {
          const Sight ray = sight(view, x, y);
          const ExactVec at = ray.start - ray.start.z / ray.along.z * ray.along;
          for (int i = 0; i <= kParts; ++i)
            for (int j = 0; j <= kParts; ++j) {
              const auto weight = [](int n) { return n % kParts == 0 ? 1 : n % 2 ? 4 : 2; };
              const ExactVec to = ExactVec(area.point.origin) - at +
                                  ExactVec((i / Exact(kParts) - 0.5L) * area.width,
                                           (j / Exact(kParts) - 0.5L) * area.height, 0);
              total += weight(i) * weight(j) * to.z / glm::length(to);
            }
        }
      const double mean = double(total / (9 * kParts * kParts)) / (scene->width * scene->height);
      const double scale = scene->materials[0].diffuse.x * light.diffuse.x * light.intensity;
      EXPECT_NEAR(figure.exact, scale * mean, 1e-5) << scene->name;
    }
  }
}

// ---- All of them -------------------------------------------------------------------------------

/// "shadow-curves" -> "OfShadowCurves"
std::string test_of(std::string_view oracle) {
  std::string name = "Of";
  bool upper = true;
  for (const char c : oracle) {
    if (c != '-') name += upper ? char(std::toupper(c)) : c;
    upper = c == '-';
  }
  return name;
}

TEST(SecondDerivation, IsThereForEveryOracle) {
  std::set<std::string> tests;
  const testing::TestSuite* suite = testing::UnitTest::GetInstance()->current_test_suite();
  for (int i = 0; i < suite->total_test_count(); ++i) tests.insert(suite->GetTestInfo(i)->name());
  for (const OracleName& oracle : oracle_names())
    EXPECT_TRUE(tests.contains(test_of(oracle.name))) << oracle.name;
  EXPECT_FALSE(tests.contains(test_of("no-such-oracle")));
}

}  // namespace
}  // namespace litmus

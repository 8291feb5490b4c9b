// second_derivation_test.cpp: every oracle on every scene that names it, by a route that shares
// nothing with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "exporters/area_grid.h"
#include "reference/closed_form.h"
#include "reference/closed_form_surfaces.h"
#include "scene/expect.h"
#include "scene/load.h"
#include "tests/reference/distance_march.h"

namespace litmus {
namespace {

const std::vector<Scene>& canonical() {
  static const std::vector<Scene> scenes = load_canonical_scenes().scenes;
  return scenes;
}

bool names(const Scene& scene, Oracle oracle) {
  return std::ranges::find(scene.expect, oracle) != scene.expect.end();
}

std::vector<const Scene*> naming(Oracle oracle) {
  std::vector<const Scene*> scenes;
  for (const Scene& scene : canonical())
    if (names(scene, oracle)) scenes.push_back(&scene);
  EXPECT_FALSE(scenes.empty()) << name_of(oracle);
  return scenes;
}

// ---- Pixels, by marching -----------------------------------------------------------------------

constexpr double kAgreement = 1e-6;  // of terms that are at most about 1: what marching resolves

/// The lamps of a light in double, an area light's by the exporters' own grid.
struct PlainLamp {
  bool sun = false;
  ExactVec place{0};
};
std::vector<PlainLamp> plain_lamps(const Light& light) {
  if (const auto* sun = std::get_if<DirectionalLight>(&light.shape))
    return {{true, glm::normalize(-ExactVec(sun->direction))}};
  if (const auto* point = std::get_if<PointLight>(&light.shape))
    return {{false, ExactVec(point->origin)}};
  if (const auto* spot = std::get_if<SpotLight>(&light.shape))
    return {{false, ExactVec(spot->point.origin)}};
  std::vector<PlainLamp> lamps;
  for (const Point& place : area_samples(std::get<AreaLight>(light.shape)))
    lamps.push_back({false, ExactVec(place)});
  return lamps;
}

/// Slides 11 and 16 in the README's form: 1/(1 + L x) 1/(1 + (Q x) x), x = d / Range, and the angle
/// by its cosine.
Exact weakened(const Light& light, const ExactVec& way, Exact d) {
  const Attenuation a = attenuation_of(light);
  const Exact x = d / Exact(a.range);
  Exact rest = 1 / (1 + a.linear * x) / (1 + (a.quadratic * x) * x);
  if (const auto* spot = std::get_if<SpotLight>(&light.shape)) {
    const Exact cosine =
        glm::dot(-way, ExactVec(spot->direction)) / glm::length(ExactVec(spot->direction));
    const Exact alpha = std::acos(std::clamp(cosine, Exact(-1), Exact(1)));
    rest *= alpha > spot->cutoff
                ? 0
                : -std::expm1(Exact(spot->exponent) * std::log(alpha / Exact(spot->cutoff)));
  }
  return rest;
}

/// A scene seen by marching.
class Walker {
 public:
  explicit Walker(const Scene& scene) : scene_(scene), view_(view_of(scene)) {
    for (const Object& object : scene.objects) solids_.push_back(solid_of(object));
    for (const Solid& solid : solids_) {
      casters_.push_back(&solid);
      if (solid.object->camera_visible) seen_.push_back(&solid);
    }
  }

  /// The terms at a pixel; nothing where the walk cannot tell, or meets another kind of shape.
  std::optional<PixelTerms> at(int x, int y) const {
    const Sight ray = sight(view_, x, y);
    const Exact near = 1e-6L * extent();
    const Marched met = march(seen_, ray.start, ray.along, 1e3L * extent(), near);
    if (met.end == Marched::End::Undecided) return std::nullopt;
    if (met.end == Marched::End::Clear) return PixelTerms{PixelTerms::Sees::Nothing, nullptr, {}};
    const ExactVec at = ray.start + met.far * ray.along;
    const ExactVec n = normal_at(*met.solid, at, -ray.along, near);
    PixelTerms terms{PixelTerms::Sees::Surface, met.solid->object, {}};
    for (const Light& light : scene_.lights) {
      const std::optional<ExactTerms> one = lit(light, met.solid, at, n, -ray.along, near);
      if (!one) return std::nullopt;
      terms.lights.push_back(*one);
    }
    return terms;
  }

 private:
  /// How large things are here: the distance from the eye to where it looks.
  Exact extent() const {
    return glm::distance(ExactVec(scene_.camera.eye), ExactVec(scene_.camera.target));
  }

  std::optional<ExactTerms> lit(const Light& light, const Solid* solid, const ExactVec& at,
                                const ExactVec& n, const ExactVec& eye, Exact near) const {
    ExactTerms sum;
    const std::vector<PlainLamp> lamps = plain_lamps(light);
    std::vector<const Solid*> others = casters_;
    std::erase(others, solid);
    for (const PlainLamp& lamp : lamps) {
      const Exact d = lamp.sun ? 1 : glm::distance(lamp.place, at);
      if (d < near) return std::nullopt;
      const ExactVec l = lamp.sun ? lamp.place : (lamp.place - at) / d;
      const Exact ln = glm::dot(l, n), en = glm::dot(eye, n);
      const Material& material = scene_.materials[std::size_t(solid->object->material)];
      const bool shiny = material.specular != Color(0);
      if (shiny && std::fabs(ln) < 1e-6) return std::nullopt;
      if (ln < 1e-9) continue;
      if (scene_.shadows) {
        const Marched way = march(others, at, l, lamp.sun ? 1e3L * extent() : d, near);
        if (way.end == Marched::End::Undecided) return std::nullopt;
        if (way.end == Marched::End::Met) continue;
      }
      const Exact rest = (lamp.sun ? 1 : weakened(light, l, d)) / Exact(lamps.size());
      sum.diffuse += rest * ln;
      // h.n without h: (l + e).n / |l + e|, with |l + e|^2 = 2 + 2 l.e.
      const Exact hn = (ln + en) / std::sqrt(2 + 2 * glm::dot(l, eye));
      if (shiny && hn > 0)
        sum.specular += rest * std::exp(Exact(material.shininess) * std::log(hn));
    }
    return sum;
  }

  const Scene& scene_;
  ClosedFormView view_;
  std::vector<Solid> solids_;
  std::vector<const Solid*> casters_, seen_;
};

/// Every so many-th of the pixels that see a surface of this shape, about `samples` of them.
template <class Shape>
std::vector<std::array<int, 2>> pixels_of(const Scene& scene, const SurfaceOracle& surfaces,
                                          int samples) {
  std::vector<std::array<int, 2>> all, some;
  for (int i = 0; i < scene.width * scene.height; i += 5) {
    const auto seen = surfaces.see(i % scene.width, i / scene.width);
    if (seen.sees == PixelTerms::Sees::Surface &&
        std::holds_alternative<Shape>(seen.point.object->shape))
      all.push_back({i % scene.width, i / scene.width});
  }
  const std::size_t stride = std::max<std::size_t>(1, all.size() / std::size_t(samples));
  for (std::size_t i = stride / 2; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

/// Compares about `samples` pixels of the scene; counts those that both sides know.
template <class Shape>
int compare_by_marching(const Scene& scene, int samples) {
  const SurfaceOracle surfaces(scene, scene.expect);
  const Walker walker(scene);
  int compared = 0;
  for (const auto& [x, y] : pixels_of<Shape>(scene, surfaces, samples)) {
    const PixelTerms exact = surfaces.at(x, y);
    const std::optional<PixelTerms> walked = walker.at(x, y);
    if (!walked) continue;
    EXPECT_EQ(walked->sees, PixelTerms::Sees::Surface) << scene.name << " " << x << " " << y;
    if (walked->sees != PixelTerms::Sees::Surface) continue;
    EXPECT_EQ(walked->object, exact.object) << scene.name << " " << x << " " << y;
    for (std::size_t k = 0; k < exact.lights.size(); ++k) {
      if (!exact.lights[k].sure) continue;
      EXPECT_NEAR(double(walked->lights[k].diffuse), double(exact.lights[k].diffuse), kAgreement)
          << scene.name << " " << x << " " << y << " " << scene.lights[k].name;
      EXPECT_NEAR(double(walked->lights[k].specular), double(exact.lights[k].specular),
                  1e3 * kAgreement)
          << scene.name << " " << x << " " << y << " " << scene.lights[k].name;
    }
    ++compared;
  }
  return compared;
}

/// Lookups of distances that a scene asks for: few pixels where there are many.
int samples_for(const Scene& scene) {
  std::size_t work = 0, lamps = 1;
  for (const Object& object : scene.objects) {
    const auto* mesh = std::get_if<Mesh>(&object.shape);
    work += mesh ? mesh->triangles.size() : 1;
  }
  for (const Light& light : scene.lights) lamps += plain_lamps(light).size();
  return std::clamp(int(400'000 / (work * lamps)), 12, 60);
}

template <class Shape>
void expect_shape_as_marched(Oracle oracle) {
  for (const Scene* scene : naming(oracle))
    EXPECT_GE(compare_by_marching<Shape>(*scene, samples_for(*scene)), 5) << scene->name;
}

TEST(SecondDerivation, OfFloor) { expect_shape_as_marched<Plane>(Oracle::Floor); }
TEST(SecondDerivation, OfSpheres) { expect_shape_as_marched<Sphere>(Oracle::Spheres); }
TEST(SecondDerivation, OfBoxes) { expect_shape_as_marched<Box>(Oracle::Boxes); }

/// The light of a lamp at the centre is spread over 4 pi r^2, whatever the point.
TEST(SecondDerivation, OfShell) {
  for (const Scene* scene : naming(Oracle::Shell)) {
    const Walker walker(*scene);
    const ClosedForm exact = closed_form(*scene);
    for (const int i : {0, 17, 211}) {
      const auto terms = walker.at(i % scene->width, i / scene->width % scene->height);
      ASSERT_TRUE(terms.has_value()) << scene->name;
      const Color kd = scene->materials[std::size_t(terms->object->material)].diffuse;
      for (std::size_t k = 0; k < scene->lights.size(); ++k) {
        const Light& light = scene->lights[k];
        EXPECT_NEAR(kd.x * light.diffuse.x * light.intensity * double(terms->lights[k].diffuse),
                    exact.layers[k + 1].picture.pixels[std::size_t(i)].x, kAgreement);
      }
    }
  }
}

TEST(SecondDerivation, OfMarchingNoticesWhatIsElsewhere) {
  Scene scene = load_scene(find_scene("d5"));
  const Walker before(scene);
  Scene moved = scene;
  std::get<Sphere>(moved.objects[1].shape).center.x += 0.5;
  const Walker after(moved);
  int different = 0;
  for (int i = 0; i < scene.width * scene.height; i += 61) {
    const auto a = before.at(i % scene.width, i / scene.width),
               b = after.at(i % scene.width, i / scene.width);
    if (a && b && std::fabs(a->lights[0].diffuse - b->lights[0].diffuse) > kAgreement) ++different;
  }
  EXPECT_GT(different, 3);
}

// ---- Boundaries --------------------------------------------------------------------------------

/// A claim about dark and lit pixels, at pixels whose light is found by marching.
void expect_claims_as_marched(Oracle oracle) {
  for (const Scene* scene : naming(oracle)) {
    const ClosedForm known = closed_form(*scene);
    const Walker walker(*scene);
    const int pixels = scene->width * scene->height;
    const int stride = std::max(1, pixels / samples_for(*scene)) | 1;
    int asked = 0;
    for (int i = stride / 2; i < pixels; i += stride) {
      const int x = i % scene->width, y = i / scene->width;
      const std::optional<PixelTerms> terms = walker.at(x, y);
      if (!terms || terms->sees != PixelTerms::Sees::Surface) continue;
      for (const Claim& claim : known.claims) {
        if (claim.oracle != oracle) continue;
        const Exact light = terms->lights[claim.layer - 1].diffuse;
        if (const auto holds = claim.holds(x, y, glm::dvec3(light > 0))) {
          EXPECT_TRUE(*holds) << scene->name << " " << x << " " << y;
          EXPECT_FALSE(*claim.holds(x, y, glm::dvec3(light <= 0)));
          ++asked;
        }
      }
    }
    EXPECT_GE(asked, 3) << scene->name;
  }
}

TEST(SecondDerivation, OfShadowCurves) { expect_claims_as_marched(Oracle::ShadowCurves); }
TEST(SecondDerivation, OfConeCurve) { expect_claims_as_marched(Oracle::ConeCurve); }

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

// second_derivation_test.cpp: the oracles of pixels and boundaries on every scene that names them,
// by marching, a route that shares nothing with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reference/closed_form_surfaces.h"
#include "tests/reference/distance_march.h"
#include "tests/reference/second_derivation.h"

namespace litmus {
namespace {

// ---- Pixels, by marching -----------------------------------------------------------------------

constexpr double kAgreement = 1e-6;  // of terms that are at most about 1: what marching resolves

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

}  // namespace
}  // namespace litmus

// closed_form_agreement_test.cpp: the tracer against all that is true without a renderer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "compare/regions.h"
#include "reference/closed_form.h"
#include "scene/bands.h"
#include "scene/expect.h"
#include "scene/load.h"
#include "tests/reports/pixel_condition.h"
#include "tracer/bands.h"
#include "tracer/render.h"

namespace litmus {
namespace {

const std::vector<Scene>& expecting() {
  static const std::vector<Scene> scenes = [] {
    std::vector<Scene> all = load_canonical_scenes().scenes;
    std::erase_if(all, [](const Scene& scene) { return scene.expect.empty(); });
    return all;
  }();
  return scenes;
}

const ClosedForm& closed_form_of(std::size_t i) {
  static std::vector<ClosedForm> forms = [] {
    std::vector<ClosedForm> all;
    for (const Scene& scene : expecting()) all.push_back(closed_form(scene));
    return all;
  }();
  return forms[i];
}

/// What a precision owes: an error of at most relative |v| + unit C, where C is the pixel's
/// condition number; and what it cannot hold at all.
struct Debt {
  double relative, unit, underflow;
  double most_excused;  ///< the part of a scene's pixels that may need more than the relative one
};
// Those are at the rims of cones and, in float, in the tails of c2's highlight.
constexpr Debt kDouble{1e-12, 0x1p-53, 0, 0.0005};
constexpr Debt kFloat{1e-5, 0x1p-24, 0x1p-126, 0.1};

/// The pixels of a scene that owe more, in the colours of `painted` (the scene, or three bands of
/// it). Condition numbers are computed where the relative part alone does not do.
class Debtors {
 public:
  Debtors(const Scene& scene, const Debt& debt) : scene_(scene), debt_(debt) {}

  /// How many owe more than both; of the others, those over the relative part are excused().
  int count(const Scene& painted, std::size_t layer, const Picture& ours,
            const ExpectedLayer& exact) {
    int debtors = 0;
    for (int y = 0; y < ours.height; ++y)
      for (int x = 0; x < ours.width; ++x) {
        const std::size_t i = std::size_t(y) * std::size_t(ours.width) + std::size_t(x);
        if (!exact.known[i]) continue;
        ++known_;
        const glm::dvec3 &truth = exact.picture.pixels[i], apart = ours.pixels[i] - truth;
        glm::dvec3 allowed = debt_.relative * glm::abs(truth) + debt_.underflow;
        if (within(apart, allowed)) continue;
        allowed += debt_.unit * condition(painted, layer, x, y);
        const bool owes = !within(apart, allowed);
        debtors += owes, excused_ += !owes;
      }
    return debtors;
  }
  /// The part of the pixels so far that are within their condition number only.
  double excused() const { return double(excused_) / double(std::max<std::int64_t>(known_, 1)); }

 private:
  static bool within(const glm::dvec3& apart, const glm::dvec3& allowed) {
    for (int c = 0; c < 3; ++c)
      if (!(std::fabs(apart[c]) <= allowed[c])) return false;
    return true;
  }

  /// Of a layer's value, from those of its terms; ambient light has none.
  glm::dvec3 condition(const Scene& painted, std::size_t layer, int x, int y) {
    if (layer == 0 || std::ranges::find(scene_.expect, Oracle::Shell) != scene_.expect.end())
      return glm::dvec3(0);
    if (!conditions_) conditions_.emplace(scene_);
    const auto [object, terms] = conditions_->at(x, y, layer - 1);
    if (!object) return glm::dvec3(0);
    const Material& material = painted.materials[std::size_t(object->material)];
    const Light& light = painted.lights[layer - 1];
    return light.intensity * (material.diffuse * light.diffuse * terms.diffuse +
                              material.specular * light.specular * terms.specular);
  }

  const Scene& scene_;
  Debt debt_;
  std::optional<PixelCondition> conditions_;
  std::int64_t known_ = 0, excused_ = 0;
};

/// The scene in the colours of each of its pictures, with ours and the known ones.
struct Painted {
  Scene scene;
  Layers ours;
  const std::vector<ExpectedLayer>* exact;
};
std::vector<Painted> painted(std::size_t i, const BandRendering& ours) {
  const Scene& scene = expecting()[i];
  const ClosedForm& exact = closed_form_of(i);
  if (exact.layers.empty()) return {};
  if (!scene.spectra) return {{scene, ours.rendering.layers, &exact.layers}};
  std::vector<Painted> all;
  const std::vector<Scene> bands = band_scenes(scene);
  for (std::size_t p = 0; p < bands.size(); ++p)
    all.push_back({bands[p], ours.pictures[p], &exact.bands[p]});
  return all;
}

BandRendering rendered(const Scene& scene, Precision precision) {
  RenderOptions options;
  options.precision = precision;
  return render_bands(scene, options, KeepBands::Layers);
}

TEST(ClosedFormAgreement, OfEveryKnownPixelInDoubleIsRelativeTo1eMinus12) {
  std::int64_t known = 0;
  for (std::size_t i = 0; i < expecting().size(); ++i) {
    Debtors debtors(expecting()[i], kDouble);
    for (const Painted& one : painted(i, rendered(expecting()[i], Precision::Double)))
      for (std::size_t k = 0; k < one.exact->size(); ++k) {
        const ExpectedLayer& exact = (*one.exact)[k];
        EXPECT_EQ(debtors.count(one.scene, k, one.ours[k].picture, exact), 0)
            << one.scene.name << ", " << one.ours[k].light;
        known += std::count(exact.known.begin(), exact.known.end(), 1);
      }
    EXPECT_LE(debtors.excused(), kDouble.most_excused) << expecting()[i].name;
  }
  EXPECT_GT(known, 500'000);
}

/// Single precision misplaces edges: those are left out.
TEST(ClosedFormAgreement, OfTheInteriorInFloatIsRelativeTo1eMinus5) {
  for (std::size_t i = 0; i < expecting().size(); ++i) {
    const Rendering in_double = render(expecting()[i]);
    Debtors debtors(expecting()[i], kFloat);
    for (const Painted& one : painted(i, rendered(expecting()[i], Precision::Float)))
      for (std::size_t k = 0; k < one.exact->size(); ++k) {
        ExpectedLayer interior = (*one.exact)[k];
        const std::vector<std::uint8_t> edge = edge_mask(in_double.signatures[k]);
        for (std::size_t p = 0; p < edge.size(); ++p) interior.known[p] &= !edge[p];
        EXPECT_EQ(debtors.count(one.scene, k, one.ours[k].picture, interior), 0)
            << one.scene.name << ", " << one.ours[k].light;
      }
    EXPECT_LE(debtors.excused(), kFloat.most_excused) << expecting()[i].name;
  }
}

/// The closed form, but brighter by a part of its value at every seventh pixel.
Picture brightened(const ExpectedLayer& exact, double part) {
  Picture picture = exact.picture;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 7) picture.pixels[i] *= 1 + part;
  return picture;
}

/// The control: light that is brighter by twice the relative part is noticed in every scene, as a
/// debt or as too many excuses.
TEST(ClosedFormAgreement, NoticesLightThatIsBrighterByTwiceTheRelativePart) {
  for (const Debt& debt : {kDouble, kFloat}) {
    int all = 0;
    for (std::size_t i = 0; i < expecting().size(); ++i) {
      const Scene& scene = expecting()[i];
      if (closed_form_of(i).layers.empty() || scene.spectra) continue;
      Debtors debtors(scene, debt);
      const ExpectedLayer& exact = closed_form_of(i).layers.back();
      const auto& pixels = exact.picture.pixels;
      if (std::ranges::none_of(pixels, [](const glm::dvec3& p) { return p.x > 1e-3; })) continue;
      const Picture picture = brightened(exact, 2 * debt.relative);
      const int owing = debtors.count(scene, scene.lights.size(), picture, exact);
      EXPECT_TRUE(owing > 0 || debtors.excused() > debt.most_excused) << scene.name << debt.unit;
      ++all;
    }
    EXPECT_GE(all, 40) << debt.unit;
  }
}

TEST(ClosedFormAgreement, HoldsForEveryClaimAndFigure) {
  int claims = 0, figures = 0;
  for (std::size_t i = 0; i < expecting().size(); ++i) {
    const Rendering ours = render(expecting()[i]);
    for (const Claim& claim : closed_form_of(i).claims) {
      int wrong = 0, asked = 0;
      const Picture& picture = ours.layers[claim.layer].picture;
      for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
          if (const auto holds = claim.holds(x, y, picture.at(x, y))) ++asked, wrong += !*holds;
      EXPECT_EQ(wrong, 0) << expecting()[i].name << ", " << name_of(claim.oracle);
      EXPECT_GT(asked, 100) << expecting()[i].name << ", " << name_of(claim.oracle);
      ++claims;
    }
    for (const Figure& figure : closed_form_of(i).figures) {
      const double measured = figure.measure(ours.layers[figure.layer].picture);
      EXPECT_NEAR(measured, figure.exact, figure.tolerance)
          << expecting()[i].name << ", " << name_of(figure.oracle);
      ++figures;
    }
  }
  EXPECT_GT(claims, 10);
  EXPECT_GT(figures, 0);
}

}  // namespace
}  // namespace litmus

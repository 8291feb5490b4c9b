// closed_form.cpp: from the names in a scene's [expect] table to what they say.
#include "reference/closed_form.h"

#include <algorithm>
#include <array>

#include "reference/closed_form_claims.h"
#include "reference/closed_form_figures.h"
#include "reference/closed_form_pictures.h"
#include "scene/bands.h"
#include "scene/observer.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

void refuse_what_has_none(const Scene& scene) {
  if (scene.samples > 1)
    throw Refusal(scene.name + ": expect: closed forms are of pixels with one sample");
  if (scene.shading != Shading::Equation)
    throw Refusal(scene.name + ": expect: closed forms are of the equation, not the sample code");
}

/// The layers in linear sRGB, from those of each three bands.
std::vector<ExpectedLayer> in_colors(const Spectra& spectra,
                                     const std::vector<std::vector<ExpectedLayer>>& bands) {
  std::vector<ExpectedLayer> layers = bands.front();
  for (std::size_t k = 0; k < layers.size(); ++k) {
    Picture& colors = layers[k].picture;
    colors = Picture(colors.width, colors.height);
    for (std::size_t p = 0; p < bands.size(); ++p)
      add_xyz(spectra, int(p), bands[p][k].picture, colors);
    for (glm::dvec3& pixel : colors.pixels) pixel = linear_srgb(pixel);
  }
  return layers;
}

/// What the oracles of whole layers know.
void fill_layers(const Scene& scene, ClosedForm& known) {
  constexpr std::array kSurfaces{Oracle::Floor, Oracle::Spheres, Oracle::Boxes};
  const auto named = [&](Oracle oracle) {
    return std::find(scene.expect.begin(), scene.expect.end(), oracle) != scene.expect.end();
  };
  const bool surfaces = std::any_of(kSurfaces.begin(), kSurfaces.end(), named);
  if (!surfaces && !named(Oracle::Shell) && !named(Oracle::Dark)) return;
  Canvas canvas = canvas_of(scene);
  if (surfaces) expect_surfaces(scene, scene.expect, canvas);
  if (named(Oracle::Shell)) expect_shell(scene, canvas);
  if (named(Oracle::Dark)) expect_darkness(canvas);
  if (!scene.spectra) {
    known.layers = std::move(canvas.pictures.front());
    return;
  }
  known.layers = in_colors(*scene.spectra, canvas.pictures);
  known.bands = std::move(canvas.pictures);
}

}  // namespace

ClosedForm closed_form(const Scene& scene) {
  if (scene.expect.empty()) return {};
  refuse_what_has_none(scene);
  ClosedForm known;
  fill_layers(scene, known);
  for (const Oracle oracle : scene.expect) {
    switch (oracle) {
      case Oracle::Ambient:
        claim_ambient_levels(scene, known.claims);
        break;
      case Oracle::Floor:
      case Oracle::Spheres:
      case Oracle::Boxes:
      case Oracle::Shell:
      case Oracle::Dark:
        break;  // whole layers
      case Oracle::ShadowCurves:
        claim_shadow_curves(scene, known.claims);
        break;
      case Oracle::ConeCurve:
        claim_cone_curves(scene, known.claims);
        break;
      case Oracle::ShadowArea:
        measure_shadow_area(scene, known.figures);
        break;
      case Oracle::Highlight:
        measure_highlight(scene, known.figures);
        break;
      case Oracle::RectangleLimit:
        measure_rectangle_limit(scene, known.figures);
        break;
    }
  }
  return known;
}

}  // namespace litmus

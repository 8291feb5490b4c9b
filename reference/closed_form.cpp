// closed_form.cpp: from the names in a scene's [expect] table to what they say.
#include "reference/closed_form.h"

#include <fmt/format.h>

#include "reference/closed_form_claims.h"
#include "reference/closed_form_figures.h"
#include "reference/closed_form_pictures.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

constexpr std::size_t kMostTriangles = 2500;  // which are tried one by one, at every pixel

std::vector<ExpectedLayer> unknown_layers(const Scene& scene) {
  const ExpectedLayer unknown{
      Picture(scene.width, scene.height),
      std::vector<std::uint8_t>(std::size_t(scene.width) * std::size_t(scene.height))};
  return std::vector<ExpectedLayer>(1 + scene.lights.size(), unknown);
}

void refuse_what_has_none(const Scene& scene) {
  if (scene.samples > 1)
    throw Refusal(scene.name + ": expect: closed forms are of pixels with one sample");
  if (scene.shading != Shading::Equation)
    throw Refusal(scene.name + ": expect: closed forms are of the equation, not the sample code");
}

void refuse_large_meshes(const Scene& scene) {
  for (const Object& object : scene.objects)
    if (const auto* mesh = std::get_if<Mesh>(&object.shape);
        mesh && mesh->triangles.size() > kMostTriangles)
      throw Refusal(fmt::format("{}: expect: \"{}\" has over {} triangles", scene.name, object.name,
                                kMostTriangles));
}

}  // namespace

ClosedForm closed_form(const Scene& scene) {
  if (scene.expect.empty()) return {};
  refuse_what_has_none(scene);
  ClosedForm known;
  const auto layers = [&]() -> std::vector<ExpectedLayer>& {
    refuse_large_meshes(scene);
    if (known.layers.empty()) known.layers = unknown_layers(scene);
    return known.layers;
  };
  for (const Oracle oracle : scene.expect) {
    switch (oracle) {
      case Oracle::Ambient:
        claim_ambient_levels(scene, known.claims);
        break;
      case Oracle::Floor:
        expect_floor(scene, layers());
        break;
      case Oracle::Spheres:
        expect_spheres(scene, layers());
        break;
      case Oracle::Shell:
        expect_shell(scene, layers());
        break;
      case Oracle::Dark:
        expect_darkness(scene, layers());
        break;
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

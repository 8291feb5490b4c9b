// wavelength_figure.cpp: one chart under two illuminants, by bands and by RGB products.
#include "reports/wavelength_figure.h"

#include <fmt/format.h>

#include "reports/panels.h"
#include "scene/observer.h"

namespace litmus {
namespace {

/// The chart in the first light's place, with an illuminant's colour.
Scene lit_by(Scene scene, const Spectrum& power) {
  Spectra& spectra = *scene.spectra;
  const std::vector<double> bands = band_means(power, spectra.bands);
  const std::vector<double> none(bands.size());
  scene.lights.resize(1), spectra.lights = {{none, bands, bands}};
  glm::dvec3 xyz(0);
  for (std::size_t b = 0; b < bands.size(); ++b) xyz += bands[b] * spectra.xyz[b];
  scene.lights[0].diffuse = scene.lights[0].specular = linear_srgb(xyz);
  return scene;
}

}  // namespace

GalleryFigure wavelength_figure(int threads) {
  GalleryFigure figure{"slides 2-5", "Light per wavelength against red, green and blue", "", {}};
  const Scene chart = panel_scene("w2");
  std::string errors;
  for (const char* name : {"D65", "A"}) {
    Scene scene = lit_by(chart, illuminant(name).spectrum);
    const Picture spectral = rendered(scene, threads).whole;
    const int bands = scene.spectra->bands;
    scene.spectra.reset();  // what is left are the RGB colours of tiles in D65 and of the light
    const Picture product = rendered(scene, threads).whole;
    const Picture error = apart(product, spectral);
    figure.panels.push_back(panel(fmt::format("{}: {} bands", name, bands), spectral));
    figure.panels.push_back(panel(fmt::format("{}: product of RGB colours", name), product));
    figure.panels.push_back(
        panel(fmt::format("{}: |product - bands|, at most {:.3f}", name, brightest(error)), error));
    errors += fmt::format("{}{:.3f} under {}", errors.empty() ? "" : ", ", brightest(error), name);
  }
  figure.caption =
      "The CIE's eight test colours under daylight and under a lamp. A renderer that multiplies "
      "RGB "
      "colours, each tile as it looks in D65, is wrong by up to " +
      errors + ".";
  return figure;
}

}  // namespace litmus

// load_spectra.cpp: a scene's colours per wavelength band, and the RGB colours that stand in.
#include <algorithm>
#include <functional>

#include "scene/load_parts.h"
#include "scene/observer.h"
#include "scene/palette.h"

namespace litmus {
namespace {

bool names_spectrum(const Fields& fields, std::string_view key) {
  const Node* node = fields.find(key);
  return node && std::holds_alternative<std::string>(node->value);
}

bool names_spectrum(const Fields& fields) {
  return names_spectrum(fields, "ambient") || names_spectrum(fields, "diffuse") ||
         names_spectrum(fields, "specular") || names_spectrum(fields, "color");
}

/// Turns the colours of a scene into bands.
struct Painter {
  const Palette& palette;
  int bands;
  std::string& note;

  /// `color` is what the RGB reading made of the key, which stands for a number or a default.
  std::vector<double> paint(const Fields& fields, std::string_view key, const Color& color) const {
    if (!names_spectrum(fields, key)) {
      if (color.x != color.y || color.y != color.z)
        fields.refuse(key,
                      "three numbers are no spectrum, and this scene is rendered per wavelength "
                      "because it names one; give a number or a spectrum's name");
      return std::vector<double>(std::size_t(bands), color.x);
    }
    const std::string name = fields.text(key);
    const Spectrum* spectrum = palette.find(name);
    if (!spectrum) fields.refuse_word(key, name, palette.names());
    if (const auto found = palette.notes.find(name); found != palette.notes.end())
      note = found->second;
    return band_means(*spectrum, bands);
  }
};

/// Linear sRGB of a power per band, times a reflectance per band where there is one.
Color stand_in(const std::vector<glm::dvec3>& xyz, const std::vector<double>& power,
               const std::vector<double>* reflectance = nullptr) {
  glm::dvec3 sum(0);
  for (std::size_t b = 0; b < xyz.size(); ++b)
    sum += xyz[b] * power[b] * (reflectance ? (*reflectance)[b] : 1.0);
  return glm::max(linear_srgb(sum), Color(0));
}

/// The RGB colours that a renderer without wavelengths would take.
void set_stand_ins(Scene& scene, const std::vector<double>& white) {
  const Spectra& spectra = *scene.spectra;
  const auto reflect = [&](const std::vector<double>& bands, Color& color) {
    if (std::adjacent_find(bands.begin(), bands.end(), std::not_equal_to<>()) != bands.end())
      color = stand_in(spectra.xyz, white, &bands);
  };
  scene.ambient = stand_in(spectra.xyz, spectra.ambient);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    reflect(spectra.materials[i].ambient, scene.materials[i].ambient);
    reflect(spectra.materials[i].diffuse, scene.materials[i].diffuse);
    reflect(spectra.materials[i].specular, scene.materials[i].specular);
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    scene.lights[i].ambient = stand_in(spectra.xyz, spectra.lights[i].ambient);
    scene.lights[i].diffuse = stand_in(spectra.xyz, spectra.lights[i].diffuse);
    scene.lights[i].specular = stand_in(spectra.xyz, spectra.lights[i].specular);
  }
}

bool is_spectral(const Fields& root) {
  bool any = names_spectrum(root, "ambient");
  for (const char* kind : {"material", "light"})
    for (const Node& node : root.tables(kind))
      any = any || names_spectrum(Fields(root.file(), node, kind));
  for (const char* key : {"bands", "spectra"})
    if (!any && root.has(key))
      root.refuse(key, "no colour of this scene names a spectrum; name one or leave this out");
  return any;
}

}  // namespace

void read_spectra(const Fields& root, Scene& scene) {
  if (!is_spectral(root)) return;
  Spectra& spectra = scene.spectra.emplace();
  spectra.bands = root.integer("bands", 1, kMostBands, kDefaultBands);
  const Palette palette = read_palette(root);
  const Painter painter{palette, spectra.bands, spectra.note};
  spectra.ambient = painter.paint(root, "ambient", scene.ambient);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Fields fields(root.file(), root.tables("material")[i], "a material");
    const Material& material = scene.materials[i];
    spectra.materials.push_back({painter.paint(fields, "ambient", material.ambient),
                                 painter.paint(fields, "diffuse", material.diffuse),
                                 painter.paint(fields, "specular", material.specular)});
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Fields fields(root.file(), root.tables("light")[i], "a light");
    const Light& light = scene.lights[i];
    const bool one = fields.has("color");
    spectra.lights.push_back({painter.paint(fields, "ambient", light.ambient),
                              painter.paint(fields, one ? "color" : "diffuse", light.diffuse),
                              painter.paint(fields, one ? "color" : "specular", light.specular)});
  }
  if (!spectra.note.empty()) scene.warnings.push_back(spectra.note);
  const Observer observer = cie_1931_observer();
  if (!observer.note.empty()) scene.warnings.push_back(observer.note);
  const Spectrum& white = *palette.find("D65");
  spectra.xyz = band_xyz(observer, white, spectra.bands);
  set_stand_ins(scene, band_means(white, spectra.bands));
}

}  // namespace litmus

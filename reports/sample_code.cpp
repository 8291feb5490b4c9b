// sample_code.cpp: slide 5's equation against its sample code, light by light and scene by scene.
#include "reports/sample_code.h"

#include <fmt/format.h>

#include "reports/panels.h"
#include "reports/plain_text.h"
#include "scene/load.h"

namespace litmus {
namespace {

/// A scene in both readings.
struct Readings {
  Rendering equation, code;
};

Readings both(Scene scene, int threads) {
  scene.shading = Shading::Equation;
  Rendering equation = rendered(scene, threads);
  scene.shading = Shading::SampleCode;
  return {std::move(equation), rendered(scene, threads)};
}

GalleryFigure side_by_side(const std::string& title, const std::string& why,
                           const Picture& equation, const Picture& code) {
  const Picture difference = apart(code, equation);
  const std::string figure =
      fmt::format("The largest difference is {:.3g}.", brightest(difference));
  return {"slide 5",
          clean_text(title),
          why.empty() ? figure : why + " " + figure,
          {panel("equation", equation), panel("sample code", code),
           panel("|code - equation|", difference)}};
}

/// Why the code differs for a light of this type in a scene with ambient light.
std::string why_of(const std::string& type) {
  if (type == "ambient")
    return "The equation adds ambient light once; the code adds it with each light in view.";
  if (type == "area")
    return "To the code an area light is a list of lights, and each sample in view adds the "
           "ambient "
           "light anew.";
  if (type == "spot")
    return "The code adds the ambient light wherever nothing hides the lamp, outside its cone, "
           "too.";
  return "The code adds the ambient light wherever nothing hides the lamp.";
}

struct Made {
  const char *id, *why;
};

/// Canonical scenes that isolate a difference.
constexpr Made kMade[] = {
    {"a2",
     "Lights of intensity 0 leave the equation's ambient light as it is; the code adds it once "
     "for each of them."},
    {"a3", "In full shadow the equation keeps the ambient light; the code has none there."},
    {"d6",
     "The light is behind the surface: the equation adds nothing, the code's specular term "
     "still shines."},
    {"c2",
     "A light with a red diffuse and a blue specular colour: the code's highlight takes the "
     "diffuse colour."},
};

/// The canonical scene with this id; empty if there is none.
std::string scene_of(const std::string& id) {
  for (const std::filesystem::path& file : canonical_scenes())
    if (file.stem().string().starts_with(id + "-")) return file.stem().string();
  return "";
}

}  // namespace

std::vector<GalleryFigure> sample_code_figures(int threads) {
  std::vector<GalleryFigure> figures;
  const Readings all = both(panel_scene("x5"), threads);
  figures.push_back(side_by_side("Every type of light",
                                 "The code adds the ambient light once for every light in view, "
                                 "colours highlights by the diffuse colour and lets them shine "
                                 "where the light is behind the surface.",
                                 all.equation.whole, all.code.whole));
  for (std::size_t k = 0; k < all.code.layers.size(); ++k) {
    const Layer &equation = all.equation.layers[k], &code = all.code.layers[k];
    const std::string title = code.light_type == "ambient"
                                  ? "Ambient light alone"
                                  : fmt::format("{} ({} light)", code.light, code.light_type);
    figures.push_back(side_by_side(title, why_of(code.light_type), equation.picture, code.picture));
  }
  for (const Made& made : kMade) {
    const std::string name = scene_of(made.id);
    if (name.empty()) continue;
    const Readings readings = both(panel_scene(name), threads);
    figures.push_back(
        side_by_side("Scene " + name, made.why, readings.equation.whole, readings.code.whole));
  }
  return figures;
}

}  // namespace litmus

// explain.cpp: litmus explain, the equation of one pixel with numbers.
#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/explain_text.h"
#include "cli/work_folder.h"
#include "reference/band_images.h"
#include "scene/bands.h"
#include "scene/load.h"
#include "scene/refusal.h"
#include "scene/spectrum.h"

namespace litmus {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNone = "none";

struct ExplainArguments {
  std::string scene, light, sources = "auto";
  std::vector<std::string> references;
  std::filesystem::path store = default_store_directory();
  int x = 0, y = 0;
  double wavelength = 0;  ///< nm; 0: not given
  bool json = false;
};

// ---- Wavelength ------------------------------------------------------------------------------

constexpr double kGreen = 555;  // nm, where the eye sees most

/// Which picture of three bands shows the wavelength.
int picture_at(const Spectra& spectra, double wavelength) {
  const double part = (wavelength - kFirstWavelength) / (kLastWavelength - kFirstWavelength);
  return std::min(int(part * spectra.bands), spectra.bands - 1) / 3;
}

// ---- References ------------------------------------------------------------------------------

std::vector<const Driver*> chosen_drivers(const std::vector<std::string>& names) {
  std::vector<const Driver*> chosen;
  for (const Driver& driver : drivers()) {
    if (names.empty() || std::find(names.begin(), names.end(), driver.name) != names.end())
      chosen.push_back(&driver);
  }
  return chosen;
}

/// `layers` are those of `obtained`, or of a spectral scene those of the bands that are explained.
ReferencePixel pixel_of(const Driver& driver, const ObtainedReference& obtained,
                        const Layers& layers, int x, int y) {
  ReferencePixel pixel{driver.name,
                       driver.title,
                       obtained.source,
                       obtained.version,
                       obtained.failure,
                       obtained.skipped,
                       {}};
  for (const Layer& layer : layers) pixel.layers.push_back(layer.picture.at(x, y));
  return pixel;
}

Layers explained_layers(const Scene& scene, const Layers& layers, int picture) {
  if (!scene.spectra || layers.empty()) return layers;
  return band_layers(scene, layers)[std::size_t(picture)];
}

/// All references at the same time, from the store where it has them. `picture` counts the three
/// bands of a spectral scene that are explained.
std::vector<ReferencePixel> reference_pixels(const Scene& scene, int picture,
                                             const ExplainArguments& options) {
  const std::vector<const Driver*> chosen = chosen_drivers(options.references);
  if (chosen.empty()) return {};
  const WorkFolder work;
  Store store;
  ObtainOptions obtain_options;
  obtain_options.sources = parse_sources(options.sources);
  obtain_options.program_version = LITMUS_VERSION;
  obtain_options.reference.work = work.path;
  obtain_options.reference.progress = [](const std::string& line) {
    fmt::print(stderr, "{}\n", line);
  };
  if (obtain_options.sources != Sources::Stored) {
    store = open_store(options.store,
                       [](const std::string& line) { fmt::print(stderr, "warning: {}\n", line); });
    obtain_options.store = &store;
  }
  std::vector<std::future<ReferencePixel>> running;
  for (const Driver* driver : chosen) {
    running.push_back(std::async(std::launch::async, [&, driver] {
      const ObtainedReference obtained = obtain({&scene, 1}, *driver, obtain_options).front();
      return pixel_of(*driver, obtained, explained_layers(scene, obtained.layers, picture),
                      options.x, options.y);
    }));
  }
  std::vector<ReferencePixel> pixels;
  for (auto& each : running) pixels.push_back(each.get());
  return pixels;
}

// ---- JSON ------------------------------------------------------------------------------------

Json json_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json json_of(const Scene& scene, const Light& source, const LampExplanation& lamp) {
  Json entry{{"vector_l", json_of(lamp.l)}, {"vector_h", json_of(lamp.h)}};
  for (const Term& term : terms()) {
    if (term.applies(scene, source)) entry[std::string(term.name)] = lamp.*term.member;
  }
  entry["attenuation"] = lamp.attenuation;
  entry["intensity"] = lamp.intensity;
  if (lamp.blocker >= 0) entry["blocked_by"] = scene.objects[std::size_t(lamp.blocker)].name;
  entry["reason"] = gate_reason(lamp.gate);
  return entry;
}

Json json_of(const Scene& scene, const Light& source, const LightExplanation& light) {
  Json entry{{"light", light.name},
             {"type", light.type},
             {"Id", json_of(light.light_diffuse)},
             {"Is", json_of(light.light_specular)},
             {"D", light.diffuse},
             {"S", light.specular},
             {"visibility", mean(light, &LampExplanation::visibility)},
             {"ambient", json_of(light.ambient_color)},
             {"diffuse", json_of(light.diffuse_color)},
             {"specular", json_of(light.specular_color)},
             {"color", json_of(light.color)},
             {"lamps", Json::array()}};
  for (const LampExplanation& lamp : light.lamps)
    entry["lamps"].push_back(json_of(scene, source, lamp));
  return entry;
}

Json json_of(const ReferencePixel& reference, const Explanation& pixel) {
  Json entry{{"reference", reference.name},  {"source", reference.source},
             {"version", reference.version}, {"failure", reference.failure},
             {"skipped", reference.skipped}, {"layers", Json::array()}};
  for (std::size_t k = 0; k < reference.layers.size(); ++k) {
    entry["layers"].push_back({{"value", json_of(reference.layers[k])},
                               {"residual", json_of(pixel.layers[k] - reference.layers[k])}});
  }
  return entry;
}

Json json_of(const Scene& scene, const Explanation& pixel,
             std::span<const ReferencePixel> references, const std::string& light) {
  const Material& material = pixel.material;
  Json result{{"scene", scene.name},
              {"pixel", {pixel.x, pixel.y}},
              {"samples", pixel.samples},
              {"shading", scene.shading == Shading::Equation ? "equation" : "sample-code"},
              {"hit", pixel.hit}};
  if (pixel.hit) {
    result["object"] = scene.objects[std::size_t(pixel.object)].name;
    result["material"] = {{"name", material.name},
                          {"ka", json_of(material.ambient)},
                          {"kd", json_of(material.diffuse)},
                          {"ks", json_of(material.specular)},
                          {"ns", material.shininess}};
    result["t"] = pixel.t;
    result["point"] = json_of(pixel.point);
    result["normal"] = json_of(pixel.normal);
    result["geometric_normal"] = json_of(pixel.geometric);
    result["eye"] = json_of(pixel.e);
  }
  result["ambient"] = {{"Ia", json_of(pixel.ambient)}, {"color", json_of(pixel.ambient_color)}};
  result["lights"] = Json::array();
  for (std::size_t i = 0; i < pixel.lights.size(); ++i) {
    if (light.empty() || light == "all" || light == pixel.lights[i].name)
      result["lights"].push_back(json_of(scene, scene.lights[i], pixel.lights[i]));
  }
  result["whole"] = json_of(pixel.whole);
  result["picture"] = json_of(pixel.picture);
  result["layers"] = Json::array();
  for (std::size_t k = 0; k < pixel.layers.size(); ++k) {
    result["layers"].push_back({{"light", k == 0 ? "ambient" : scene.lights[k - 1].name},
                                {"value", json_of(pixel.layers[k])}});
  }
  result["references"] = Json::array();
  for (const ReferencePixel& reference : references)
    result["references"].push_back(json_of(reference, pixel));
  return result;
}

// ---- The command -----------------------------------------------------------------------------

void check_light(const Scene& scene, const std::string& name) {
  if (name.empty() || name == "all" || name == "ambient") return;
  std::string names = "all, ambient";
  for (const Light& light : scene.lights) {
    if (light.name == name) return;
    names += ", " + light.name;
  }
  throw Refusal(fmt::format("--light: {} has no light \"{}\"; it has {}", scene.name, name, names));
}

int run_explain(const ExplainArguments& options) {
  const Scene loaded = load_scene(find_scene(options.scene));
  check_light(loaded, options.light);
  if (!loaded.spectra && options.wavelength > 0)
    throw Refusal(fmt::format("--wavelength: {} names no spectrum", loaded.name));
  int picture = 0;
  Scene scene = loaded;
  if (loaded.spectra) {
    picture = picture_at(*loaded.spectra, options.wavelength > 0 ? options.wavelength : kGreen);
    scene = band_scenes(loaded)[std::size_t(picture)];
    fmt::print(stderr, "note: {} has spectra: r, g and b are the bands of {} (--wavelength)\n",
               loaded.name, band_range(*loaded.spectra, picture));
  }
  const Explanation pixel = explain(scene, options.x, options.y);
  const std::vector<ReferencePixel> references = reference_pixels(loaded, picture, options);
  if (options.json) {
    std::cout << json_of(scene, pixel, references, options.light).dump(2) << '\n';
  } else {
    std::cout << explanation_text(scene, pixel, references, options.light);
  }
  const bool failed = std::any_of(references.begin(), references.end(),
                                  [](const auto& each) { return !each.failure.empty(); });
  return failed ? kRendererFailed : kPass;
}

}  // namespace

void add_explain(Program& program) {
  auto options = std::make_shared<ExplainArguments>();
  std::vector<std::string> names{std::string(kNone)};
  for (const Driver& driver : drivers()) names.push_back(driver.name);
  Subcommand command =
      program.add("explain", "Write out the equation of one pixel with numbers, light by light");
  command.option("scene", options->scene, "Scene file or canonical name").required();
  command.option("x", options->x, "Column, 0 at the left").required();
  command.option("y", options->y, "Row, 0 at the top").required();
  command.option("--light", options->light,
                 "Only one light by its name, or \"ambient\"; default: all and their sum");
  command
      .option("--wavelength", options->wavelength,
              "Of a spectral scene: explain the three bands around this many nm, as r, g and b "
              "(555)")
      .between(kFirstWavelength, kLastWavelength);
  command
      .option("--reference", options->references,
              "povray, blender or none; default: both references")
      .separated_by(',')
      .one_of(names);
  command
      .option("--references", options->sources,
              "auto: live where the renderer is installed, else stored images; live; stored")
      .one_of({"auto", "live", "stored"})
      .with_default();
  command.option("--store", options->store, "Folder that keeps rendered references between runs")
      .with_default();
  command.flag("--json", options->json, "For machines");
  command.footer("Example: litmus explain x5 120 90 --light spot --references stored");
  command.on_run([options] { return run_explain(*options); });
}

}  // namespace litmus

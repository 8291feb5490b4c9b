// page_terms.cpp: slide 5 with numbers for every pixel of a scene, so that the page can explain
// one.
#include "reports/page_terms.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <nlohmann/json.hpp>

#include "reports/controls.h"
#include "reports/overview.h"
#include "reports/packing.h"
#include "reports/plain_text.h"
#include "scene/load.h"
#include "scene/refusal.h"
#include "tracer/explain.h"

namespace litmus {
namespace {
using nlohmann::ordered_json;

constexpr int kProbes = 400;       // pixels at which the scene has to be the one that was rendered
constexpr double kSame = 1e-9;     // an explained pixel is the rendered one within 1e-12
constexpr int kMostObjects = 254;  // in a byte, with one for the background

ordered_json color(const glm::dvec3& c) { return {c.x, c.y, c.z}; }

bool is_what_was_rendered(const Scene& scene, const Case& one) {
  if (one.layers.empty() || scene.width != one.width || scene.height != one.height ||
      scene.lights.size() + 2 != one.layers.size())
    return false;
  const Explainer explain_at = explainer(scene);
  const int pixels = one.width * one.height, step = std::max(1, pixels / kProbes) | 1;
  for (int i = 0; i < pixels; i += step) {
    const Explanation there = explain_at(i % one.width, i / one.width);
    for (std::size_t k = 0; k < there.layers.size(); ++k)
      for (int c = 0; c < 3; ++c) {
        const double shown = one.layers[k].ours.pixels[std::size_t(i)][c];
        if (!(std::abs(there.layers[k][c] - shown) <= kSame)) return false;
      }
  }
  return true;
}

ordered_json packed_term(const TermPicture& term, const Scene& scene) {
  Picture grey(scene.width, scene.height);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i)
    grey.pixels[i] = glm::dvec3(double(term.values[i]));
  const PackedPicture small = packed(grey);
  return {{"name", term.term},
          {"exponent", small.exponent},
          {"guess", name_of(small.guess)},
          {"data", small.data}};
}

std::string bytes_of(const std::vector<int>& objects) {  // 0: none
  std::string bytes;
  for (const int object : objects) bytes += char(object + 1);
  return bytes;
}

std::string bytes_of(const std::vector<Gate>& gates) {
  std::string bytes;
  for (const Gate gate : gates) bytes += char(gate);
  return bytes;
}

ordered_json light_json(const Light& light, const LightExplanation& at, const Scene& scene,
                        const std::vector<TermPicture>& pictures, const StopPicture& stops) {
  ordered_json result{{"name", clean_text(light.name)},
                      {"type", light_type(light)},
                      {"lamps", at.lamps.size()},
                      {"diffuse", color(at.light_diffuse)},
                      {"specular", color(at.light_specular)},
                      {"gates", deflated(bytes_of(stops.gates))},
                      {"blockers", deflated(bytes_of(stops.blockers))},
                      {"terms", ordered_json::array()}};
  for (const TermPicture& picture : pictures)
    if (picture.light == light.name) result["terms"].push_back(packed_term(picture, scene));
  return result;
}

// A pixel where something is seen, to ask for the colours that are the same everywhere.
Explanation somewhere(const Scene& scene, const std::vector<int>& objects) {
  const auto hit = std::find_if(objects.begin(), objects.end(), [](int o) { return o >= 0; });
  const int i = hit == objects.end() ? 0 : int(hit - objects.begin());
  return explain(scene, i % scene.width, i / scene.width);
}

}  // namespace

std::string terms_json(const Case& one) try {
  Scene scene = load_scene(one.file);
  if (scene.spectra) return "";  // its pixels are not a sum of products of RGB colours
  RenderOptions options;
  const Control* control = find_control(one.control);
  if (control != nullptr) control->apply(scene, options);
  if (scene.objects.size() > kMostObjects || !is_what_was_rendered(scene, one)) return "";
  const std::vector<int> objects = objects_seen(scene);
  const Explanation at = somewhere(scene, objects);
  if (!at.hit) return "";
  ordered_json result{{"code", scene.shading == Shading::SampleCode},
                      {"planted", control == nullptr ? "" : std::string(control->about)},
                      {"samples", scene.samples},
                      {"width", scene.width},
                      {"ambient", color(at.ambient)},
                      {"seen", deflated(bytes_of(objects))},
                      {"reasons", ordered_json::array()},
                      {"objects", ordered_json::array()},
                      {"lights", ordered_json::array()}};
  for (int gate = 0; gate <= int(Gate::Blocked); ++gate)
    result["reasons"].push_back(gate_reason(Gate(gate)));
  for (const Object& object : scene.objects) {
    const Material& m = scene.materials[std::size_t(object.material)];
    result["objects"].push_back({{"name", clean_text(object.name)},
                                 {"ka", color(m.ambient)},
                                 {"kd", color(m.diffuse)},
                                 {"ks", color(m.specular)},
                                 {"ns", m.shininess}});
  }
  const std::vector<TermPicture> pictures = term_pictures(scene);
  const std::vector<StopPicture> stops = stop_pictures(scene);
  for (std::size_t k = 0; k < scene.lights.size(); ++k)
    result["lights"].push_back(
        light_json(scene.lights[k], at.lights[k], scene, pictures, stops[k]));
  return result.dump();
} catch (const Refusal&) {
  return "";
}

std::vector<std::string> explained_cases(const Study& study, std::size_t budget) {
  std::vector<std::future<std::string>> running;
  for (const Case& one : study.cases)
    running.push_back(std::async(std::launch::async, [&one] { return terms_json(one); }));
  std::vector<std::string> result(study.cases.size());
  for (const Case* one : cases_by_verdict(study)) {
    const std::size_t place = std::size_t(one - study.cases.data());
    std::string terms = running[place].get();
    if (terms.size() > budget) continue;
    budget -= terms.size();
    result[place] = std::move(terms);
  }
  return result;
}

}  // namespace litmus

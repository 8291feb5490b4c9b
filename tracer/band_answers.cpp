// band_answers.cpp: the formulas of light_terms.h at D = 1, at S = 1 and at one lamp in view.
#include "tracer/band_answers.h"

#include <algorithm>

#include "scene/bands.h"
#include "scene/observer.h"
#include "tracer/light_terms.h"
#include "tracer/pixels.h"

namespace litmus {
namespace {

glm::dvec3 seen_color(const Spectra& spectra, const ThreeBands& bands) {
  glm::dvec3 xyz(0);
  for (std::size_t b = 0; b < spectra.xyz.size(); ++b)
    xyz += bands[b / 3][int(b % 3)] * spectra.xyz[b];
  return linear_srgb(xyz);
}

/// The scene without its shapes: colours are all that counts here, and meshes are large.
Scene colors_scene(const Scene& scene) {
  Scene colors;
  colors.shading = scene.shading, colors.camera = scene.camera, colors.ambient = scene.ambient;
  colors.materials = scene.materials, colors.lights = scene.lights, colors.spectra = scene.spectra;
  for (const Object& object : scene.objects)
    colors.objects.push_back({object.name, Sphere{}, object.material});
  return colors;
}

}  // namespace

std::vector<BandAnswer> band_answers(const Scene& scene) {
  const std::size_t layers = scene.lights.size() + 1, objects = scene.objects.size();
  std::vector<BandAnswer> answers(layers * objects);
  for (const Scene& three : band_scenes(colors_scene(scene))) {
    const Plan<double> plan = lower<double>(three);
    const auto add = [](ThreeBands& bands, const Vec<double>& color) {
      bands.push_back(to_double(color));
    };
    for (std::size_t object = 0; object < objects; ++object) {
      const Finish<double>& finish = plan.finishes[object];
      BandAnswer* answer = &answers[object * layers];
      add(answer->diffuse, {}), add(answer->specular, {});
      add(answer->in_view, plan.sample_code ? Vec<double>{} : finish.ambient * plan.ambient);
      for (const Source<double>& source : plan.sources) {
        const auto unit = [&](double d, double s, double lamps) {
          LightTerms<double> terms;
          terms.diffuse = d, terms.specular = s, terms.unoccluded = lamps;
          return light_color(plan, source, finish, terms, task_of(plan));
        };
        ++answer;
        add(answer->diffuse, unit(1, 0, 0)), add(answer->specular, unit(0, 1, 0));
        add(answer->in_view, unit(0, 0, 1));
      }
    }
  }
  for (BandAnswer& answer : answers)
    answer.colors = {seen_color(*scene.spectra, answer.diffuse),
                     seen_color(*scene.spectra, answer.specular),
                     seen_color(*scene.spectra, answer.in_view)};
  return answers;
}

void leave_out_ambient(std::vector<BandAnswer>& answers, std::size_t layers) {
  for (std::size_t i = 0; i < answers.size(); i += layers) {
    answers[i].colors = glm::dmat3(0);
    std::fill(answers[i].in_view.begin(), answers[i].in_view.end(), glm::dvec3(0));
  }
}

}  // namespace litmus

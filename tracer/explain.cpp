// explain.cpp: asks the kernel's functions one by one and writes down what each says.
#include "tracer/explain.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

#include "scene/refusal.h"
#include "tracer/camera.h"
#include "tracer/closest.h"
#include "tracer/light_terms.h"

namespace litmus {
namespace {

using Vec3 = Vec<double>;

glm::dvec3 plain(const Vec3& v) { return {v.x, v.y, v.z}; }

// ---- One lamp --------------------------------------------------------------------------------

Gate gate_of(const Plan<double>& plan, const LampTerms<double>& kernel) {
  if (kernel.lit) return Gate::Open;
  if (plan.sample_code) return Gate::Blocked;
  if (!kernel.shades) return Gate::Behind;
  if (!kernel.faces) return Gate::BehindGeometry;
  if (!kernel.light.in_cone) return Gate::OutsideCone;
  return kernel.light.intensity > 0 ? Gate::Blocked : Gate::NoLight;
}

LampExplanation explain_lamp(const Plan<double>& plan, const Lamp<double>& lamp,
                             const Hit<double>& hit, const Vec3& eye) {
  const LampTerms<double> kernel = lamp_terms(plan, lamp, hit, eye);
  const Incident<double> light = incident(lamp, hit.point);  // the kernel leaves out what is dark
  const Finish<double>& finish = plan.finishes[std::size_t(hit.object)];
  LampExplanation result;

  // What arrives: the factors whose product is the kernel's intensity.
  result.l = plain(light.direction);
  result.distance = light.distance;
  result.x = light.distance / lamp.range;
  if (lamp.attenuated) {
    result.linear = linear_attenuation(result.x, lamp.linear);
    result.quadratic = quadratic_attenuation(result.x, lamp.quadratic);
    result.attenuation = result.linear * result.quadratic;
  }
  if (lamp.cone) {
    result.alpha = cone_angle(lamp, hit.point);
    result.decay = spot_decay(result.alpha, lamp.cutoff, lamp.exponent);
  }
  result.intensity = light.intensity;

  // How the surface answers.
  result.l_dot_n = dot(light.direction, hit.normal);
  if (finish.shiny) {
    const Vec3 h = half_vector(light.direction, eye).unit;
    result.h = plain(h);
    result.h_dot_n = dot(h, hit.normal);
    result.power = specular_power(light.direction, eye, hit.normal, finish.shininess);
  }

  // Whether it arrives at all.
  if (plan.shadows) result.blocker = first_blocker(plan, hit, light);
  result.visibility = result.blocker < 0 ? 1 : 0;
  result.gate = gate_of(plan, kernel);
  result.diffuse = kernel.terms.diffuse;
  result.specular = kernel.terms.specular;
  return result;
}

// ---- One light -------------------------------------------------------------------------------

LightExplanation explain_light(const Plan<double>& plan, const Source<double>& source,
                               const Hit<double>& hit, const Vec3& eye) {
  const Finish<double>& finish = plan.finishes[std::size_t(hit.object)];
  LightExplanation result;
  result.weight = source.weight;
  for (const Lamp<double>& lamp : source.lamps) {
    result.lamps.push_back(explain_lamp(plan, lamp, hit, eye));
  }
  const LightTerms<double> terms = light_terms(plan, source, hit, eye);
  const auto color = [&](double diffuse, double specular, double unoccluded) {
    return plain(
        light_color(plan, source, finish, {diffuse, specular, unoccluded, 0}, task_of(plan)));
  };
  result.diffuse = terms.diffuse, result.specular = terms.specular;
  result.light_diffuse = plain(source.diffuse);
  result.light_specular = plain(plan.sample_code ? source.diffuse : source.specular);
  result.diffuse_color = color(terms.diffuse, 0, 0);
  result.specular_color = color(0, terms.specular, 0);
  result.ambient_color = color(0, 0, terms.unoccluded);
  result.color = color(terms.diffuse, terms.specular, terms.unoccluded);
  return result;
}

// ---- One sample of the picture ---------------------------------------------------------------

/// The point (x, y) of the picture, both from -1 (left, bottom) to 1.
Explanation explain_point(const Plan<double>& plan, const Scene& scene, double x, double y) {
  Explanation result;
  result.layers.resize(scene.lights.size() + 1);
  const Ray<double> ray = camera_ray(plan.view, x, y);
  const Hit<double> hit = closest_hit(plan, ray);
  if (hit.kind == Kind::None) return result;
  const Direction<double> direction = direction_of(ray.direction);
  const Vec3 eye = -direction.unit;
  const Finish<double>& finish = plan.finishes[std::size_t(hit.object)];
  result.hit = true;
  result.object = hit.object;
  result.material = scene.materials[std::size_t(scene.objects[std::size_t(hit.object)].material)];
  result.t = hit.t * direction.length;
  result.point = plain(hit.point), result.e = plain(eye);
  result.normal = plain(hit.normal), result.geometric = plain(hit.geometric);
  result.ambient = plain(plan.ambient);
  if (!plan.sample_code) result.ambient_color = plain(finish.ambient * plan.ambient);
  result.whole = result.layers[0] = result.ambient_color;
  for (std::size_t i = 0; i < plan.sources.size(); ++i) {
    LightExplanation light = explain_light(plan, plan.sources[i], hit, eye);
    light.name = scene.lights[i].name, light.type = light_type(scene.lights[i]);
    result.layers[i + 1] = light.color;
    result.whole += light.color;
    result.lights.push_back(std::move(light));
  }
  result.picture = result.whole;
  return result;
}

/// Replaces what the pixel shows by the mean of its samples.
void average(const Plan<double>& plan, const Scene& scene, Explanation& pixel) {
  const int n = scene.samples;
  std::vector<glm::dvec3> layers(pixel.layers.size());
  glm::dvec3 picture{0};
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Explanation sample =
          explain_point(plan, scene, screen<double>(pixel.x * n + i, scene.width * n),
                        -screen<double>(pixel.y * n + j, scene.height * n));
      for (std::size_t k = 0; k < layers.size(); ++k) layers[k] += sample.layers[k];
      picture += sample.whole;
    }
  }
  for (glm::dvec3& layer : layers) layer /= double(n * n);
  pixel.layers = std::move(layers);
  pixel.picture = picture / double(n * n);
}

// ---- Every pixel -----------------------------------------------------------------------------

/// Calls visit(index of the pixel, hit, eye) for the centre of every pixel that sees something.
template <class Visit>
void for_each_hit(const Plan<double>& plan, Visit visit) {
  const View<double>& view = plan.view;
  tbb::parallel_for(0, view.height, [&](int y) {
    for (int x = 0; x < view.width; ++x) {
      const Ray<double> ray =
          camera_ray(view, screen<double>(x, view.width), -screen<double>(y, view.height));
      const Hit<double> hit = closest_hit(plan, ray);
      if (hit.kind == Kind::None) continue;
      visit(std::size_t(y) * std::size_t(view.width) + std::size_t(x), hit,
            -normalize(ray.direction));
    }
  });
}

// ---- The table of terms ----------------------------------------------------------------------

bool always(const Scene&, const Light&) { return true; }
bool has_place(const Scene&, const Light& light) {
  return !std::holds_alternative<DirectionalLight>(light.shape);
}
bool has_linear(const Scene&, const Light& light) { return attenuation_of(light).linear != 0; }
bool has_quadratic(const Scene&, const Light& light) {
  return attenuation_of(light).quadratic != 0;
}
bool has_cone(const Scene&, const Light& light) {
  return std::holds_alternative<SpotLight>(light.shape);
}
bool has_specular(const Scene& scene, const Light&) {
  for (const Object& object : scene.objects) {
    if (scene.materials[std::size_t(object.material)].specular != Color(0)) return true;
  }
  return false;
}
bool has_shadows(const Scene& scene, const Light&) { return scene.shadows; }

constexpr Term kTerms[] = {
    {"d", "distance to the light, scene units", &LampExplanation::distance, has_place},
    {"l", "linear attenuation, slide 11", &LampExplanation::linear, has_linear},
    {"q", "quadratic attenuation, slide 11", &LampExplanation::quadratic, has_quadratic},
    {"alpha", "angle off the spot's axis, radians", &LampExplanation::alpha, has_cone},
    {"decay", "towards the cone's edge, slide 16", &LampExplanation::decay, has_cone},
    {"l.n", "cosine at the surface, below 0 behind it", &LampExplanation::l_dot_n, always},
    {"h.n", "cosine of the half vector", &LampExplanation::h_dot_n, has_specular},
    {"power", "(h.n)^ns", &LampExplanation::power, has_specular},
    {"visibility", "the part of the light in view", &LampExplanation::visibility, has_shadows},
    {"diffuse", "D, the factor of kd Id", &LampExplanation::diffuse, always},
    {"specular", "S, the factor of ks Is", &LampExplanation::specular, has_specular},
};

std::vector<LightExplanation> explain_lamps(const Plan<double>& plan, const Hit<double>& hit,
                                            const Vec3& eye) {
  std::vector<LightExplanation> lights(plan.sources.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i].weight = plan.sources[i].weight;
    for (const Lamp<double>& lamp : plan.sources[i].lamps)
      lights[i].lamps.push_back(explain_lamp(plan, lamp, hit, eye));
  }
  return lights;
}

}  // namespace

std::string_view gate_reason(Gate gate) {
  static constexpr std::string_view kReasons[] = {
      "the light arrives",
      "the light is behind the surface",
      "the light is behind the facet, though not behind its interpolated normal",
      "the point is outside the cone",
      "nothing is left of the light",
      "something is in between"};
  return kReasons[std::size_t(gate)];
}

std::span<const Term> terms() { return kTerms; }

double mean(const LightExplanation& light, double LampExplanation::*member) {
  double total = 0;
  for (const LampExplanation& lamp : light.lamps) total += lamp.*member;
  return total * light.weight;
}

Explainer explainer(const Scene& scene) {
  const auto kept = std::make_shared<const Scene>(scene);
  const auto plan = std::make_shared<const Plan<double>>(lower<double>(scene));
  return [kept, plan](int x, int y) {
    if (x < 0 || y < 0 || x >= kept->width || y >= kept->height) {
      throw Refusal(
          fmt::format("pixel ({}, {}): {} has x from 0 to {} and y from 0 to {}, row 0 at the top",
                      x, y, kept->name, kept->width - 1, kept->height - 1));
    }
    Explanation result = explain_point(*plan, *kept, screen<double>(x, kept->width),
                                       -screen<double>(y, kept->height));
    result.x = x, result.y = y, result.samples = kept->samples;
    if (kept->samples > 1) average(*plan, *kept, result);
    return result;
  };
}

Explanation explain(const Scene& scene, int x, int y) { return explainer(scene)(x, y); }

std::vector<TermPicture> term_pictures(const Scene& scene) {
  const Plan<double> plan = lower<double>(scene);
  struct Wanted {
    std::size_t light;
    double LampExplanation::*member;
  };
  std::vector<Wanted> wanted;
  std::vector<TermPicture> pictures;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    for (const Term& term : kTerms) {
      if (plan.sources[i].lamps.empty() || !term.applies(scene, scene.lights[i])) continue;
      wanted.push_back({i, term.member});
      pictures.push_back({scene.lights[i].name, term.name, {}});
      pictures.back().values.resize(std::size_t(scene.width) * std::size_t(scene.height));
    }
  }
  for_each_hit(plan, [&](std::size_t pixel, const Hit<double>& hit, const Vec3& eye) {
    const std::vector<LightExplanation> lights = explain_lamps(plan, hit, eye);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      pictures[k].values[pixel] = float(mean(lights[wanted[k].light], wanted[k].member));
    }
  });
  return pictures;
}

std::vector<StopPicture> stop_pictures(const Scene& scene) {
  const Plan<double> plan = lower<double>(scene);
  const std::size_t count = std::size_t(scene.width) * std::size_t(scene.height);
  std::vector<StopPicture> pictures;
  for (const Light& light : scene.lights)
    pictures.push_back(
        {light.name, std::vector<Gate>(count, Gate::Open), std::vector<int>(count, -1)});
  for_each_hit(plan, [&](std::size_t pixel, const Hit<double>& hit, const Vec3& eye) {
    const std::vector<LightExplanation> lights = explain_lamps(plan, hit, eye);
    for (std::size_t k = 0; k < lights.size(); ++k) {
      const std::vector<LampExplanation>& lamps = lights[k].lamps;
      if (lamps.empty()) continue;
      const Gate first = lamps.front().gate;
      if (std::all_of(lamps.begin(), lamps.end(), [&](auto& lamp) { return lamp.gate == first; }))
        pictures[k].gates[pixel] = first;
      for (const LampExplanation& lamp : lamps)
        if (lamp.gate == Gate::Blocked && pictures[k].blockers[pixel] < 0)
          pictures[k].blockers[pixel] = lamp.blocker;
    }
  });
  return pictures;
}

std::vector<int> objects_seen(const Scene& scene) {
  const Plan<double> plan = lower<double>(scene);
  std::vector<int> objects(std::size_t(scene.width) * std::size_t(scene.height), -1);
  for_each_hit(plan, [&](std::size_t pixel, const Hit<double>& hit, const Vec3&) {
    objects[pixel] = hit.object;
  });
  return objects;
}

}  // namespace litmus

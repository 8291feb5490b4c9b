// render_terms.cpp: the layers of `litmus render --terms`.
#include "cli/render_terms.h"

#include <fmt/format.h>

#include "tracer/explain.h"

namespace litmus {
namespace {

Layer scalar_layer(const Scene& scene, const TermPicture& term, std::string_view type) {
  Layer layer{fmt::format("{}.{}", term.light, term.term), std::string(type),
              Picture(scene.width, scene.height)};
  for (std::size_t i = 0; i < term.values.size(); ++i)
    layer.picture.pixels[i] = glm::dvec3(term.values[i]);
  return layer;
}

}  // namespace

Layers term_layers(const Scene& scene) {
  Layers layers;
  const std::vector<int> objects = objects_seen(scene);
  for (const auto& [name, member] : {std::pair{"ka", &Material::ambient},
                                     {"kd", &Material::diffuse},
                                     {"ks", &Material::specular}}) {
    layers.push_back({name, "material", Picture(scene.width, scene.height)});
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (objects[i] < 0) continue;
      const Object& object = scene.objects[std::size_t(objects[i])];
      layers.back().picture.pixels[i] = scene.materials[std::size_t(object.material)].*member;
    }
  }
  for (const TermPicture& term : term_pictures(scene)) {
    for (const Light& light : scene.lights)
      if (light.name == term.light) layers.push_back(scalar_layer(scene, term, light_type(light)));
  }
  return layers;
}

Metadata term_metadata(const Scene& scene) {
  const auto text = [](const Color& c) { return fmt::format("{} {} {}", c.x, c.y, c.z); };
  const bool equation = scene.shading == Shading::Equation;
  Metadata metadata;
  Color ambient = scene.ambient;
  for (const Light& light : scene.lights) {
    if (equation) ambient += light.intensity * light.ambient;
    metadata[light.name + ".Id"] = text(light.intensity * light.diffuse);
    metadata[light.name + ".Is"] =
        text(light.intensity * (equation ? light.specular : light.diffuse));
  }
  metadata["Ia"] = text(ambient);
  if (scene.spectra)
    metadata["spectral"] = "ka, kd, ks, Ia, Id and Is are RGB colours in place of spectra";
  metadata["picture"] =
      equation ? "ka Ia + sum over lights of kd Id diffuse + ks Is specular"
               : "sum over lights of lamps * visibility * ka Ia + kd Id diffuse + ks Is specular";
  return metadata;
}

}  // namespace litmus

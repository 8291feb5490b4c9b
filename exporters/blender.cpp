// blender.cpp: the exact mapping to Cycles, as a script that a person can read.
#include "exporters/blender.h"

#include <fmt/core.h>

#include <ostream>

#include "exporters/area_grid.h"
#include "exporters/blender_geometry.h"
#include "exporters/blender_parts.h"
#include "exporters/envelope.h"
#include "exporters/text.h"
#include "scene/overload.h"

namespace litmus {
namespace {

void write_header(const Scene& scene, std::ostream& out) {
  out << "# " << comment(scene.name) << ", exactly, for Blender 3.4 (Cycles, CPU)\n#\n";
  if (!scene.about.empty()) out << comment_block(scene.about, "# ");
  write_blender_commands(scene, true, out);
  for (const std::string& caveat : blender_caveats(scene)) {
    out << "#\n" << comment_block("Not exact: " + caveat, "# ");
  }
}

std::string rectangles(const std::vector<std::array<Point, 4>>& rings) {
  std::string text = "[";
  for (const auto& ring : rings) {
    text += "\n    [";
    for (std::size_t i = 0; i < 4; ++i) text += (i ? ", " : "") + python_triple(ring[i]);
    text += "],";
  }
  return text + "]";
}

void write_object(const Scene& scene, const Object& object, const std::string& material,
                  std::ostream& out) {
  const std::string start = python_label(object.name) + ", " + material;
  const std::string end = object.camera_visible ? ")\n" : ", visible=False)\n";
  const double aspect = double(scene.width) / scene.height;
  std::visit(Overload{
                 [&](const Sphere& s) {
                   const bool inside = holds_eye(scene.camera, aspect, s);
                   out << fmt::format("{}({}, {}, {}{}", inside ? "shell" : "sphere", start,
                                      python_triple(s.center), number(s.radius), end);
                 },
                 [&](const Plane& p) {
                   const auto rings = plane_rectangles(scene, p);
                   if (rings.empty()) {
                     out << "# " << comment(object.name)
                         << ": a plane that is neither seen nor casts a shadow\n";
                   } else {
                     out << "plane(" << start << ", " << rectangles(rings) << end;
                   }
                 },
                 [&](const Box& b) {
                   out << "box(" << start << ", " << python_triple(b.min) << ", "
                       << python_triple(b.max) << end;
                 },
                 [&](const Triangle& t) {
                   write_blender_mesh(start, {{t.a, t.b, t.c}, {}, {{0, 1, 2}}}, end, out);
                 },
                 [&](const Mesh& m) { write_blender_mesh(start, m, end, out); },
             },
             object.shape);
}

std::string falloff(const Attenuation& a) {
  if (a.linear == 0 && a.quadratic == 0) return "";
  return fmt::format(", range={}, linear={}, quadratic={}", number(a.range), number(a.linear),
                     number(a.quadratic));
}

void write_light(const Light& light, bool shadows, std::ostream& out) {
  const std::string name = python_label(light.name);
  const std::string end = shadows ? ")\n" : ", shadows=False)\n";
  const std::string colours =
      fmt::format("intensity={}, diffuse={}, specular={}", number(light.intensity),
                  python_triple(light.diffuse), python_triple(light.specular));
  std::visit(Overload{
                 [&](const DirectionalLight& d) {
                   out << fmt::format("directional_light({}, direction={}, {}", name,
                                      python_triple(d.direction), colours)
                       << end;
                 },
                 [&](const PointLight& p) {
                   out << fmt::format("positional_light({}, [{}], {}{}", name,
                                      python_triple(p.origin), colours, falloff(p.attenuation))
                       << end;
                 },
                 [&](const SpotLight& s) {
                   out << fmt::format(
                              "positional_light({}, [{}], {}{},\n"
                              "                 axis={}, cutoff={}, exponent={}",
                              name, python_triple(s.point.origin), colours,
                              falloff(s.point.attenuation), python_triple(s.direction),
                              number(s.cutoff), number(s.exponent))
                       << end;
                 },
                 [&](const AreaLight& a) {
                   out << fmt::format("positional_light({}, [", name);
                   for (const Point& p : area_samples(a))
                     out << "\n    " << python_triple(p) << ',';
                   out << fmt::format("],\n    {}{}", colours, falloff(a.point.attenuation)) << end;
                 },
             },
             light.shape);
}

}  // namespace

std::string blender_stem(const Scene& scene) {
  std::string stem;
  for (const char c : scene.name) {
    const bool safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_' || (c == '.' && !stem.empty());
    if (safe && stem.size() < 100) stem += c;
  }
  return stem.empty() || stem[0] == '-' ? "scene" + stem : stem;
}

std::vector<BlenderFrame> blender_frames(const Scene& scene) {
  std::vector<BlenderFrame> frames{{-1, 0}};
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto* area = std::get_if<AreaLight>(&scene.lights[i].shape);
    const int samples = area ? area->columns * area->rows : 1;
    for (int k = 0; k < samples; ++k) frames.push_back({int(i), k});
  }
  return frames;
}

std::vector<std::string> blender_caveats(const Scene& scene) {
  std::vector<std::string> caveats;
  const double aspect = double(scene.width) / scene.height;
  for (const Object& object : scene.objects) {
    const auto* sphere = std::get_if<Sphere>(&object.shape);
    if (sphere && holds_eye(scene.camera, aspect, *sphere)) {
      caveats.push_back(fmt::format(
          "the eye is inside sphere \"{}\": it is a mesh of 20,480 triangles, shaded at the points "
          "of the true sphere; where other objects or a cone meet it, they are off by up to 2e-4 "
          "radii.",
          object.name));
    }
  }
  for (const Light& light : scene.lights) {
    const auto* spot = std::get_if<SpotLight>(&light.shape);
    if (spot && spot->exponent * 1.2e-7 / spot->cutoff > 2e-5) {
      caveats.push_back(fmt::format(
          "spot light \"{}\": single precision rounds its cone to {:.1g} of its intensity near the "
          "cutoff.",
          light.name, spot->exponent * 1.2e-7 / spot->cutoff));
    }
  }
  return caveats;
}

void write_blender(const Scene& given, std::ostream& out) {
  refuse_for_blender(given);
  const Scene scene = into_envelope(given);
  write_header(given, out);
  out << kBlenderPrelude;
  out << "\n\n# ---- The scene "
         "-------------------------------------------------------------------------------\n\n";
  const std::string stem = blender_stem(given);
  out << fmt::format("new_scene({}, width={}, height={}, samples={})\n", python_label(scene.name),
                     scene.width, scene.height, scene.samples);
  out << "ambient(" << python_triple(blender_ambient(scene)) << ")\n\n";
  write_blender_camera(scene, out);
  out << '\n';
  for (const Light& light : scene.lights) write_light(light, scene.shadows, out);
  out << '\n';
  const std::vector<std::string> materials = write_blender_materials(scene, out);
  out << '\n';
  for (const Object& object : scene.objects) {
    write_object(scene, object, materials.at(std::size_t(object.material)), out);
  }
  out << "\nfinish(" << python_string(stem) << ")\n";
}

}  // namespace litmus

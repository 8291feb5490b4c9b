// blender_native.cpp: a scene as a user of Blender would write it, with what that costs.
#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <numbers>
#include <ostream>

#include "exporters/area_grid.h"
#include "exporters/blender.h"
#include "exporters/blender_fit.h"
#include "exporters/blender_geometry.h"
#include "exporters/blender_parts.h"
#include "exporters/envelope.h"
#include "exporters/seen_points.h"
#include "exporters/text.h"
#include "scene/overload.h"

namespace litmus {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kAreaRays = 256;  // samples a pixel of a picture with an area lamp

void write_native_object(const Scene& scene, const Object& object, const std::string& material,
                         std::ostream& out) {
  const std::string start = python_label(object.name) + ", " + material;
  const std::string end = object.camera_visible ? ")\n" : ", visible=False)\n";
  std::visit(Overload{
                 [&](const Sphere& s) {
                   out << fmt::format("sphere({}, {}, {}{}", start, python_triple(s.center),
                                      number(s.radius), end);
                 },
                 [&](const Plane& p) {
                   const auto rectangles = plane_rectangles(scene, p);
                   if (rectangles.empty()) return;
                   out << "plane(" << start << ", [";
                   for (const Point& corner : rectangles.back())
                     out << python_triple(corner) << ", ";
                   out << "]" << end;
                 },
                 [&](const Box& b) {
                   out << fmt::format("box({}, {}, {}{}", start, python_triple(b.min),
                                      python_triple(b.max), end);
                 },
                 [&](const Triangle& t) {
                   write_blender_mesh(start, {{t.a, t.b, t.c}, {}, {{0, 1, 2}}}, end, out);
                 },
                 [&](const Mesh& m) { write_blender_mesh(start, m, end, out); },
             },
             object.shape);
}

/// The line that makes the lamp. Cycles divides the watts of a POINT by 4 pi d^2 and a Diffuse BSDF
/// by pi; those of an AREA by 4 times its area.
void write_lamp(const Light& light, const std::vector<Point>& points, const std::string& end,
                std::ostream& out) {
  const std::string name = python_label(light.name), colour = python_triple(light.diffuse);
  const bool sun = std::holds_alternative<DirectionalLight>(light.shape);
  const LampFit fit = sun ? LampFit{} : fit_distance(light, points);
  if (!sun) {
    out << fmt::format(
        "# at best fit over what the picture shows off by {:.2g} of the intensity, rms\n", fit.rms);
  }
  std::visit(Overload{
                 [&](const DirectionalLight& d) {
                   out << fmt::format("sun({}, {}, {}, {}{}", name, python_triple(d.direction),
                                      number(kPi * light.intensity), colour, end);
                 },
                 [&](const PointLight& p) {
                   out << fmt::format("point({}, {}, {}, {}{}", name, python_triple(p.origin),
                                      number(4 * kPi * kPi * light.intensity * fit.gain), colour,
                                      end);
                 },
                 [&](const SpotLight& s) {
                   const SpotFit cone = fit_spot(s.cutoff, s.exponent);
                   out << fmt::format("spot({}, {}, {}, {}, {}, size={}, blend={}{}", name,
                                      python_triple(s.point.origin), python_triple(s.direction),
                                      number(4 * kPi * kPi * light.intensity * fit.gain), colour,
                                      number(std::min(2 * s.cutoff, kPi)), number(cone.blend), end);
                 },
                 [&](const AreaLight& a) {
                   const GridAxes axes = grid_axes(a);
                   out << fmt::format("area({}, {}, ({}, {}, {}), {}, {}, {}, {}{}", name,
                                      python_triple(a.point.origin), python_triple(axes.right),
                                      python_triple(axes.up), python_triple(axes.normal),
                                      number(4 * kPi * light.intensity * fit.gain), colour,
                                      number(a.width), number(a.height), end);
                 },
             },
             light.shape);
}

/// What is not the model's, with what it costs where that was measured.
std::vector<std::string> differences(const Scene& scene, int area_rays) {
  std::vector<std::string> list;
  bool positional = false, spot = false, area = false, two_colours = false, shiny = false;
  for (const Light& light : scene.lights) {
    positional |= !std::holds_alternative<DirectionalLight>(light.shape);
    spot |= std::holds_alternative<SpotLight>(light.shape);
    area |= std::holds_alternative<AreaLight>(light.shape);
    two_colours |= light.diffuse != light.specular;
  }
  for (const Material& material : scene.materials) shiny |= material.specular != Color(0);
  if (positional) {
    list.push_back("Lamps fall off as 1 / d^2, without range, linear or quadratic attenuation.");
  }
  if (spot) {
    list.push_back(
        "The edge of a SPOT is a smoothstep of the cosine, not 1 - (alpha / cutoff)^exponent, and "
        "it "
        "is at most 90 degrees wide from its axis: 0.05 to 0.07 of the intensity, rms, for "
        "exponents of 1 to 30.");
  }
  if (area) {
    list.push_back(fmt::format(
        "An AREA lamp is the whole rectangle, not a grid of points, dims with the cosine of "
        "emission "
        "and is sampled at random ({} rays a pixel): soft shadows have no steps, but noise.",
        area_rays));
  }
  if (two_colours) list.push_back("A lamp has one colour: the diffuse one.");
  if (shiny) {
    list.push_back(
        "Highlights are Beckmann's, of the same width; the more oblique the light, the higher they "
        "are, up "
        "to twice as high.");
  }
  list.push_back(
      "Spheres are meshes of 128 x 64 faces, and smooth normals are bent by Cycles where "
      "they would reflect into the surface: up to 1e-2.");
  return list;
}

}  // namespace

void write_blender_native(const Scene& scene, std::ostream& out) {
  write_blender_native_sampled(scene, out, kAreaRays);
}

void write_blender_native_sampled(const Scene& given, std::ostream& out, int area_rays) {
  refuse_for_blender(given);
  const Scene scene = into_envelope(given);
  out << "# " << comment(given.name)
      << ", as a user of Blender 3.4 would build it (Cycles, CPU)\n#\n";
  if (!given.about.empty()) out << comment_block(given.about, "# ");
  write_blender_commands(given, false, out);
  out << "#\n# It is not the model's picture:\n";
  for (const std::string& text : differences(scene, area_rays))
    out << comment_block("- " + text, "# ");
  out << kBlenderNativePrelude;

  bool area = false;
  for (const Light& light : scene.lights) area |= std::holds_alternative<AreaLight>(light.shape);
  out << "\n\n# ---- The scene "
         "-------------------------------------------------------------------------------\n\n";
  out << fmt::format("new_scene({}, {}, {}, samples={}, rays={})\n", python_label(scene.name),
                     scene.width, scene.height, scene.samples, area ? area_rays : 1);
  out << "ambient(" << python_triple(blender_ambient(scene)) << ")\n\n";
  write_blender_camera(scene, out);
  out << '\n';
  const std::vector<Point> points = seen_points(scene);
  const std::string end = scene.shadows ? ")\n" : ", shadows=False)\n";
  for (const Light& light : scene.lights) write_lamp(light, points, end, out);
  out << '\n';
  const std::vector<std::string> materials = write_blender_materials(scene, out);
  out << '\n';
  for (const Object& object : scene.objects) {
    write_native_object(scene, object, materials.at(std::size_t(object.material)), out);
  }
  out << "\nfinish(" << python_string(blender_stem(given)) << ")\n";
}

}  // namespace litmus

// povray_native.cpp: the POV-Ray export as a user would write it, and what it costs.
#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <numbers>
#include <ostream>

#include "exporters/area_grid.h"
#include "exporters/envelope.h"
#include "exporters/povray.h"
#include "exporters/povray_fit.h"
#include "exporters/povray_layers.h"
#include "exporters/povray_parts.h"
#include "exporters/text.h"
#include "scene/overload.h"

namespace litmus {
namespace povray {
namespace {

bool is_grey(const Color& c) { return c.r == c.g && c.g == c.b; }
double grey(const Color& c) { return is_grey(c) ? c.r : (c.r + c.g + c.b) / 3; }

// Fitted numbers: more digits mean nothing.
std::string rounded(double value) { return fmt::format("{:.5g}", value); }

// Distances up to this matter for attenuation.
double reach(const Scene& scene) { return 2 * extent_radius(scene); }

bool fades(const Light& light) {
  const Attenuation a = attenuation_of(light);
  return a.linear > 0 || a.quadratic > 0;
}

std::string fade_text(const Scene& scene, const Light& light) {
  if (!fades(light)) return "";
  const FadeFit fit = fit_fade(attenuation_of(light), reach(scene));
  return fmt::format(" fade_distance {} fade_power {}", rounded(fit.distance), rounded(fit.power));
}

std::string color_text(const Scene& scene, const Light& light) {
  const std::string color = fmt::format("rgb Gain*{}", vector_text(diffuse_power(light)));
  if (!fades(light)) return color;
  return fmt::format("{} * {}", color,
                     rounded(fit_fade(attenuation_of(light), reach(scene)).factor));
}

std::string area_text(const AreaLight& area, const std::string& adaptive) {
  const GridAxes axes = grid_axes(area);
  // POV-Ray's samples reach the ends of the axes: those of a grid of cell centres lie further in.
  const auto side = [&](double size, int count) {
    return area.placement == Placement::Centres ? size * (count - 1) / count : size;
  };
  return fmt::format("area_light {}, {}, {}, {}{} area_illumination on",
                     vector_text(axes.right * side(area.width, area.columns)),
                     vector_text(axes.up * side(area.height, area.rows)), area.columns, area.rows,
                     adaptive);
}

void write_light(const Scene& scene, const Light& light, const std::string& name,
                 const std::string& adaptive, std::ostream& out) {
  const std::string color = color_text(scene, light), fade = fade_text(scene, light);
  const auto source = [&](const std::string& at, const std::string& kind) {
    out << fmt::format("  light_source {{\n    {}\n    {}\n    {}{}\n  }}\n", at, color, kind,
                       fade);
  };
  out << fmt::format("\n#if (Shines({}))  // {}\n", name, light_type(light));
  std::visit(
      Overload{
          [&](const DirectionalLight& l) {
            constexpr double kFarAway = 1e5;
            source(vector_text(-kFarAway * glm::normalize(l.direction)),
                   "parallel point_at <0, 0, 0>");
          },
          [&](const PointLight& l) { source(vector_text(l.origin), ""); },
          [&](const SpotLight& l) {
            const SpotFit fit = fit_spot(l.cutoff, l.exponent);
            source(vector_text(l.point.origin),
                   fmt::format("spotlight point_at {} radius {} falloff {} tightness {}",
                               vector_text(l.point.origin + glm::normalize(l.direction)),
                               rounded(fit.radius), rounded(fit.falloff), rounded(fit.tightness)));
          },
          [&](const AreaLight& l) { source(vector_text(l.point.origin), area_text(l, adaptive)); }},
      light.shape);
  out << "#end\n";
}

void write_textures(const Scene& scene, const Names& names, std::ostream& out) {
  write_title("Materials", out);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    Color ambient(0);
    for (int c = 0; c < 3; ++c) ambient[c] = m.diffuse[c] > 0 ? m.ambient[c] / m.diffuse[c] : 0;
    out << fmt::format(
        "#declare {} = texture {{\n  pigment {{ rgb {} }}\n  finish {{ ambient {} "
        "diffuse 1{} }}\n}}\n",
        names.materials[i], vector_text(m.diffuse), vector_text(ambient),
        m.specular == Color(0)
            ? ""
            : fmt::format(" specular {} roughness 1/{}", number(grey(m.specular)),
                          number(std::max(m.shininess, kNoShininess))));
  }
}

void note_light(const Scene& scene, const Light& light, std::vector<std::string>& notes) {
  const auto note = [&](const std::string& text) {
    notes.push_back(fmt::format("\"{}\": {}", light.name, text));
  };
  const Attenuation a = attenuation_of(light);
  if (a.linear > 0 && a.quadratic > 0)
    note(
        fmt::format("one fade for linear and quadratic attenuation together; up to {:.2g} of the "
                    "light's intensity off.",
                    fit_fade(a, reach(scene)).error));
  if (const SpotLight* spot = std::get_if<SpotLight>(&light.shape)) {
    note(
        fmt::format("a spotlight's edge is a power of the cosine times a cubic, not "
                    "1 - (angle/cutoff)^exponent; up to {:.2g} of the intensity off.",
                    fit_spot(spot->cutoff, spot->exponent).error));
    if (spot->cutoff > std::numbers::pi / 2)
      note("a spotlight ends at 90 degrees; what the cone lights beyond is missing.");
  }
  const AreaLight* area = std::get_if<AreaLight>(&light.shape);
  if (area && scene.shadows && area->columns * area->rows > 1)
    note(
        "an area_light multiplies the mean visibility by the mean light instead of averaging the "
        "products; exact without an occluder, up to a tenth of the intensity off in penumbrae.");
  if (light.diffuse != light.specular)
    note("highlights have the light's diffuse colour: POV-Ray's lights have one colour.");
}

std::vector<std::string> notes_for(const Scene& scene) {
  std::vector<std::string> notes;
  for (const Light& light : scene.lights) note_light(scene, light, notes);
  for (const Object& object : scene.objects)
    if (scene.shadows && std::holds_alternative<Mesh>(object.shape))
      notes.push_back(
          fmt::format("\"{}\": single pixels at its terminator and edges, because a "
                      "mesh2 has single precision and shadows begin 0.001 from a "
                      "surface.",
                      object.name));
  for (const Material& m : scene.materials) {
    if (!is_grey(m.specular))
      notes.push_back(fmt::format("\"{}\": highlights are not tinted by the material.", m.name));
    for (int c = 0; c < 3; ++c)
      if (m.diffuse[c] == 0 && m.ambient[c] > 0) {
        notes.push_back(fmt::format("\"{}\": no ambient light where diffuse is 0.", m.name));
        break;
      }
  }
  if (notes.empty())
    notes.push_back("Nothing in this scene differs from the model.");
  else
    notes.insert(notes.begin(), "What differs from the model:");
  return notes;
}

void write_gains(const Scene& scene, const Names& names, std::ostream& out) {
  write_title("Layer: the light that shines", out);
  out << "#declare Unit = 1;\n#ifndef (Layer) #declare Layer = frame_number; #end\n";
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    out << fmt::format("#declare {} = {};\n", names.lights[i], i + 2);
  out << fmt::format(
      "#switch (Layer)\n  #case (0) #declare Gain = {}; #break\n  #case (1) "
      "#declare Gain = {}; #break\n",
      number(whole_gain(scene)), number(povray_gain(scene, 0)));
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    out << fmt::format("  #case ({}) #declare Gain = {}; #break\n", names.lights[i],
                       number(povray_gain(scene, i + 1)));
  out << "  #else #error \"There is no such frame.\"\n#end\n"
         "#macro Shines(Light) (Layer = 0 | Layer = Light) #end\n";
  out << fmt::format("global_settings {{ ambient_light rgb (Layer <= 1 ? 1 : 0)*Gain*{} }}\n",
                     vector_text(ambient_power(scene)));
}

void write_native(const Scene& original, const std::string& adaptive, std::ostream& out) {
  refuse_sample_code(original);
  const Scene scene = into_envelope(original);
  const Names names = names_of(scene);
  std::vector<std::string> notes = notes_for(scene);
  notes.insert(notes.begin(), fmt::format("Without +KFI and +KFF (frame 0) all lights shine at "
                                          "once, times {}.",
                                          number(whole_gain(scene))));
  write_header(scene, envelope_of(original),
               "Written by litmus for POV-Ray 3.7, with POV-Ray's own lights, fitted to the model.",
               notes, out);
  out << "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n";
  write_gains(scene, names, out);
  write_camera(scene, out);
  write_textures(scene, names, out);
  write_objects(scene, names, MeshAs::Mesh2, out);
  write_title("Lights", out);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    write_light(scene, scene.lights[i], names.lights[i], adaptive, out);
}

}  // namespace
}  // namespace povray

void write_povray_native(const Scene& scene, std::ostream& out) {
  povray::write_native(scene, "", out);
}

void write_povray_native_adaptive(const Scene& scene, std::ostream& out, int level) {
  povray::write_native(scene, fmt::format(" adaptive {}", level), out);
}

}  // namespace litmus

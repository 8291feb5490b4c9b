// povray.cpp: the exact POV-Ray export: lights whose formulas POV-Ray lacks, made of what it has.
#include "exporters/povray.h"

#include <fmt/core.h>

#include <algorithm>
#include <ostream>

#include "exporters/area_grid.h"
#include "exporters/envelope.h"
#include "scene/overload.h"
#include "exporters/povray_layers.h"
#include "exporters/povray_limits.h"
#include "exporters/povray_parts.h"
#include "exporters/text.h"

namespace litmus {
namespace povray {
namespace {

// All lights can shine at once if none needs a medium, which would dim the others' light too, and
// one proportion of specular to diffuse serves all.
bool renders_whole(const Scene& scene) {
  Color factor;
  return common_specular(scene, factor) &&
         (scene.lights.size() < 2 ||
          std::none_of(scene.lights.begin(), scene.lights.end(), has_medium));
}

void write_light_macros(const Scene& scene, std::ostream& out) {
  write_title("Lights", out);
  out << R"(#macro LightColor(Color) (Boost * #if (Layer = 0) Color #else <1, 1, 1> #end) #end
)";
  const auto is_spot = [](const Light& l) { return std::holds_alternative<SpotLight>(l.shape); };
  if (std::any_of(scene.lights.begin(), scene.lights.end(), is_spot))
    out << R"(
// Goes on a sphere round the lamp and lets 1 - (angle/cutoff)^exponent of its light out (slide 16).
#macro Cone(Direction, Cutoff, Exponent)
  #local X = vnormalize(Direction).x;
  #local Y = vnormalize(Direction).y;
  #local Z = vnormalize(Direction).z;
  #local Across = function(x, y, z) { sqrt(x*x + y*y + z*z) }
  #local Angle = function(x, y, z) { atan2(Across(y*Z - z*Y, z*X - x*Z, x*Y - y*X), x*X + y*Y + z*Z) / Cutoff }
  pigment {
    function { select(1 - Angle(x, y, z), 0, 0.5*(1 - pow(min(Angle(x, y, z), 1), Exponent))) }
    color_map { [0 rgbt <0, 0, 0, 0>] [0.5 rgbt <0, 0, 0, 1>] }
  }
#end
)";
  if (std::any_of(scene.lights.begin(), scene.lights.end(), has_medium))
    out << fmt::format(R"(
// Fills space with a medium that dims by 1/(1 + Linear*d/Range) (slide 11), but for small spheres
// round the lamps. Quadratic attenuation is the lamp's own.
#macro Medium(Range, Linear)
  pigment {{ rgbt 1 }} hollow no_image no_reflection
  interior {{ fade_distance (Range*Unit + Linear*Radius)/Linear fade_power 1 fade_color rgb 0 }}
#end
#declare Space = box {{ -{0}*<1, 1, 1>, {0}*<1, 1, 1> pigment {{ rgbt 1 }} }}
)",
                       number(kMediumReach));
}

// The colour of one lamp and the attenuation that POV-Ray has: 2/(1 + (d/fade_distance)^power).
std::string lamp_color(const Light& light, int samples) {
  const Attenuation a = attenuation_of(light);
  std::string text = fmt::format("rgb LightColor({})", vector_text(diffuse_power(light)));
  if (samples > 1) text += fmt::format("/{}", samples);
  if (a.linear == 0 && a.quadratic == 0) return text;
  const std::string range = number(a.range);
  if (has_medium(light))
    text += fmt::format(" * {0}*Unit/({0}*Unit + {1}*Radius)", range, number(a.linear));
  return text + (a.quadratic > 0 ? fmt::format("/2 fade_distance Unit*{}/sqrt({}) fade_power 2",
                                               range, number(a.quadratic))
                                 : fmt::format("/2 fade_distance Unit*{}/{} fade_power 1", range,
                                               number(a.linear)));
}

std::string medium(const Light& light) {
  const Attenuation a = attenuation_of(light);
  return fmt::format("Medium({}, {})", number(a.range), number(a.linear));
}

void write_directional(const Light& light, const DirectionalLight& sun, std::ostream& out) {
  out << fmt::format(
      "  light_source {{ -{}*vnormalize({}) rgb LightColor({}) parallel point_at <0, 0, 0> }}\n",
      number(kSunDistance), vector_text(sun.direction), vector_text(diffuse_power(light)));
}

void write_point(const Light& light, const PointLight& point, const std::string& cone, double unit,
                 std::ostream& out) {
  const bool filtered = has_medium(light) || !cone.empty();
  const std::string at = vector_text(point.origin) + "*Unit";
  if (filtered)
    out << fmt::format("  #declare Radius = {};\n", number(filter_radius(unit * point.origin)));
  out << fmt::format("  light_source {{ {} {} }}\n", at, lamp_color(light, 1));
  if (!filtered) return;
  const std::string sphere = fmt::format("sphere {{ 0, Radius {} translate {}",
                                         cone.empty() ? "pigment { rgbt 1 }" : cone, at);
  if (has_medium(light))
    out << fmt::format("  difference {{ object {{ Space }} {} }} {} }}\n", sphere, medium(light));
  else
    out << fmt::format("  {} hollow no_image no_reflection }}\n", sphere);
}

void write_spot(const Light& light, const SpotLight& spot, double unit, std::ostream& out) {
  if (spot.exponent == 0) {
    out << "  // Exponent 0: 1 - (angle/cutoff)^0 is no light at all.\n";
    return;
  }
  write_point(light, spot.point,
              fmt::format("Cone({}, {}, {})", vector_text(spot.direction), number(spot.cutoff),
                          number(spot.exponent)),
              unit, out);
}

// "#declare NAME = array[n] {...}"
void write_points(const std::string& name, const std::vector<Point>& points,
                  const std::string& remark, std::ostream& out) {
  out << fmt::format("  #declare {} = array[{}] {{  // {}\n", name, points.size(), remark);
  for (std::size_t i = 0; i < points.size(); ++i)
    out << "    " << vector_text(points[i]) << (i + 1 < points.size() ? ",\n" : "\n  }\n");
}

// One of each: two spheres in one place are none to POV-Ray.
std::vector<Point> distinct(const std::vector<Point>& points) {
  std::vector<Point> result;
  for (const Point& p : points)
    if (std::find(result.begin(), result.end(), p) == result.end()) result.push_back(p);
  return result;
}

void write_area(const Light& light, const AreaLight& area, const std::string& name, double unit,
                std::ostream& out) {
  const std::vector<Point> samples = area_samples(area);
  write_points(name + "_Samples", samples,
               fmt::format("{} columns, {} rows", area.columns, area.rows), out);
  if (has_medium(light))
    out << fmt::format("  #declare Radius = {};\n",
                       number(filter_radius(unit * area.point.origin)));
  const auto loop = [](std::size_t count) { return fmt::format("#for (I, 0, {})", count - 1); };
  out << fmt::format("  {} light_source {{ {}_Samples[I]*Unit {} }} #end\n", loop(samples.size()),
                     name, lamp_color(light, int(samples.size())));
  if (!has_medium(light)) return;
  const std::vector<Point> places = distinct(samples);
  const bool same = places.size() == samples.size();
  if (!same) write_points(name + "_Places", places, "without repetition", out);
  out << fmt::format(
      "  difference {{\n    object {{ Space }}\n    {} sphere {{ {}_{}[I]*Unit, Radius pigment {{ "
      "rgbt 1 }} }} #end\n    {}\n  }}\n",
      loop(places.size()), name, same ? "Samples" : "Places", medium(light));
}

void write_light(const Light& light, const std::string& name, double unit, std::ostream& out) {
  out << fmt::format("\n#if (Shines({}))  // {}\n", name, light_type(light));
  std::visit(Overload{[&](const DirectionalLight& l) { write_directional(light, l, out); },
                      [&](const PointLight& l) { write_point(light, l, "", unit, out); },
                      [&](const SpotLight& l) { write_spot(light, l, unit, out); },
                      [&](const AreaLight& l) { write_area(light, l, name, unit, out); }},
             light.shape);
  out << "#end\n";
}

}  // namespace
}  // namespace povray

void write_povray(const Scene& original, std::ostream& out) {
  using namespace povray;
  refuse_sample_code(original);
  const Scene scene = into_envelope(original);
  const Names names = names_of(scene);
  const bool whole = renders_whole(scene);
  std::vector<std::string> notes = povray_caveats(original);
  notes.insert(notes.begin(),
               whole ? fmt::format("Without +KFI and +KFF (frame 0) all lights shine at once, "
                                   "times {}.",
                                   number(whole_gain(scene)))
                     : "There is no frame with all lights at once: POV-Ray lets a medium or a "
                       "specular colour belong to all lights only.");
  write_header(scene, envelope_of(original),
               "Written by litmus for POV-Ray 3.7: the model's own formulas, exactly.", notes, out);
  const double unit = unit_of(scene);
  write_layers(scene, names, unit, whole, out);
  write_camera(scene, out);
  write_materials(scene, names, out);
  write_objects(scene, names, MeshAs::Triangles, out);
  write_light_macros(scene, out);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    write_light(scene.lights[i], names.lights[i], unit, out);
}

}  // namespace litmus

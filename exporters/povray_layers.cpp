// povray_layers.cpp: how bright each frame is, and the choice of the frame in POV-Ray's language.
#include "exporters/povray_layers.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "exporters/povray.h"
#include "exporters/text.h"

namespace litmus::povray {
namespace {

double largest(const Color& c) { return std::max({c.r, c.g, c.b}); }

// The power of two that brings `bound` into (0.5, 1]; 1 where there is nothing to see.
double gain_for(double bound) {
  if (!(bound > 0) || !std::isfinite(bound)) return 1;
  int exponent = 0;
  const double fraction = std::frexp(bound, &exponent);
  return std::ldexp(1.0, fraction == 0.5 ? 1 - exponent : -exponent);
}

double ambient_bound(const Scene& scene) {
  double bound = 0;
  for (const Material& m : scene.materials)
    bound = std::max(bound, largest(m.ambient * ambient_power(scene)));
  return bound;
}

double light_bound(const Scene& scene, const Light& light) {
  double bound = 0;
  for (const Material& m : scene.materials)
    bound = std::max(
        bound, largest(m.diffuse * diffuse_power(light) + m.specular * specular_power(light)));
  return bound;
}

}  // namespace

Color diffuse_power(const Light& light) { return light.intensity * light.diffuse; }
Color specular_power(const Light& light) { return light.intensity * light.specular; }

Color ambient_power(const Scene& scene) {
  Color total = scene.ambient;
  for (const Light& light : scene.lights) total += light.intensity * light.ambient;
  return total;
}

bool common_specular(const Scene& scene, Color& factor) {
  factor = Color(1);
  for (int channel = 0; channel < 3; ++channel) {
    bool known = false;
    for (const Light& light : scene.lights) {
      const double diffuse = diffuse_power(light)[channel];
      const double specular = specular_power(light)[channel];
      if (diffuse == 0 && specular == 0) continue;
      if (diffuse == 0) return false;
      const double ratio = specular / diffuse;
      constexpr double kSame = 1e-14;  // rounding of two divisions
      if (known && std::abs(ratio - factor[channel]) > kSame * ratio) return false;
      factor[channel] = ratio;
      known = true;
    }
  }
  return true;
}

double whole_gain(const Scene& scene) {
  double bound = ambient_bound(scene);
  for (const Light& light : scene.lights) bound += light_bound(scene, light);
  return gain_for(bound);
}

void write_header(const Scene& scene, const Envelope& envelope, const std::string& kind,
                  const std::vector<std::string>& notes, std::ostream& out) {
  const auto paragraph = [&](const std::string& text) {
    out << comment_block(text, "// ") << "//\n";
  };
  out << comment_block(scene.name + ": " + scene.about, "// ") << "//\n";
  paragraph(kind);

  // The file's name may hold anything; the command is one that a shell takes apart as meant.
  const std::string stem = scene.name.find_first_not_of(
                               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMN"
                               "OPQRSTUVWXYZ0123456789-_.") == std::string::npos
                               ? scene.name
                               : "FILE";
  out << "// Render it:\n//   povray "
      << fmt::format("{}\n", fmt::join(povray_arguments(scene, stem), " "));
  out << "// A frame is the light of one layer of the model times its gain; the layers add up to "
         "the"
         "\n// picture. Pixels are linear, row 0 is the top:\n";
  if (scene.samples > 1)
    out << fmt::format("// average {0} x {0} pixels into one.\n", scene.samples);
  const auto frame = [&](std::size_t layer, const std::string& what) {
    out << comment(fmt::format("//   frame {}: {}, times {}", layer + 1, what,
                               number(povray_gain(scene, layer))))
        << '\n';
  };
  frame(0, "ambient");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    frame(i + 1, fmt::format("\"{}\", {}", scene.lights[i].name, light_type(scene.lights[i])));
  out << "//\n";
  for (const std::string& note : notes) paragraph(note);
  out << "// Coordinates as in the scene: right-handed, z up.";
  if (!envelope.identity())
    out << fmt::format("\n// Moved and scaled: (p - {}) * {}.", vector_text(envelope.centre),
                       number(envelope.scale));
  out << '\n';
}

void write_layers(const Scene& scene, const Names& names, double unit, bool whole,
                  std::ostream& out) {
  out << "#version 3.7;\n"
         "global_settings { assumed_gamma 1.0 ambient_light rgb 1 adc_bailout 0 }\n"
         "#default { finish { ambient 0 diffuse 0 specular 0 emission 0 } }\n";
  write_title("Unit and layer", out);
  out << fmt::format("#declare Unit = {};  // one unit of the scene in POV-Ray's\n", number(unit));
  out << "#ifndef (Layer) #declare Layer = frame_number; #end\n"
         "#ifndef (Boost) #declare Boost = 1; #end  // a factor on all light\n";
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    out << comment(fmt::format("#declare {} = {};  // \"{}\"", names.lights[i], i + 2,
                               scene.lights[i].name))
        << '\n';
  const auto layer = [&](const std::string& label, double gain, const Color& ambient,
                         const Color& diffuse, const Color& specular) {
    out << fmt::format(
        "  #case ({})\n    #declare Gain = {};\n    #declare Ia = {};\n    #declare Id = {};\n"
        "    #declare Is = {};\n    #break\n",
        label, number(gain), vector_text(ambient), vector_text(diffuse), vector_text(specular));
  };
  out << "#switch (Layer)\n";
  if (whole) {
    Color factor;
    common_specular(scene, factor);
    out << "  // All at once: each light has its own colour, the specular one in this "
           "proportion.\n";
    layer("0", whole_gain(scene), ambient_power(scene), Color(1), factor);
  }
  layer("1", povray_gain(scene, 0), ambient_power(scene), Color(0), Color(0));
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    layer(names.lights[i], povray_gain(scene, i + 1), Color(0), diffuse_power(scene.lights[i]),
          specular_power(scene.lights[i]));
  out << fmt::format("  #else\n    #error \"{}\"\n#end\n",
                     whole ? "There is no such frame."
                           : fmt::format("These lights cannot shine at once. Render the frames: "
                                         "+KFI1 +KFF{}",
                                         scene.lights.size() + 1));
  out << "#macro Shines(Light) (Layer = 0 | Layer = Light) #end\n";
}

}  // namespace litmus::povray

namespace litmus {

double povray_gain(const Scene& scene, std::size_t layer) {
  return povray::gain_for(layer == 0 ? povray::ambient_bound(scene)
                                     : povray::light_bound(scene, scene.lights.at(layer - 1)));
}

std::vector<std::string> povray_arguments(const Scene& scene, const std::string& stem) {
  std::vector<std::string> arguments{"+I" + stem + ".pov",
                                     "+O" + stem + ".png",
                                     fmt::format("+W{}", scene.width * scene.samples),
                                     fmt::format("+H{}", scene.height * scene.samples),
                                     "+FN16",
                                     "File_Gamma=1.0",
                                     "-A",
                                     "-D"};
  if (!scene.lights.empty()) {
    arguments.push_back("+KFI1");
    arguments.push_back(fmt::format("+KFF{}", scene.lights.size() + 1));
  } else {
    arguments.push_back("Declare=Layer=1");
  }
  return arguments;
}

}  // namespace litmus

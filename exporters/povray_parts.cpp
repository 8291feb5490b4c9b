// povray_parts.cpp: header, layers, camera, materials and objects in POV-Ray's language.
#include "exporters/povray_parts.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "exporters/povray.h"
#include "exporters/text.h"
#include "scene/refusal.h"

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

template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

void write_triangle(const Mesh& mesh, const std::array<std::int32_t, 3>& corners,
                    std::ostream& out) {
  const bool smooth = !mesh.normals.empty();
  out << (smooth ? "  smooth_triangle { " : "  triangle { ");
  for (int i = 0; i < 3; ++i) {
    out << (i ? ", " : "") << vector_text(mesh.vertices[std::size_t(corners[i])]);
    if (smooth) out << ", " << vector_text(mesh.normals[std::size_t(corners[i])]);
  }
  out << " }\n";
}

void write_mesh2(const Mesh& mesh, std::ostream& out) {
  const auto block = [&](const char* name, const auto& items, const auto& text) {
    out << fmt::format("  {} {{\n    {}", name, items.size());
    for (const auto& item : items) out << ",\n    " << text(item);
    out << "\n  }\n";
  };
  out << "mesh2 {\n";
  block("vertex_vectors", mesh.vertices, vector_text);
  if (!mesh.normals.empty()) block("normal_vectors", mesh.normals, vector_text);
  block("face_indices", mesh.triangles,
        [](const auto& t) { return fmt::format("<{}, {}, {}>", t[0], t[1], t[2]); });
}

// Everything of an object but its texture and its end.
void write_shape(const Object& object, MeshAs as, std::ostream& out) {
  std::visit(Overload{[&](const Sphere& s) {
                        out << fmt::format("sphere {{ {}, {}", vector_text(s.center),
                                           number(s.radius));
                      },
                      [&](const Plane& p) {
                        out << fmt::format("plane {{ {}, 0 translate {}", vector_text(p.normal),
                                           vector_text(p.point));
                      },
                      [&](const Box& b) {
                        out << fmt::format("box {{ {}, {}", vector_text(b.min), vector_text(b.max));
                      },
                      [&](const Triangle& t) {
                        out << fmt::format("triangle {{ {}, {}, {}", vector_text(t.a),
                                           vector_text(t.b), vector_text(t.c));
                      },
                      [&](const Mesh& m) {
                        if (as == MeshAs::Mesh2) return write_mesh2(m, out);
                        out << fmt::format("union {{  // {} triangles\n", m.triangles.size());
                        for (const auto& corners : m.triangles) write_triangle(m, corners, out);
                      }},
             object.shape);
}

bool is_empty_mesh(const Object& object) {
  const Mesh* mesh = std::get_if<Mesh>(&object.shape);
  return mesh && mesh->triangles.empty();
}

}  // namespace

void write_title(const std::string& title, std::ostream& out) {
  const std::string start = fmt::format("\n// ---- {} ", title);
  constexpr std::size_t kWidth = 101;  // with the newline
  out << start << std::string(std::max(kWidth, start.size()) - start.size(), '-') << '\n';
}

void refuse_sample_code(const Scene& scene) {
  if (scene.shading == Shading::SampleCode)
    throw Refusal(
        fmt::format("{}: shading: \"sample-code\" is a reading that POV-Ray cannot render; export "
                    "the scene with shading = \"equation\"",
                    scene.file.empty() ? scene.name : scene.file.string()));
}

std::string vector_text(const Vector& v) {
  return fmt::format("<{}, {}, {}>", number(v.x), number(v.y), number(v.z));
}

Names names_of(const Scene& scene) {
  std::set<std::string> taken;
  Names names;
  for (const Material& m : scene.materials)
    names.materials.push_back(identifier("Material", m.name, taken));
  for (const Light& light : scene.lights)
    names.lights.push_back(identifier("Light", light.name, taken));
  return names;
}

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

Attenuation attenuation_of(const Light& light) {
  if (auto* point = std::get_if<PointLight>(&light.shape)) return point->attenuation;
  if (auto* spot = std::get_if<SpotLight>(&light.shape)) return spot->point.attenuation;
  if (auto* area = std::get_if<AreaLight>(&light.shape)) return area->point.attenuation;
  return {};
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

void write_camera(const Scene& scene, std::ostream& out) {
  const Camera& c = scene.camera;
  const bool flat = c.projection == Projection::Orthographic;
  write_title("Camera", out);
  out << fmt::format("#declare Eye = {}*Unit;\n#declare Forward = vnormalize({}*Unit - Eye);\n",
                     vector_text(c.eye), vector_text(c.target));
  out << fmt::format(
      "#declare Height = {};  // of the picture{}\n",
      flat ? fmt::format("{}*Unit", number(c.height)) : fmt::format("2*tan({}/2)", number(c.fov)),
      flat ? "" : " at distance 1");
  out << fmt::format(
      "#declare PictureRight = vnormalize(vcross(Forward, {})) * Height*{}/{};\n"
      "#declare PictureUp = vcross(vnormalize(PictureRight), Forward) * Height;\n",
      vector_text(c.up), scene.width, scene.height);
  out << fmt::format(
      "camera {{ {} location Eye direction Forward right PictureRight up PictureUp }}\n",
      flat ? "orthographic" : "perspective");
}

void write_materials(const Scene& scene, const Names& names, std::ostream& out) {
  write_title("Materials: ambient ka, diffuse kd, specular ks, shininess ns (slide 5)", out);
  out << R"(// The lights are white: their colours are in Id and Is. Brightness is K: averages divide by 2.
#macro Lit(Kd, Ks, Ns, K)
  #if (Ks.red = Ks.green & Ks.green = Ks.blue)
    texture { pigment { rgb Kd } finish { diffuse K specular K*Ks.red roughness 1/Ns } }
  #else  // POV-Ray's highlights have the light's colour: filter them
    #local Highlight =
      texture { pigment { rgb 0 } finish { specular 2*K roughness 1/Ns } }
      texture { pigment { rgbf <Ks.red, Ks.green, Ks.blue, 1> } };
    texture { average texture_map { [1 pigment { rgb Kd } finish { diffuse 2*K }] [1 Highlight] } }
  #end
#end
#macro Glow(Ka, K) texture { pigment { rgb Ka } finish { emission K*Boost } } #end
#macro Surface(Ka, Kd, Ks, Ns)
  #switch (Layer)
    #case (0)
      #local Glowing = Glow(Gain*Ka*Ia, 2)
      #local Shining = Lit(Gain*Kd*Id, Gain*Ks*Is, Ns, 2)
      texture { average texture_map { [1 Glowing] [1 Shining] } }
      #break
    #case (1) Glow(Gain*Ka*Ia, 1) #break
    #else Lit(Gain*Kd*Id, Gain*Ks*Is, Ns, 1)
  #end
#end
)";
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& m = scene.materials[i];
    out << fmt::format("#declare {} = Surface({}, {}, {}, {})\n", names.materials[i],
                       vector_text(m.ambient), vector_text(m.diffuse), vector_text(m.specular),
                       number(std::max(m.shininess, kNoShininess)));
  }
}

void write_objects(const Scene& scene, const Names& names, MeshAs mesh, std::ostream& out) {
  write_title("Objects", out);
  for (const Object& object : scene.objects) {
    if (is_empty_mesh(object)) continue;
    out << comment_block(object.name, "// ");
    write_shape(object, mesh, out);
    out << fmt::format(
        " scale Unit texture {{ {} }}{}{} }}\n", names.materials[std::size_t(object.material)],
        object.camera_visible ? "" : " no_image no_reflection", scene.shadows ? "" : " no_shadow");
  }
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

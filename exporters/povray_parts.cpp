// povray_parts.cpp: names, camera, materials and objects in POV-Ray's language.
#include "exporters/povray_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "exporters/text.h"
#include "scene/overload.h"
#include "scene/refusal.h"

namespace litmus::povray {
namespace {

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

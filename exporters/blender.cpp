// blender.cpp: the exact mapping to Cycles, as a script that a person can read.
#include "exporters/blender.h"

#include <fmt/core.h>

#include <ostream>
#include <set>

#include "exporters/area_grid.h"
#include "exporters/blender_geometry.h"
#include "exporters/envelope.h"
#include "exporters/text.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

/// A name for people as a Python string; Blender takes no control characters in names.
std::string label(const std::string& name) { return python_string(comment(name)); }

std::string triple(const glm::dvec3& v) {
  return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

/// The frames as comment lines; the samples of an area light share one.
std::string frame_table(const Scene& scene) {
  std::string table = "#   1  ambient light\n";
  std::size_t frame = 2;
  for (const Light& light : scene.lights) {
    const auto* area = std::get_if<AreaLight>(&light.shape);
    const std::size_t count = area ? std::size_t(area->columns) * std::size_t(area->rows) : 1;
    const std::string last = count > 1 ? fmt::format("-{}", frame + count - 1) : "";
    table += fmt::format(
        "#   {}{}  {} light {}{}\n", frame, last, light_type(light), comment(light.name),
        count > 1
            ? fmt::format(", {} x {} samples, row by row, columns first", area->columns, area->rows)
            : "");
    frame += count;
  }
  return table;
}

void write_header(const Scene& scene, std::ostream& out) {
  const std::string stem = blender_stem(scene);
  out << "# " << comment(scene.name) << ", exactly, for Blender 3.4 (Cycles, CPU)\n#\n";
  if (!scene.about.empty()) out << comment_block(scene.about, "# ");
  out << fmt::format(
      "#\n"
      "# Build the scene, save OUTDIR/{0}.blend and render its frames to OUTDIR/{0}_0001.exr, "
      "...:\n"
      "#   blender -b --factory-startup -Y --python-exit-code 9 -P {0}.py -- OUTDIR\n"
      "# Render the frames of the saved file, without Python:\n"
      "#   blender -b OUTDIR/{0}.blend -o //{0}_#### -a\n"
      "#\n"
      "# Each frame is one lamp, for with several Cycles picks one at random. The picture is the\n"
      "# sum of all frames (linear values, 32-bit float):\n",
      stem);
  out << frame_table(scene);
  if (scene.samples > 1) {
    out << fmt::format(
        "#\n# The frames are {0} times larger than the picture: a pixel of it is the "
        "mean of {0} x {0}.\n",
        scene.samples);
  }
  const Envelope envelope = envelope_of(scene);
  if (!envelope.identity()) {
    out << fmt::format(
        "#\n# Moved and scaled to where single precision is good: here = (there - {}) * {}\n",
        triple(envelope.centre), number(envelope.scale));
  }
  for (const std::string& caveat : blender_caveats(scene)) {
    out << "#\n" << comment_block("Not exact: " + caveat, "# ");
  }
}

std::vector<std::string> write_materials(const Scene& scene, std::ostream& out) {
  std::set<std::string> taken;
  std::vector<std::string> names;
  for (const Material& m : scene.materials) {
    names.push_back(identifier("Material", m.name, taken));
    out << fmt::format("{} = material({}, ambient={}, diffuse={}, specular={}, shininess={})\n",
                       names.back(), label(m.name), triple(m.ambient), triple(m.diffuse),
                       triple(m.specular), number(m.shininess));
  }
  return names;
}

void write_lines(const std::vector<glm::dvec3>& rows, std::ostream& out) {
  for (const glm::dvec3& r : rows) {
    out << number(r.x) << ' ' << number(r.y) << ' ' << number(r.z) << '\n';
  }
}

void write_mesh(const std::string& start, const std::string& end, const Mesh& mesh,
                std::ostream& out) {
  out << "mesh(" << start << ", vertices=\"\"\"\n";
  write_lines(mesh.vertices, out);
  out << "\"\"\", triangles=\"\"\"\n";
  for (const auto& t : mesh.triangles) out << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if (!mesh.normals.empty()) {
    out << "\"\"\", normals=\"\"\"\n";
    write_lines(mesh.normals, out);
  }
  out << "\"\"\"" << end;
}

std::string rectangles(const std::vector<std::array<Point, 4>>& rings) {
  std::string text = "[";
  for (const auto& ring : rings) {
    text += "\n    [";
    for (std::size_t i = 0; i < 4; ++i) text += (i ? ", " : "") + triple(ring[i]);
    text += "],";
  }
  return text + "]";
}

void write_object(const Scene& scene, const Object& object, const std::string& material,
                  std::ostream& out) {
  const std::string start = label(object.name) + ", " + material;
  const std::string end = object.camera_visible ? ")\n" : ", visible=False)\n";
  const double aspect = double(scene.width) / scene.height;
  std::visit(Overloaded{
                 [&](const Sphere& s) {
                   const bool inside = holds_eye(scene.camera, aspect, s);
                   out << fmt::format("{}({}, {}, {}{}", inside ? "shell" : "sphere", start,
                                      triple(s.center), number(s.radius), end);
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
                   out << "box(" << start << ", " << triple(b.min) << ", " << triple(b.max) << end;
                 },
                 [&](const Triangle& t) {
                   write_mesh(start, end, {{t.a, t.b, t.c}, {}, {{0, 1, 2}}}, out);
                 },
                 [&](const Mesh& m) { write_mesh(start, end, m, out); },
             },
             object.shape);
}

void write_camera(const Scene& scene, std::ostream& out) {
  const Camera& camera = scene.camera;
  // The target moves with the eye, so that the direction keeps its digits.
  const Point eye = near_eye(scene);
  const std::string lens = camera.projection == Projection::Perspective
                               ? "fov=" + number(camera.fov)
                               : "height=" + number(camera.height);
  out << fmt::format("camera(eye={}, target={}, up={}, {})\n", triple(eye),
                     triple(eye == camera.eye ? camera.target : eye + (camera.target - camera.eye)),
                     triple(camera.up), lens);
}

std::string falloff(const Attenuation& a) {
  if (a.linear == 0 && a.quadratic == 0) return "";
  return fmt::format(", range={}, linear={}, quadratic={}", number(a.range), number(a.linear),
                     number(a.quadratic));
}

void write_light(const Light& light, bool shadows, std::ostream& out) {
  const std::string name = label(light.name);
  const std::string end = shadows ? ")\n" : ", shadows=False)\n";
  const std::string colours =
      fmt::format("intensity={}, diffuse={}, specular={}", number(light.intensity),
                  triple(light.diffuse), triple(light.specular));
  std::visit(Overloaded{
                 [&](const DirectionalLight& d) {
                   out << fmt::format("directional_light({}, direction={}, {}", name,
                                      triple(d.direction), colours)
                       << end;
                 },
                 [&](const PointLight& p) {
                   out << fmt::format("positional_light({}, [{}], {}{}", name, triple(p.origin),
                                      colours, falloff(p.attenuation))
                       << end;
                 },
                 [&](const SpotLight& s) {
                   out << fmt::format(
                              "positional_light({}, [{}], {}{},\n"
                              "                 axis={}, cutoff={}, exponent={}",
                              name, triple(s.point.origin), colours, falloff(s.point.attenuation),
                              triple(s.direction), number(s.cutoff), number(s.exponent))
                       << end;
                 },
                 [&](const AreaLight& a) {
                   out << fmt::format("positional_light({}, [", name);
                   for (const Point& p : area_samples(a)) out << "\n    " << triple(p) << ',';
                   out << fmt::format("],\n    {}{}", colours, falloff(a.point.attenuation)) << end;
                 },
             },
             light.shape);
}

/// Ia: the scene's ambient colour and every light's, added once.
Color ambient_of(const Scene& scene) {
  Color total = scene.ambient;
  for (const Light& light : scene.lights) total += light.intensity * light.ambient;
  return total;
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
  if (given.shading == Shading::SampleCode) {
    throw Refusal(
        given.name +
        ": shading: \"sample-code\" cannot be exported to Blender, only \"equation\" can");
  }
  const Scene scene = into_envelope(given);
  write_header(given, out);
  out << '\n' << kBlenderPrelude;
  out << "\n\n# ---- The scene "
         "-------------------------------------------------------------------------------\n\n";
  const std::string stem = blender_stem(given);
  out << fmt::format("new_scene({}, width={}, height={}, samples={})\n", label(scene.name),
                     scene.width, scene.height, scene.samples);
  out << "ambient(" << triple(ambient_of(scene)) << ")\n\n";
  const std::vector<std::string> materials = write_materials(scene, out);
  out << '\n';
  for (const Object& object : scene.objects) {
    write_object(scene, object, materials.at(std::size_t(object.material)), out);
  }
  out << '\n';
  write_camera(scene, out);
  out << '\n';
  for (const Light& light : scene.lights) write_light(light, scene.shadows, out);
  out << "\nfinish(" << python_string(stem) << ")\n";
}

}  // namespace litmus

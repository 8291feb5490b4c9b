// blender_parts.cpp: what the exact and the native Blender scripts have in common.
#include "exporters/blender_parts.h"

#include <fmt/core.h>

#include <ostream>
#include <set>

#include "exporters/blender.h"
#include "exporters/blender_geometry.h"
#include "exporters/envelope.h"
#include "exporters/text.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

/// The frames as comment lines; the samples of an area light share one.
std::string frame_table(const Scene& scene, bool samples_have_frames) {
  std::string table = "#   1  ambient light\n";
  int frame = 2;
  for (const Light& light : scene.lights) {
    const auto* area = std::get_if<AreaLight>(&light.shape);
    const int count = area && samples_have_frames ? area->columns * area->rows : 1;
    table += fmt::format("#   {}{}  {} light {}", frame,
                         count > 1 ? fmt::format("-{}", frame + count - 1) : "", light_type(light),
                         comment(light.name));
    if (count > 1) {
      table +=
          fmt::format(": its {} x {} samples, one row after the other", area->columns, area->rows);
    }
    table += '\n';
    frame += count;
  }
  return table;
}

void write_lines(const std::vector<glm::dvec3>& rows, std::ostream& out) {
  for (const glm::dvec3& r : rows) {
    out << number(r.x) << ' ' << number(r.y) << ' ' << number(r.z) << '\n';
  }
}

}  // namespace

std::string python_triple(const glm::dvec3& v) {
  return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

std::string python_label(const std::string& name) { return python_string(comment(name)); }

void refuse_for_blender(const Scene& scene) {
  constexpr int kSmallest = 4;
  if (scene.shading == Shading::SampleCode) {
    throw Refusal(
        scene.name +
        ": shading: \"sample-code\" cannot be exported to Blender, only \"equation\" can");
  }
  if (scene.width * scene.samples < kSmallest || scene.height * scene.samples < kSmallest) {
    throw Refusal(fmt::format("{}: image: {} x {} pixels; Blender renders at least {} x {}",
                              scene.name, scene.width, scene.height, kSmallest, kSmallest));
  }
}

Color blender_ambient(const Scene& scene) {
  Color total = scene.ambient;
  for (const Light& light : scene.lights) total += light.intensity * light.ambient;
  return total;
}

void write_blender_commands(const Scene& given, bool samples_have_frames, std::ostream& out) {
  out << fmt::format(
      "#\n"
      "# Build the scene, save OUTDIR/{0}.blend and render its frames to OUTDIR/{0}_0001.exr, "
      "...:\n"
      "#   blender -b --factory-startup -Y --python-exit-code 9 -P {0}.py -- OUTDIR\n"
      "# Render the frames of the saved file, without Python:\n"
      "#   blender -b OUTDIR/{0}.blend -o //{0}_#### -a\n"
      "#\n"
      "# Each frame is one lamp (a marker on the timeline names it). The picture is the sum of "
      "all\n"
      "# frames (linear values, 32-bit float):\n",
      blender_stem(given));
  out << frame_table(given, samples_have_frames);
  if (given.samples > 1) {
    out << fmt::format(
        "#\n# The frames are {0} times larger than the picture: a pixel of it is the mean of "
        "{0} x {0}.\n",
        given.samples);
  }
  const Envelope envelope = envelope_of(given);
  if (!envelope.identity()) {
    out << fmt::format(
        "#\n# Moved and scaled to where single precision is good: here = (there - {}) * {}\n",
        python_triple(envelope.centre), number(envelope.scale));
  }
  out << "#\n# The scene itself stands at the end, behind \"The scene\".\n";
}

std::vector<std::string> write_blender_materials(const Scene& scene, std::ostream& out) {
  std::set<std::string> taken;
  std::vector<std::string> names;
  for (const Material& m : scene.materials) {
    names.push_back(identifier("Material", m.name, taken));
    out << fmt::format("{} = material({}, ambient={}, diffuse={}, specular={}, shininess={})\n",
                       names.back(), python_label(m.name), python_triple(m.ambient),
                       python_triple(m.diffuse), python_triple(m.specular), number(m.shininess));
  }
  return names;
}

void write_blender_mesh(const std::string& start, const Mesh& mesh, const std::string& end,
                        std::ostream& out) {
  out << "mesh(" << start << ", vertices=\"\"\"\n";
  write_lines(mesh.vertices, out);
  out << "\"\"\", triangles=\"\"\"\n";
  // fmt, because an ostream groups digits as its locale says.
  for (const auto& t : mesh.triangles) out << fmt::format("{} {} {}\n", t[0], t[1], t[2]);
  if (!mesh.normals.empty()) {
    out << "\"\"\", normals=\"\"\"\n";
    write_lines(mesh.normals, out);
  }
  out << "\"\"\"" << end;
}

void write_blender_camera(const Scene& scene, std::ostream& out) {
  const Camera& camera = scene.camera;
  // The target moves with the eye, so that the direction keeps its digits.
  const Point eye = near_eye(scene);
  const Point target = eye == camera.eye ? camera.target : eye + (camera.target - camera.eye);
  const std::string lens = camera.projection == Projection::Perspective
                               ? "fov=" + number(camera.fov)
                               : "height=" + number(camera.height);
  out << fmt::format("camera(eye={}, target={}, up={}, {})\n", python_triple(eye),
                     python_triple(target), python_triple(camera.up), lens);
}

}  // namespace litmus

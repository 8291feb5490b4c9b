// peer_renderers.cpp: the stage for POV-Ray and for Cycles.
#include <fmt/format.h>

#include <charconv>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <sstream>
#include <stdexcept>

#include "compare/whole_file.h"
#include "exporters/area_grid.h"
#include "exporters/blender.h"
#include "exporters/povray_parts.h"
#include "reference/drivers.h"
#include "reference/frames.h"
#include "reference/povray_driver.h"
#include "reference/process.h"
#include "reports/peer_entrants.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using povray::vector_text;

/// The installed program, or why there is none.
Entrant missing_or(const Driver& driver, Entrant entrant) {
  if (!driver.find()) {
    entrant.missing = fmt::format("not installed (apt-get install {})", driver.package);
  }
  return entrant;
}

// ---- POV-Ray ---------------------------------------------------------------------------------

/// Quadratic attenuation as POV-Ray has it: twice R^2 / (R^2 + d^2), which costs the same.
std::string fade(const PointLight& point) {
  return fmt::format("fade_distance {} fade_power 2", point.attenuation.range);
}

double trace_with_povray(const fs::path& folder, const std::string& text, int size) {
  fs::create_directories(folder);
  write_whole(folder / "stage.pov", text);
  const ProcessResult result =
      run_process({.arguments = {"povray", "+Istage.pov", "+Ostage.png", fmt::format("+W{}", size),
                                 fmt::format("+H{}", size), "-D", "-A", "+WT1"},
                   .directory = folder,
                   .log = folder / "log"});
  if (!result.ok()) throw std::runtime_error(result.explanation);
  const double seconds = povray_trace_seconds(read_text(folder / "log"));
  if (seconds <= 0) throw std::runtime_error("it printed no time of tracing");
  return seconds;
}

// ---- Cycles ----------------------------------------------------------------------------------

/// Renders the scene that the script before has built, once to warm up, then twice to time.
constexpr std::string_view kTiming = R"python(
import time

scene = bpy.context.scene
scene.cycles.use_adaptive_sampling = False
scene.render.use_persistent_data = False  # it would keep the first number of samples


def seconds(samples):
    scene.cycles.samples = samples
    start = time.process_time()
    bpy.ops.render.render()
    return time.process_time() - start


seconds(1)
few, many = seconds(1), seconds(5)
print("litmus: seconds a sample", (many - few) / 4)
)python";

/// The native export without the call that renders the timeline, and the timing behind it.
std::string timing_script(const Scene& scene) {
  std::ostringstream out;
  write_blender_native(scene, out);
  const std::string script = out.str();
  return script.substr(0, script.rfind("\nfinish(")) + std::string(kTiming);
}

double sample_with_cycles(const fs::path& folder, const Scene& scene) {
  fs::create_directories(folder);
  write_whole(folder / "scene.py", timing_script(scene));
  const ProcessResult result =
      run_process({.arguments = {"blender", "-b", "--factory-startup", "-Y", "--python-exit-code",
                                 "9", "-P", "scene.py", "-t", "1"},
                   .directory = folder,
                   .log = folder / "log"});
  if (!result.ok()) throw std::runtime_error(result.explanation);
  const std::string log = read_text(folder / "log");
  constexpr std::string_view kPrinted = "litmus: seconds a sample ";
  const std::size_t at = log.find(kPrinted);
  double seconds = 0;
  if (at != std::string::npos)
    std::from_chars(log.data() + at + kPrinted.size(), log.data() + log.size(), seconds);
  if (seconds <= 0) throw std::runtime_error("it printed no time of a sample");
  return seconds;
}

}  // namespace

std::string povray_stage(const Scene& scene) {
  const Camera& camera = scene.camera;
  const Material& finish = scene.materials.at(0);
  std::string text = fmt::format(
      "#version 3.7;\n"
      "global_settings {{ assumed_gamma 1 ambient_light 0 }}\n"
      "camera {{ perspective location {} right -x up y sky z angle {} look_at {} }}\n"
      "#default {{ texture {{ pigment {{ rgb 1 }}\n"
      "  finish {{ ambient 0 diffuse {} specular {} roughness {} }} }} }}\n",
      vector_text(camera.eye), glm::degrees(camera.fov), vector_text(camera.target),
      finish.diffuse.r, finish.specular.r, 1 / finish.shininess);
  for (const Object& object : scene.objects) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
      text += fmt::format("sphere {{ {}, {} }}\n", vector_text(sphere->center), sphere->radius);
    } else if (const auto* box = std::get_if<Box>(&object.shape)) {
      text += fmt::format("box {{ {}, {} }}\n", vector_text(box->min), vector_text(box->max));
    } else if (const auto* plane = std::get_if<Plane>(&object.shape)) {
      text += fmt::format("plane {{ {}, {} }}\n", vector_text(plane->normal),
                          dot(plane->normal, plane->point));
    }
  }
  return text;
}

std::string povray_lamps(const Scene& scene) {
  const auto* area = std::get_if<AreaLight>(&scene.lights.at(0).shape);
  const PointLight& point = area ? area->point : std::get<PointLight>(scene.lights[0].shape);
  const std::vector<Point> lamps = area ? area_samples(*area) : std::vector{point.origin};
  std::string text;
  for (const Point& lamp : lamps) {
    text += fmt::format("light_source {{ {}, rgb 1/{} {} }}\n", vector_text(lamp), lamps.size(),
                        fade(point));
  }
  return text;
}

std::string povray_area_light(const Scene& scene) {
  const AreaLight& area = std::get<AreaLight>(scene.lights.at(0).shape);
  const GridAxes axes = grid_axes(area);
  return fmt::format("light_source {{ {}, rgb 1 {}\n  area_light {}, {}, {}, {} }}\n",
                     vector_text(area.point.origin), fade(area.point),
                     vector_text(area.width * axes.right), vector_text(area.height * axes.up),
                     area.columns, area.rows);
}

Entrant povray_entrant(const std::string& name, const Scene& scene, const std::string& lights,
                       const PeerOptions& options) {
  const fs::path folder = options.work / "povray";
  const std::string text = povray_stage(scene) + lights;
  return missing_or(*find_driver("povray"), {name, [=, size = scene.width] {
                                               return trace_with_povray(folder, text, size);
                                             }});
}

Entrant cycles_entrant(const Scene& scene, const PeerOptions& options) {
  const fs::path folder = options.work / "blender";
  return missing_or(*find_driver("blender"), {"Cycles, a sample a pixel",
                                              [=] { return sample_with_cycles(folder, scene); }});
}

}  // namespace litmus

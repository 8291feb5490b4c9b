// native_drivers.cpp: runs the native exports.
#include "reference/native_drivers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <functional>
#include <memory>
#include <sstream>

#include "compare/whole_file.h"
#include "exporters/blender.h"
#include "exporters/povray.h"
#include "reference/blender_driver.h"
#include "reference/frames.h"
#include "reference/povray_driver.h"
#include "reference/process.h"
#include "reference/scene_pool.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// What differs between the two renderers.
struct Native {
  std::string title;
  const char* script;  ///< the export's file
  std::function<void(const Scene&, std::ostream&)> write;
  std::function<std::vector<std::string>(const Scene&)>
      arguments;  ///< behind the program, in the folder
  /// The image of a layer (0 is ambient), and what its values are times the light.
  fs::path (*frame)(const Scene&, std::size_t layer);
  double (*gain)(const Scene&, std::size_t layer);
  double (*seconds)(const std::string& log);
};

fs::path povray_frame(const Scene& scene, std::size_t layer) {
  if (scene.lights.empty()) return "scene.png";
  // Frame numbers have as many digits as the last one.
  const auto digits = fmt::formatted_size("{}", scene.lights.size() + 1);
  return fmt::format("scene{:0{}}.png", layer + 1, digits);
}

Native povray(int adaptive, int antialiasing) {
  return {"POV-Ray, its own lights",
          "scene.pov",
          [adaptive](const Scene& scene, std::ostream& out) {
            if (adaptive < 0) return write_povray_native(scene, out);
            write_povray_native_adaptive(scene, out, adaptive);
          },
          [antialiasing](const Scene& scene) {
            std::vector<std::string> arguments = povray_arguments(scene, "scene");
            if (antialiasing > 0) {
              for (std::string option :
                   {std::string("+A0.0"), std::string("+AM1"), fmt::format("+R{}", antialiasing)})
                arguments.push_back(std::move(option));
            }
            return arguments;
          },
          povray_frame,
          povray_gain,
          povray_trace_seconds};
}

constexpr int kAreaRays = 256;  // samples a pixel

Native blender(int area_rays) {
  return {"Blender Cycles, its own lights",
          "scene.py",
          [area_rays](const Scene& scene, std::ostream& out) {
            write_blender_native_sampled(scene, out, area_rays);
          },
          [](const Scene&) {
            return std::vector<std::string>{"-b",
                                            "--factory-startup",
                                            "-Y",
                                            "--debug-cycles",
                                            "--python-exit-code",
                                            "9",
                                            "-P",
                                            "scene.py",
                                            "-t",
                                            "1",
                                            "--",
                                            ".",
                                            "--no-blend"};
          },
          [](const Scene& scene, std::size_t layer) {
            return fs::path(fmt::format("{}_{:04}.exr", blender_stem(scene), layer + 1));
          },
          [](const Scene&, std::size_t) { return 1.0; },
          cycles_render_seconds};
}

std::string exported(const Native& native, const Scene& scene) {
  std::ostringstream out;
  native.write(scene, out);
  return out.str();
}

std::string source(const Native& native, const Scene& scene) {
  const Scene nameless = without_words(scene);
  return fmt::format("{}\n{}\n", exported(native, nameless),
                     fmt::join(native.arguments(nameless), " "));
}

Picture read_layer(const Native& native, const Scene& scene, const fs::path& folder,
                   std::size_t layer) {
  Picture picture = averaged(read_frame(scene, folder / native.frame(scene, layer)), scene.samples);
  for (glm::dvec3& pixel : picture.pixels) pixel /= native.gain(scene, layer);
  return picture;
}

ReferenceResult render_one(const Native& native, const Installation& installed, const Scene& scene,
                           const fs::path& folder, const ReferenceOptions& options) {
  ReferenceResult result;
  result.scene = scene.name;
  try {
    fs::remove_all(folder);
    fs::create_directories(folder);
    write_whole(folder / native.script, exported(native, scene));
    Command command{.arguments = native.arguments(scene),
                    .directory = folder,
                    .log = folder / "log",
                    .time_limit = options.time_limit};
    result.log = command.log;
    result.command = fmt::format("{} {}", installed.program.filename().string(),
                                 fmt::join(command.arguments, " "));
    command.arguments.insert(command.arguments.begin(), installed.program.string());
    const ProcessResult process = run_process(command);
    if (!process.ok()) throw Refusal(process.explanation);
    result.seconds = native.seconds(read_text(result.log));
    for (std::size_t k = 0; k <= scene.lights.size(); ++k) {
      const Light* light = k == 0 ? nullptr : &scene.lights[k - 1];
      result.layers.push_back({light ? light->name : "ambient",
                               light ? std::string(light_type(*light)) : "ambient",
                               read_layer(native, scene, folder, k)});
    }
  } catch (const std::exception& wrong) {
    result.layers.clear();
    result.failure = wrong.what();
  }
  return result;
}

Driver driver_of(const Native& with, const Driver& exact) {
  const auto shared = std::make_shared<const Native>(with);
  Driver driver = exact;
  driver.name += "-native";
  driver.title = with.title;
  driver.revision = 2;
  driver.source = [shared](const Scene& scene) { return source(*shared, scene); };
  driver.render = [shared](const Installation& installed, std::span<const Scene> scenes,
                           const ReferenceOptions& options, const ResultSink& sink) {
    const Native& native = *shared;
    render_in_pool(
        scenes, options, native.title,
        [&](const Scene& scene, const fs::path& folder) {
          return render_one(native, installed, scene, folder, options);
        },
        sink);
  };
  return driver;
}

}  // namespace

std::span<const Driver> native_drivers() {
  static const std::array table{driver_of(povray(-1, 0), povray_driver()),
                                driver_of(blender(kAreaRays), blender_driver())};
  return table;
}

Driver povray_native_driver(int adaptive, int antialiasing) {
  return driver_of(povray(adaptive, antialiasing), povray_driver());
}

Driver blender_native_driver(int area_rays) {
  return driver_of(blender(area_rays), blender_driver());
}

}  // namespace litmus

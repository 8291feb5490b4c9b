// native_drivers.cpp: runs the native exports.
#include "reference/native_drivers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
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
  void (*write)(const Scene&, std::ostream&);
  std::vector<std::string> (*arguments)(const Scene&);  ///< behind the program, in the folder
  /// The image of a layer (0 is ambient), and what its values are times the light.
  fs::path (*frame)(const Scene&, std::size_t layer);
  double (*gain)(const Scene&, std::size_t layer);
};

fs::path povray_frame(const Scene& scene, std::size_t layer) {
  if (scene.lights.empty()) return "scene.png";
  // Frame numbers have as many digits as the last one.
  const auto digits = fmt::formatted_size("{}", scene.lights.size() + 1);
  return fmt::format("scene{:0{}}.png", layer + 1, digits);
}

const Native kPovray{"POV-Ray, its own lights",
                     "scene.pov",
                     write_povray_native,
                     [](const Scene& scene) { return povray_arguments(scene, "scene"); },
                     povray_frame,
                     povray_gain};

const Native kBlender{
    "Blender Cycles, its own lights",
    "scene.py",
    write_blender_native,
    [](const Scene&) {
      return std::vector<std::string>{
          "-b", "--factory-startup", "-Y", "--python-exit-code", "9", "-P", "scene.py", "--",
          ".",  "--no-blend"};
    },
    [](const Scene& scene, std::size_t layer) {
      return fs::path(fmt::format("{}_{:04}.exr", blender_stem(scene), layer + 1));
    },
    [](const Scene&, std::size_t) { return 1.0; }};

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
    result.seconds = process.seconds;
    if (!process.ok()) throw Refusal(process.explanation);
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

Driver driver_of(const Native& native, const Driver& exact) {
  Driver driver = exact;
  driver.name += "-native";
  driver.title = native.title;
  driver.revision = 1;
  driver.source = [&native](const Scene& scene) { return source(native, scene); };
  driver.render = [&native](const Installation& installed, std::span<const Scene> scenes,
                            const ReferenceOptions& options, const ResultSink& sink) {
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
  static const std::array table{driver_of(kPovray, povray_driver()),
                                driver_of(kBlender, blender_driver())};
  return table;
}

}  // namespace litmus

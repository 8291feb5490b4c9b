// reference.cpp: litmus reference, a scene rendered by POV-Ray or Blender.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/work_folder.h"
#include "compare/image_io.h"
#include "reference/band_images.h"
#include "scene/load.h"

namespace litmus {
namespace {

struct ReferenceArguments {
  std::string scene, with;
  std::filesystem::path output;
};

int run_reference(const ReferenceArguments& options) {
  const Scene scene = load_scene(find_scene(options.scene));
  const WorkFolder work;
  ObtainOptions obtain_options;
  obtain_options.sources = Sources::Live;
  obtain_options.program_version = LITMUS_VERSION;
  obtain_options.reference.work = work.path;
  const ObtainedReference result =
      obtain({&scene, 1}, *find_driver(options.with), obtain_options).front();
  if (!result.failure.empty()) {
    fmt::print(stderr, "litmus: {}\n{}\n", result.failure, result.log);
    return kRendererFailed;
  }
  write_layers(options.output, colors_of(scene, result.layers),
               {{"litmus:renderer", result.reference + " " + result.version}});
  fmt::print(stderr, "{}: {} layers by {} {}, {:.2f} s of rendering\n", options.output.string(),
             result.layers.size(), result.reference, result.version, result.seconds);
  return kPass;
}

}  // namespace

void add_reference(Program& program) {
  auto options = std::make_shared<ReferenceArguments>();
  std::vector<std::string> names;
  for (const Driver& driver : drivers()) names.push_back(driver.name);
  Subcommand command = program.add("reference", "Render a scene with POV-Ray or Blender");
  command.option("scene", options->scene, "Scene file or canonical name").required();
  command.option("--with", options->with, "povray or blender").required().one_of(names);
  command
      .option("-o,--output", options->output, "EXR file: one float part per light, ambient first")
      .required();
  command.footer("Example: litmus reference s5 --with povray -o s5-povray.exr");
  command.on_run([options] { return run_reference(*options); });
}

}  // namespace litmus

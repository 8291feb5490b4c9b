// export.cpp: litmus export, a scene in the language of another renderer.
#include <fmt/format.h>

#include <sstream>

#include "cli/commands.h"
#include "compare/whole_file.h"
#include "exporters/exporters.h"
#include "scene/bands.h"
#include "scene/load.h"

namespace litmus {
namespace {

struct ExportArguments {
  std::string scene, to;
  std::filesystem::path output = ".";
  bool native = false;
};

void write(const ExportArguments& options, const Exporter& exporter, const Scene& scene) {
  std::ostringstream text;
  (options.native ? exporter.write_native : exporter.write)(scene, text);
  const auto file =
      options.output / (scene.name + (options.native ? "-native" : "") + exporter.extension);
  std::filesystem::create_directories(options.output);
  write_whole(file, text.str());
  fmt::print("{}\n", file.string());
}

int run_export(const ExportArguments& options) {
  const Scene scene = load_scene(find_scene(options.scene));
  const Exporter* exporter = find_exporter(options.to);
  if (!options.native) {
    for (const std::string& caveat : exporter->caveats(scene))
      fmt::print(stderr, "note: {}\n", caveat);
  }
  if (!scene.spectra) {
    write(options, *exporter, scene);
    return kPass;
  }
  fmt::print(stderr, "note: {} has spectra: each file has three of its {} wavelength bands\n",
             scene.name, scene.spectra->bands);
  for (const Scene& three : band_scenes(scene)) write(options, *exporter, three);
  return kPass;
}

}  // namespace

void add_export(Program& program) {
  auto options = std::make_shared<ExportArguments>();
  std::vector<std::string> names;
  for (const Exporter& exporter : exporters()) names.push_back(exporter.name);
  Subcommand command = program.add("export", "Write a scene for another renderer");
  command.option("scene", options->scene, "Scene file or canonical name").required();
  command.option("--to", options->to, "povray, blender, or json (for any other renderer)")
      .required()
      .one_of(names);
  command.option("-o,--output", options->output, "Folder to write into").with_default();
  command.flag("--native", options->native,
               "What a user of that renderer would write, at best fit; its header says what "
               "it cannot express");
  command.footer("Example: litmus export x3 --to blender -o exported");
  command.on_run([options] { return run_export(*options); });
}

}  // namespace litmus

// render.cpp: litmus render, our own picture of a scene.
#include <fmt/format.h>

#include "cli/commands.h"
#include "compare/image_io.h"
#include "compare/whole_file.h"
#include "scene/load.h"
#include "scene/refusal.h"
#include "tracer/render.h"

namespace litmus {
namespace {

struct Options {
  std::string scene, light;
  std::filesystem::path output;
  Precision precision = Precision::Double;
  int threads = 0, width = 0, height = 0;
};

const std::map<std::string, Precision> kPrecisions{{"float", Precision::Float},
                                                   {"double", Precision::Double},
                                                   {"long-double", Precision::LongDouble},
                                                   {"quad", Precision::Quad}};

Picture chosen(const Rendering& rendering, const std::string& light, const Scene& scene) {
  if (light.empty() || light == "all") return rendering.whole;
  std::string names = "all";
  for (const Layer& layer : rendering.layers) {
    if (layer.light == light) return layer.picture;
    names += ", " + layer.light;
  }
  throw Refusal(
      fmt::format("--light: {} has no light \"{}\"; it has {}", scene.name, light, names));
}

void write_any(const std::filesystem::path& file, const Picture& picture) {
  if (file.extension() == ".exr") return write_picture(file, picture);
  if (file.extension() == ".png") return write_whole(file, encode_png(picture));
  throw Refusal(fmt::format(
      "-o: {}: litmus writes .exr (32-bit float, linear) and .png (8-bit sRGB)", file.string()));
}

int run(const Options& options) {
  Scene scene = load_scene(find_scene(options.scene));
  if (options.width > 0) scene.width = options.width;
  if (options.height > 0) scene.height = options.height;
  const Rendering rendering = render(scene, {options.precision, options.threads});
  if (options.light == "each") {
    write_layers(options.output, rendering.layers);
  } else {
    write_any(options.output, chosen(rendering, options.light, scene));
  }
  fmt::print(stderr, "{}: {} x {}, {}, {:.3f} s\n", options.output.string(), scene.width,
             scene.height, precision_name(options.precision), rendering.seconds);
  return kPass;
}

}  // namespace

void add_render(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("render", "Render a scene with litmus's own tracer");
  command->add_option("scene", options->scene, "Scene file or canonical name")->required();
  command
      ->add_option("-o,--output", options->output,
                   "Where to write: .exr (float, linear) or .png (sRGB)")
      ->required();
  command->add_option("--precision", options->precision, "float, double, long-double or quad")
      ->transform(CLI::CheckedTransformer(kPrecisions))
      ->default_str("double");
  command->add_option("--light", options->light,
                      "One light's part by its name, \"ambient\", \"all\" (default), or \"each\": "
                      "one EXR part a light");
  command->add_option("--threads", options->threads, "0: all; the picture does not depend on it")
      ->check(CLI::Range(0, 1024));
  command->add_option("--width", options->width, "Pixels, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  command->add_option("--height", options->height, "Pixels, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  command->footer("Example: litmus render s1 -o spot.exr --light lamp");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace litmus

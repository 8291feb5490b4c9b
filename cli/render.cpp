// render.cpp: litmus render, our own picture of a scene.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/render_settings.h"
#include "cli/render_terms.h"
#include "compare/image_io.h"
#include "compare/whole_file.h"
#include "scene/bands.h"
#include "scene/load.h"
#include "scene/refusal.h"
#include "tracer/autotune.h"
#include "tracer/bands.h"

namespace litmus {
namespace {

struct RenderArguments {
  std::string scene, light;
  std::filesystem::path output, bound, spectral;
  std::string precision = "double", sampler = "scene", kernel = "auto", effects = "needed";
  int threads = 0, width = 0, height = 0, area_samples = 0;
  bool terms = false, stats = false;
  double max_error = 0;
  std::string metric = "max";
};

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

/// Refuses a name that no picture can have, before it is rendered.
void check_name(const char* option, const std::filesystem::path& file) {
  if (!file.empty() && file.extension() != ".exr" && file.extension() != ".png")
    throw Refusal(
        fmt::format("{}: {}: litmus writes .exr (32-bit float, linear) and .png (8-bit sRGB)",
                    option, file.string()));
}

void write_any(const std::filesystem::path& file, const Picture& picture) {
  if (file.extension() == ".png") return write_whole(file, encode_png(picture));
  write_picture(file, picture);
}

int run_terms(const RenderArguments& options, const Scene& scene) {
  if (!options.light.empty() || options.precision != "double")
    throw Refusal("--terms: writes all lights in double; leave out --light and --precision");
  if (!options.spectral.empty())
    throw Refusal("--terms: what is in them does not depend on wavelength; leave out --spectral");
  if (options.output.extension() != ".exr")
    throw Refusal(fmt::format("-o: {}: --terms writes .exr", options.output.string()));
  const Layers layers = term_layers(scene);
  write_layers(options.output, layers, term_metadata(scene));
  fmt::print(stderr, "{}: {} x {}, {} layers{}\n", options.output.string(), scene.width,
             scene.height, layers.size(),
             scene.samples > 1 ? ", at the pixels' centres: the picture is a mean of samples" : "");
  return kPass;
}

/// Writes what each wavelength band shows, and gives the rendering of it all.
Rendering run_spectral(const RenderArguments& options, const Scene& scene,
                       const RenderOptions& how) {
  if (!scene.spectra)
    throw Refusal(
        fmt::format("--spectral: {} names no spectrum, so it has no wavelengths; give a "
                    "colour of it the name of one (scene/README.md)",
                    scene.name));
  if (options.spectral.extension() != ".exr")
    throw Refusal(fmt::format("--spectral: {}: litmus writes .exr", options.spectral.string()));
  BandRendering bands;
  write_bands(options.spectral, scene.width, scene.height, band_centres(*scene.spectra),
              [&](const PutRows& put) { bands = render_band_rows(scene, how, put); });
  fmt::print(stderr, "{}: {} x {}, {} bands, {:.3f} s\n", options.spectral.string(), scene.width,
             scene.height, scene.spectra->bands, bands.rendering.seconds);
  return std::move(bands.rendering);
}

// ---- The cheapest settings that keep an error ------------------------------------------------

ErrorMetric metric_of(const std::string& name) {
  for (const ErrorMetric metric : kErrorMetrics)
    if (metric_name(metric) == name) return metric;
  return ErrorMetric::Max;
}

int run_tuned(const RenderArguments& options, const Scene& scene) {
  if (options.precision != "double" || options.sampler != "scene" || options.area_samples != 0 ||
      options.kernel != "auto" || options.effects != "needed" || options.stats ||
      !options.light.empty() || !options.bound.empty() || !options.spectral.empty()) {
    throw Refusal(
        "--max-error: chooses the settings itself and writes the whole picture; leave out "
        "--precision, --sampler, --area-samples, --kernel, --effects, --stats, --light, --bound "
        "and "
        "--spectral");
  }
  const Tuned tuned = tune(scene, {.max_error = options.max_error,
                                   .metric = metric_of(options.metric),
                                   .threads = options.threads});
  write_any(options.output, tuned.rendering.whole);
  fmt::print(stderr, "{}: {}: {} error at most {:.2g}, {:.3g} s ({} settings tried)\n",
             options.output.string(), words(tuned.settings), options.metric, tuned.error,
             tuned.seconds, tuned.tried.size());
  if (tuned.met) return kPass;
  fmt::print(
      stderr,
      "litmus: --max-error {:.2g} cannot be kept; the picture is the most exact one that was "
      "tried\n",
      options.max_error);
  return kOutOfTolerance;
}

int run_render(const RenderArguments& options) {
  if (options.output.empty() && options.spectral.empty())
    throw Refusal("-o: give a file to write, .exr or .png");
  check_name("-o", options.output);
  check_name("--bound", options.bound);
  Scene scene = load_scene(find_scene(options.scene));
  if (options.width > 0) scene.width = options.width;
  if (options.height > 0) scene.height = options.height;
  for (const std::string& warning : scene.warnings) fmt::print(stderr, "warning: {}\n", warning);
  if (options.terms) return run_terms(options, scene);
  if (options.max_error > 0) return run_tuned(options, scene);
  RenderOptions settings{.precision = precision_of(options.precision),
                         .threads = options.threads,
                         .sampler = sampler_of(options.sampler),
                         .area_samples = options.area_samples};
  set_kernel(options.kernel, settings);
  settings.effects = effects_named(options.effects, scene);
  settings.layers = !options.light.empty() && options.light != "all";
  settings.edges = false;
  settings.counts = options.stats;
  if (!options.bound.empty() && settings.sampler != Sampler::Certified)
    throw Refusal("--bound: only --sampler certified knows a bound");
  if (!options.bound.empty() && scene.spectra)
    throw Refusal("--bound: of a spectral scene there is none");
  const Rendering rendering =
      options.spectral.empty() ? render(scene, settings) : run_spectral(options, scene, settings);
  if (!options.bound.empty()) write_any(options.bound, rendering.bound);
  if (options.output.empty()) return kPass;
  if (options.light == "each") {
    write_layers(options.output, rendering.layers);
  } else {
    write_any(options.output, chosen(rendering, options.light, scene));
  }
  if (options.stats) print_stats(scene, *settings.effects, rendering);
  fmt::print(stderr, "{}: {} x {}, {}, {:.3f} s\n", options.output.string(), scene.width,
             scene.height, options.precision, rendering.seconds);
  return kPass;
}

}  // namespace

void add_render(Program& program) {
  auto options = std::make_shared<RenderArguments>();
  Subcommand command = program.add("render", "Render a scene with litmus's own tracer");
  command.option("scene", options->scene, "Scene file or canonical name").required();
  command.option("-o,--output", options->output,
                 "Where to write: .exr (float, linear) or .png (sRGB)");
  command.option("--spectral", options->spectral,
                 "Where to write each wavelength band of a spectral scene: .exr, a layer a band "
                 "(S0.385,000000nm)");
  command.option("--precision", options->precision, "float, double, long-double or quad")
      .one_of(precision_names())
      .with_default();
  command.option("--light", options->light,
                 "One light's part by its name, \"ambient\", \"all\" (default), or \"each\": "
                 "one EXR part a light");
  command
      .option("--sampler", options->sampler,
              "Area lights: scene (as it says), centres or corners (the model's grids), "
              "gauss-legendre, jittered, r2, or certified (splits the rectangle until nothing is "
              "left to chance)")
      .one_of(sampler_names())
      .with_default();
  command
      .option("--area-samples", options->area_samples,
              "N along each side of an area light (certified: pieces down to 1/N, N rounded up to "
              "2^k or 3 * 2^k); 0: as the scene "
              "says")
      .between(0, 64);
  command.option("--bound", options->bound,
                 "With --sampler certified: also write how far each pixel can be off, as .exr");
  command
      .option(
          "--max-error", options->max_error,
          "Choose the cheapest settings that keep this error, absolute in linear RGB: against "
          "area lights as whole rectangles (however many samples the scene says), pixels as "
          "means over their area (scenes with samples = 1: at their centres), exact arithmetic. "
          "Exit code 1 if none does")
      .between(1e-12, 1e3);
  command
      .option("--metric", options->metric,
              "With --max-error: max (the worst pixel), p99 (what 99 % of the pixels keep) or rms")
      .one_of({"max", "p99", "rms"})
      .with_default();
  command.option("--threads", options->threads, "0: all; the picture does not depend on it")
      .between(0, 1024);
  command
      .option("--kernel", options->kernel,
              "packet (one or two of the processor's vectors) or scalar; the picture is the same")
      .one_of(kernel_names())
      .with_default();
  command
      .option(
          "--effects", options->effects,
          "needed (by the scene), all (everywhere, for comparison) or a list: ambient, diffuse, "
          "specular, shadows, linear, quadratic, cone, area, smooth, supersampling")
      .with_default();
  command.flag("--stats", options->stats,
               "Print the effects, the rays and the evaluations by kind, and the time");
  command.option("--width", options->width, "Pixels, instead of the scene's").between(1, 16384);
  command.option("--height", options->height, "Pixels, instead of the scene's").between(1, 16384);
  command.flag("--terms", options->terms,
               "Write the terms of the equation as EXR parts instead: ka, kd, ks, and for "
               "each light LIGHT.d, .l, .q, .alpha (radians), .decay, .l.n, .h.n, .power, "
               ".visibility, .diffuse and .specular, as far as it has them");
  command.footer("Example: litmus render s1 -o spot.exr --light lamp");
  command.on_run([options] { return run_render(*options); });
}

}  // namespace litmus

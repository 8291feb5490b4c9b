// cost.cpp: litmus cost, what accuracy costs in time.
#include <fmt/format.h>

#include <chrono>

#include "cli/commands.h"
#include "cli/work_folder.h"
#include "compare/whole_file.h"
#include "reference/drivers.h"
#include "reports/cost_study.h"
#include "reports/provenance.h"
#include "reports/write_cost.h"
#include "scene/load.h"

namespace litmus {
namespace {

struct CostArguments {
  std::string scene = "x4-area", command_line;
  std::filesystem::path out = "litmus-report";
  bool quick = false, references = false;
  int width = 0;
};

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

int run_cost(const CostArguments& options) {
  const Scene scene = load_scene(find_scene(options.scene));
  const WorkFolder work;
  std::filesystem::create_directories(options.out);
  const auto start = std::chrono::steady_clock::now();
  const std::string started = now();
  CostStudy study = measure_cost(
      scene, {options.quick, options.references, options.width, work.path,
              [](const std::string& text) { fmt::print(stderr, "cost: {}\n", text); }});
  std::vector<const Driver*> used;
  if (options.references)
    for (const Driver& driver : drivers()) used.push_back(&driver);
  study.provenance = provenance_of(used);
  study.provenance.command = options.command_line;
  study.provenance.started = started;
  study.provenance.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_whole(options.out / "cost.json", cost_json(study));
  write_whole(options.out / "cost.html", cost_html(study));
  for (const std::string& sentence : study.sentences) fmt::print("{}\n", sentence);
  for (const std::string& line : study.missing)
    fmt::print(stderr, "cost: not measured: {}\n", line);
  fmt::print(stderr, "{}, {}\n", (options.out / "cost.html").string(),
             (options.out / "cost.json").string());
  return study.missing.empty() ? kPass : kIncomplete;
}

}  // namespace

void add_cost(Program& program) {
  auto options = std::make_shared<CostArguments>();
  options->command_line = program.command_line;
  Subcommand command =
      program.add("cost", "Measure what accuracy costs in time, and write cost.html and cost.json");
  command.option("scene", options->scene, "Scene file or canonical name").with_default();
  command.option("--out", options->out, "Folder for cost.html and cost.json").with_default();
  command.flag("--quick", options->quick,
               "A first look: fewer settings, 3 repeats, 48 pixels wide");
  command.flag("--references", options->references,
               "POV-Ray and Blender on the same axes (some minutes)");
  command
      .option("--width", options->width,
              "Pixels, instead of the scene's width or 96, whichever is less")
      .between(1, 1024);
  command.footer("Example: litmus cost r3-area-umbra --references --out cost");
  command.on_run([options] { return run_cost(*options); });
}

}  // namespace litmus

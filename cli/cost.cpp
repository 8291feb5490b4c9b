// cost.cpp: litmus cost, what accuracy costs in time.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "cli/commands.h"
#include "cli/work_folder.h"
#include "compare/whole_file.h"
#include "reference/drivers.h"
#include "reports/cost_study.h"
#include "reports/effects_study.h"
#include "reports/peers.h"
#include "reports/provenance.h"
#include "reports/write_cost.h"
#include "reports/write_peers.h"
#include "scene/load.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

struct CostArguments {
  std::string scene = "x4-area", command_line;
  std::filesystem::path out = "litmus-report";
  bool quick = false, references = false, peers = false;
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

/// What a run was made with, once it is done.
class Stamp {
 public:
  Provenance of(const CostArguments& options, bool references) const {
    std::vector<const Driver*> used;
    if (references)
      for (const Driver& driver : drivers()) used.push_back(&driver);
    Provenance provenance = provenance_of(used);
    provenance.command = options.command_line, provenance.started = started_;
    provenance.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return provenance;
  }

 private:
  std::string started_ = now();
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void say(const std::string& text) { fmt::print(stderr, "cost: {}\n", text); }

int run_peers(const CostArguments& options) {
  if (options.references || options.width != 0)
    throw Refusal("--peers has pictures of its own: leave --references and --width out");
  const WorkFolder work;
  const Stamp stamp;
  std::filesystem::create_directories(options.out);
  PeerOptions peers{.quick = options.quick, .work = work.path, .progress = say};
  if (options.quick) peers.repeats = 3;
  const std::vector<PeerTask> tasks = measure_peers(peers);
  const Provenance provenance = stamp.of(options, true);
  write_whole(options.out / "peers.json", peers_json(tasks, peers, provenance));
  write_whole(options.out / "peers.html", peers_html(tasks, peers, provenance));
  fmt::print("{}", peers_text(tasks));
  fmt::print(stderr, "{}, {}\n", (options.out / "peers.html").string(),
             (options.out / "peers.json").string());
  return complete(tasks) ? kPass : kIncomplete;
}

/// The effects of the scene and of every canonical one.
void measure_canonical_effects(const Scene& scene, const CostOptions& options, CostStudy& study) {
  say("effects of all scenes");
  auto [scenes, left_out] = load_canonical_scenes();
  const bool canonical =
      std::ranges::any_of(scenes, [&](const Scene& one) { return one.name == scene.name; });
  if (!canonical) scenes.insert(scenes.begin(), scene);
  study.effects = measure_effects(scenes, options);
  study.effects_left_out = left_out;
  study.sentences.push_back(effects_sentence(study.effects));
}

int run_cost(const CostArguments& options) {
  if (options.peers) return run_peers(options);
  const Scene scene = load_scene(find_scene(options.scene));
  const WorkFolder work;
  const Stamp stamp;
  std::filesystem::create_directories(options.out);
  const CostOptions cost{options.quick, options.references, options.width, work.path, say};
  CostStudy study = measure_cost(scene, cost);
  measure_canonical_effects(scene, cost, study);
  study.provenance = stamp.of(options, options.references);
  write_whole(options.out / "cost.json", cost_json(study));
  write_whole(options.out / "cost.html", cost_html(study));
  for (const std::string& sentence : study.sentences) fmt::print("{}\n", sentence);
  for (const std::string& line : study.missing) say("not measured: " + line);
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
  command
      .option("--out", options->out,
              "Folder for cost.html and cost.json (--peers: peers.html, peers.json)")
      .with_default();
  command.flag("--quick", options->quick,
               "A first look: fewer settings, 3 repeats, 48 pixels wide (--peers: small pictures)");
  command.flag("--references", options->references,
               "POV-Ray and Blender on the same axes (some minutes)");
  command.flag("--peers", options->peers,
               "Instead: the same pictures and rays by litmus, POV-Ray, Cycles and Embree, and the "
               "least time that the counted arithmetic takes; a table of ratios (some minutes)");
  command
      .option("--width", options->width,
              "Pixels, instead of the scene's width or 96, whichever is less")
      .between(1, 1024);
  command.footer(
      "Example: litmus cost r3-area-umbra --references --out cost\n"
      "         litmus cost --peers");
  command.on_run([options] { return run_cost(*options); });
}

}  // namespace litmus

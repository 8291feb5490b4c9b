// run.cpp: litmus run, the main job: scenes against references, and a report.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <future>
#include <iterator>
#include <map>

#include "cli/commands.h"
#include "cli/work_folder.h"
#include "reference/candidates_file.h"
#include "reference/stored_images.h"
#include "reports/candidates.h"
#include "reports/controls.h"
#include "reports/github.h"
#include "reports/migration.h"
#include "reports/plain_text.h"
#include "reports/read_results.h"
#include "reports/study.h"
#include "reports/suspects.h"
#include "reports/write_html.h"
#include "reports/write_json.h"
#include "reports/write_junit.h"
#include "reports/write_markdown.h"
#include "scene/load.h"
#include "scene/observer.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::vector<std::string> scenes, with, require;
  std::string sources = "auto", control, command, candidates, baseline, annotations = "auto";
  fs::path out = "litmus-report", store = default_store_directory();
  int threads = 0, time_limit = 300;
  bool fresh = false, refresh = false, quiet = false, native = false;
};

/// Of all canonical scenes those that need a package which is not installed are left out, and
/// `left_out` says so; a scene that is asked for is refused.
std::vector<Scene> load_all(const std::vector<std::string>& names,
                            std::vector<std::string>& left_out) {
  std::vector<Scene> scenes;
  if (names.empty()) {
    CanonicalScenes all = load_canonical_scenes();
    scenes = std::move(all.scenes);
    for (const std::string& why : all.left_out) left_out.push_back("left out: " + why);
  }
  for (const std::string& name : names) {
    scenes.push_back(load_scene(find_scene(name)));
    for (const Scene& other : std::span(scenes).first(scenes.size() - 1)) {
      if (other.name == scenes.back().name) {
        throw Refusal(fmt::format("{} and {} have one name: rename one of the files",
                                  other.file.string(), scenes.back().file.string()));
      }
    }
  }
  for (const Scene& scene : scenes)
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return scenes;
}

StudyOptions study_options(const RunArguments& options, const Store& store, const fs::path& work) {
  StudyOptions study;
  study.references = options.with;
  study.control = options.control;
  if (!options.candidates.empty()) study.candidates = load_candidates(options.candidates);
  study.native = options.native;
  study.threads = options.threads;
  study.obtain.sources = parse_sources(options.sources);
  study.obtain.store = &store;
  study.obtain.fresh = options.fresh || options.refresh;
  study.obtain.program_version = LITMUS_VERSION;
  study.obtain.reference.work = work;
  study.obtain.reference.time_limit = std::chrono::seconds(options.time_limit);
  if (options.threads > 0) study.obtain.reference.threads = options.threads;
  if (!options.quiet) {
    study.obtain.reference.progress = [](const std::string& line) {
      fmt::print(stderr, "{}\n", line);
    };
  }
  return study;
}

/// Keeps what the renderers just made as the images that ship with litmus.
void keep_as_stored(std::span<const Scene> scenes, const Study& study) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Case& entry = study.cases[i];
    for (std::size_t r = 0; r < entry.references.size(); ++r) {
      const CaseReference& reference = entry.references[r];
      if (reference.source != "live" || !find_driver(reference.reference)) continue;
      StoredReference images{{}, reference.version, reference.command, reference.seconds};
      for (std::size_t k = 0; k + 1 < entry.layers.size(); ++k) {
        const CaseLayer& layer = entry.layers[k];
        images.layers.push_back({layer.light, layer.light_type, layer.theirs[r].picture});
      }
      if (scenes[i].spectra) images.layers = reference.bands;
      save_stored(scenes[i], reference.reference, images);
    }
  }
}

/// Names that --require asks for and that were not rendered live for every scene.
std::vector<std::string> missing_requirements(const RunArguments& options, const Study& study) {
  std::vector<std::string> missing;
  for (const std::string& name : options.require) {
    bool live = false;
    for (const Comparison& row : study.comparisons) {
      if (row.reference != name) continue;
      live = row.source == "live";
      if (!live) break;
    }
    if (!live) missing.push_back(name);
  }
  return missing;
}

/// What the verdict does not count: how far candidates are from the references, and the renderers'
/// own lights from the model; and what the candidates' encodings cannot show.
void print_candidates(const Study& study) {
  const std::vector<InformativeLine> lines = informative_lines(study);
  if (!lines.empty()) {
    fmt::print("{:<16} {:<12} {:>12} {:>12} {:>12}\n", "not judged", "light type", "to litmus",
               "to POV-Ray", "to Blender");
    for (const InformativeLine& line : lines) {
      fmt::print("{:<16} {:<12}", line.reference, line.light_type);
      for (const std::optional<double>& largest : line.largest)
        fmt::print(" {:>12}", largest ? fmt::format("{:.2g}", *largest) : "");
      fmt::print("\n");
    }
  }
  for (const CandidateNote& candidate : study.candidates)
    if (!candidate.note.empty()) fmt::print("{}: {}\n", candidate.name, candidate.note);
}

/// The references among themselves, where there are two.
void print_pairs(const Study& study) {
  if (study.pairs.empty()) return;
  fmt::print("{:<16} {:<12} {:>13} {:>18}\n", "each against", "each", "interior max", "failed");
  for (const PairLine& line : pair_lines(study))
    if (line.against != "litmus")
      fmt::print("{:<16} {:<12} {:>13.2g} {:>18}\n", line.reference, line.against, line.largest,
                 line.failed);
}

void print_summary(const Study& study, const fs::path& out) {
  std::map<std::pair<std::string, std::string>, std::map<std::string, std::pair<double, int>>>
      worst;
  std::map<std::string, int> verdicts;
  for (const Comparison& row : study.comparisons) {
    ++verdicts[row.verdict];
    auto& cell = worst[{row.light_type, row.reference}][row.region];
    cell.first = std::max(cell.first, row.max_abs);
    cell.second += row.verdict == "fail";
  }
  fmt::print("{:<12} {:<16} {:>13} {:>10} {:>7}\n", "light type", "reference", "interior max",
             "edge max", "failed");
  for (auto& [key, regions] : worst) {
    fmt::print("{:<12} {:<16} {:>13.2g} {:>10.2g} {:>7}\n", key.first, key.second,
               regions["interior"].first, regions["edge"].first, regions["all"].second);
  }
  print_pairs(study);
  print_candidates(study);
  fmt::print("{} rows pass, {} fail, {} skipped: {}\n", verdicts["pass"], verdicts["fail"],
             verdicts["skipped"], overall_verdict(study));
  fmt::print("report: {}\n", (fs::absolute(out) / "report.html").lexically_normal().string());
}

void print_baseline(const BaselineReport& report) {
  fmt::print("against the baseline {}: {}\n", report.file, baseline_headline(report));
  for (const BaselineChange& change : report.changes)
    fmt::print("  {}: {}\n", change.kind, sentence_of(change));
  for (const SpeedChange& change : report.slower) fmt::print("  slower: {}\n", sentence_of(change));
  for (const VersionChange& change : report.versions) fmt::print("  {}\n", sentence_of(change));
}

/// Against a baseline, what failed there too does not fail the run again.
int exit_code_of(const Study& study) {
  const std::string verdict = overall_verdict(study);
  if (verdict == "broken") return kRendererFailed;
  if (study.baseline ? is_regression(*study.baseline) : verdict == "fail") return kOutOfTolerance;
  const bool skipped = std::any_of(study.comparisons.begin(), study.comparisons.end(),
                                   [](const auto& row) { return row.verdict == "skipped"; });
  return skipped || study.comparisons.empty() ? kIncomplete : kPass;
}

bool annotates(const RunArguments& options) {
  const char* inside = std::getenv("GITHUB_ACTIONS");
  return options.annotations == "github" ||
         (options.annotations == "auto" && inside && std::string_view(inside) == "true");
}

/// The results to compare with, read before anything is rendered. Throws Refusal if they are no
/// results, or if the report would replace them.
std::optional<Study> read_baseline(const RunArguments& options) {
  if (options.baseline.empty()) return std::nullopt;
  Study baseline = read_results(options.baseline);
  std::error_code missing;
  if (fs::equivalent(options.baseline, options.out / "results.json", missing))
    throw Refusal(
        fmt::format("--baseline: {} is what this run's report would replace: copy it, or "
                    "give the report another folder with --out",
                    options.baseline));
  return baseline;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

int run_scenes(const RunArguments& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::string started = utc_now();
  const std::optional<Study> baseline = read_baseline(options);
  std::vector<std::string> left_out;
  const std::vector<Scene> scenes = load_all(options.scenes, left_out);
  const Store store = open_store(
      options.store, [](const std::string& line) { fmt::print(stderr, "warning: {}\n", line); });
  const WorkFolder work;
  Study study = run_study(scenes, study_options(options, store, work.path));
  study.provenance.command = options.command;
  study.provenance.started = started;
  study.provenance.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  study.warnings.insert(study.warnings.end(), left_out.begin(), left_out.end());
  const std::vector<Migration> migrated =
      migrations(study, scenes, baseline ? &*baseline : nullptr, stored_images_directory());
  if (options.refresh) keep_as_stored(scenes, study);
  if (baseline) study.baseline = against_baseline(study, *baseline, nearby(options.baseline));

  fs::create_directories(options.out);
  auto page =
      std::async(std::launch::async, [&] { write_html(study, options.out / "report.html"); });
  write_json(study, options.out / "results.json");
  write_markdown(study, options.out / "summary.md");
  write_junit(study, options.out / "junit.xml");
  write_migration(migrated, options.out);
  page.get();
  if (study.baseline) print_baseline(*study.baseline);
  print_summary(study, options.out);
  if (annotates(options)) fmt::print("{}", github_annotations(study));
  for (const std::string& warning : study.warnings) fmt::print(stderr, "warning: {}\n", warning);
  for (const Case& entry : study.cases) {
    for (const CaseReference& reference : entry.references) {
      if (reference.failure.empty()) continue;
      fmt::print(stderr, "{}, {}: {}\n{}\n", entry.scene, reference.reference, reference.failure,
                 reference.log);
    }
  }
  const std::vector<std::string> missing = missing_requirements(options, study);
  if (!missing.empty()) {
    fmt::print(stderr, "litmus: --require: {} did not render every scene live\n",
               fmt::join(missing, ", "));
    return kRendererFailed;
  }
  const int code = exit_code_of(study);
  return code == kPass && !left_out.empty() ? int(kIncomplete) : code;
}

std::string control_help() {
  std::string help = "Put a known mistake into our side only; the run must then fail:";
  for (const Control& control : controls())
    help += fmt::format("\n  {}: {}", control.name, control.about);
  return help;
}

}  // namespace

void add_run(Program& program) {
  auto options = std::make_shared<RunArguments>();
  options->command = program.command_line;
  Subcommand command = program.add("run", "Compare scenes with the references and write a report");
  command.option("scenes", options->scenes,
                 "Scene files or canonical names; none: all canonical scenes");
  command
      .option("--references", options->sources,
              "auto: live where the renderer is installed, else stored images; live; stored")
      .one_of({"auto", "live", "stored"})
      .with_default();
  command
      .option("--out", options->out, "Folder for report.html, results.json, summary.md, junit.xml")
      .with_default();
  command.option("--with", options->with, "Only these references (povray,blender,closed-form)")
      .separated_by(',');
  command
      .option("--require", options->require,
              "Exit 4 unless these references are live (povray,blender)")
      .separated_by(',');
  command.option("--candidates", options->candidates,
                 "A litmus.toml that lists renderers of your own (examples/candidate)");
  command.flag("--native", options->native,
               "Measure the renderers' own lights, too; for information, never judged");
  command.option("--control", options->control, control_help());
  command
      .option(
          "--annotations", options->annotations,
          "github: failures as lines that GitHub shows beside the scene's file; auto: inside of "
          "GitHub; none")
      .one_of({"auto", "github", "none"})
      .with_default();
  command.option("--baseline", options->baseline,
                 "An earlier results.json, which stays as it is: say what is new, worse, fixed or "
                 "slower, and exit 1 on a new failure or on a row that is worse, only");
  command.option("--store", options->store, "Folder that keeps rendered references between runs")
      .with_default();
  command.option("--threads", options->threads, "0: all").between(0, 1024);
  command.option("--time-limit", options->time_limit, "Seconds for one process of a renderer")
      .between(1, 86400)
      .with_default();
  command.flag("--fresh", options->fresh, "Render the references anew even if the store has them");
  command.flag("--refresh", options->refresh,
               "--fresh, and keep the live images as the stored references that ship with litmus");
  command.flag("-q,--quiet", options->quiet, "No progress");
  command.footer("Example: litmus run d2 s5 --references live --out report");
  command.on_run([options] { return run_scenes(*options); });
}

}  // namespace litmus

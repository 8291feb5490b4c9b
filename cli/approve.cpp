// approve.cpp: litmus approve, which accepts failures of the last run after a person looked at
// them.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/commands.h"
#include "cli/work_folder.h"
#include "compare/whole_file.h"
#include "reference/stored_images.h"
#include "reports/approval.h"
#include "reports/plain_text.h"
#include "reports/read_results.h"
#include "scene/document.h"
#include "scene/load.h"
#include "scene/refusal.h"
#include "scene/words.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

struct ApproveArguments {
  std::vector<std::string> cases;
  fs::path results = "litmus-report/results.json", store = default_store_directory();
  std::string reason;
  int time_limit = 300;
  bool dry_run = false;
};

/// A scene against a reference.
struct Chosen {
  const Case* entry = nullptr;
  std::string reference;
};

const Case& find_case(const Study& study, const std::string& word) {
  std::vector<std::string> names;
  for (const Case& one : study.cases) {
    if (one.scene == word || one.scene.substr(0, one.scene.find('-')) == word) return one;
    names.push_back(one.scene);
  }
  throw Refusal(
      fmt::format("{}: is not a case of these results; they have {}", word, listed(names)));
}

/// "s5" is each reference that fails in s5; "s5/blender" that one.
void choose(const Study& study, const std::string& word, std::vector<Chosen>& chosen) {
  const std::size_t slash = word.rfind('/');
  const Case& one = find_case(study, word.substr(0, slash));
  const std::string wanted = slash == word.npos ? "" : word.substr(slash + 1);
  const std::size_t before = chosen.size();
  for (const CaseReference& reference : one.references) {
    const bool fails =
        !reference.failure.empty() ||
        std::any_of(study.comparisons.begin(), study.comparisons.end(), [&](const Comparison& row) {
          return row.scene == one.scene && row.verdict == "fail" &&
                 row.reference == reference.reference;
        });
    if (wanted.empty() ? fails : wanted == reference.reference)
      chosen.push_back({&one, reference.reference});
  }
  if (chosen.size() == before)
    throw Refusal(fmt::format("{}: {}", word,
                              wanted.empty() ? "nothing fails there, so there is nothing to approve"
                                             : "these results have no such reference"));
}

std::vector<Chosen> chosen_cases(const Study& study, const ApproveArguments& options) {
  std::vector<Chosen> chosen;
  for (const std::string& word : options.cases) choose(study, word, chosen);
  std::string refusals;
  for (const Chosen& one : chosen)
    if (const std::string why = approval_refusal(study, one.entry->scene, one.reference);
        !why.empty())
      refusals += (refusals.empty() ? "" : "\nlitmus: ") + why;
  if (!refusals.empty()) throw Refusal(refusals);
  return chosen;
}

/// A live picture that fails, to be kept in place of the stored one.
struct NewImage {
  Scene scene;
  std::string reference;
  StoredReference images;
};

/// The pictures that the results speak of, from the store or rendered again. Throws Refusal if they
/// do not give the figures of the results: then nobody has looked at them.
NewImage picture_of(const Study& results, const Chosen& chosen, const ApproveArguments& options) {
  const std::string where = chosen.entry->scene + "/" + chosen.reference;
  Scene scene = load_scene(chosen.entry->file);
  const Store store = open_store(
      options.store, [](const std::string& line) { fmt::print(stderr, "warning: {}\n", line); });
  const WorkFolder work;
  StudyOptions study_options;
  study_options.references = {chosen.reference};
  study_options.obtain.sources = Sources::Live;
  study_options.obtain.store = &store;
  study_options.obtain.program_version = LITMUS_VERSION;
  study_options.obtain.reference.work = work.path;
  study_options.obtain.reference.time_limit = std::chrono::seconds(options.time_limit);
  const Study now = run_study({&scene, 1}, study_options);
  const Case& entry = now.cases.front();
  const CaseReference& reference = entry.references.front();
  if (!reference.failure.empty()) throw Refusal(fmt::format("{}: {}", where, reference.failure));
  for (const Comparison* was : failing_rows(results, chosen.entry->scene, chosen.reference)) {
    const auto same = [&](const Comparison& row) {
      return row.reference == was->reference && row.light == was->light &&
             row.region == was->region && row.max_abs == was->max_abs &&
             row.mean_abs == was->mean_abs;
    };
    if (std::none_of(now.comparisons.begin(), now.comparisons.end(), same))
      throw Refusal(
          fmt::format("{}: litmus or the renderer gives another picture now than in {}: "
                      "run again, look again",
                      where, options.results.string()));
  }
  NewImage image{std::move(scene),
                 chosen.reference,
                 {{}, reference.version, reference.command, reference.seconds}};
  for (std::size_t k = 0; k + 1 < entry.layers.size(); ++k) {
    const CaseLayer& layer = entry.layers[k];
    image.images.layers.push_back({layer.light, layer.light_type, layer.theirs.front().picture});
  }
  if (image.scene.spectra) image.images.layers = reference.bands;
  return image;
}

bool is_live(const Chosen& chosen) {
  for (const CaseReference& reference : chosen.entry->references)
    if (reference.reference == chosen.reference) return reference.source == "live";
  return false;
}

void print_image(const NewImage& image) {
  const StoredLookup old = load_stored(image.scene, image.reference);
  const fs::path file = stored_images_directory() / image.scene.name / (image.reference + ".exr");
  fmt::print("--- {0}\n+++ {0}\n-{1}\n+{2} {3}\n", nearby(file),
             old.images ? image.reference + " " + old.images->version : old.reason, image.reference,
             image.images.version);
}

/// Replaces the tolerances, once the new text has been read back and found sound.
void write_tolerances(const fs::path& file, const std::string& text) {
  write_whole(file, [&](const fs::path& temporary) {
    write_whole(temporary, text);
    load_tolerances(temporary);
  });
}

int run_approve(const ApproveArguments& options) {
  const Study results = read_results(options.results);
  const std::vector<Chosen> chosen = chosen_cases(results, options);
  std::vector<const Comparison*> rows;
  std::vector<NewImage> images;
  for (const Chosen& one : chosen) {
    for (const Comparison* row : failing_rows(results, one.entry->scene, one.reference))
      rows.push_back(row);
    if (is_live(one)) images.push_back(picture_of(results, one, options));
  }
  const fs::path file = tolerances_file();
  const std::string before = read_limited(file);
  const std::string after =
      edited_tolerances(before, tolerances(), raised_tolerances(rows, options.reason));
  const std::string diff = line_diff(nearby(file), before, after);
  fmt::print("{}", diff);
  for (const NewImage& image : images) print_image(image);
  if (options.dry_run) {
    fmt::print("nothing is written (--dry-run)\n");
    return kPass;
  }
  for (const NewImage& image : images) save_stored(image.scene, image.reference, image.images);
  if (!diff.empty()) write_tolerances(file, after);
  fmt::print("approved: {}; run again to see it pass\n",
             counted((long long)(rows.size()), "row", "rows"));
  return kPass;
}

}  // namespace

void add_approve(Program& program) {
  auto options = std::make_shared<ApproveArguments>();
  Subcommand command = program.add(
      "approve",
      "Accept failures of the last run: raise their tolerances, keep their live images as stored "
      "ones");
  command
      .option("cases", options->cases,
              "Scenes of the results (s5), or one reference of a scene (s5/blender)")
      .required();
  command.option("--reason", options->reason, "Why the error is right, for tolerances.toml")
      .required();
  command.option("--results", options->results, "results.json of that run").with_default();
  command.option("--store", options->store, "Folder that keeps rendered references between runs")
      .with_default();
  command.option("--time-limit", options->time_limit, "Seconds for one process of a renderer")
      .between(1, 86400)
      .with_default();
  command.flag("--dry-run", options->dry_run, "Show what would change, and change nothing");
  command.footer(
      "Never approved: pixels that are not finite, unregistered pictures, a renderer that failed, "
      "a difference from a closed form.\n"
      "Example: litmus approve s5/blender --reason 'Cycles 4 rounds the cone once more' --dry-run");
  command.on_run([options] { return run_approve(*options); });
}

}  // namespace litmus

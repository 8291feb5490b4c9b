// doctor.cpp: litmus doctor, what is installed and what each missing thing costs.
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "compare/image_io.h"
#include "reference/drivers.h"
#include "reference/store.h"
#include "reference/stored_images.h"
#include "reports/provenance.h"
#include "scene/load.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

void print_row(std::string_view name, std::string_view text) {
  fmt::print("{:<15} {}\n", name, text);
}

std::string missing_text(const Driver& driver) {
  return fmt::format(
      "not installed: only canonical scenes can be compared, with stored images, and no scene of "
      "your own; remedy: apt-get install {}",
      driver.package);
}

/// Prints what opens images; false if nothing does.
bool print_image_library() {
  try {
    print_row("OpenImageIO", image_library_version());
    return true;
  } catch (const Refusal& refusal) {
    print_row(
        "OpenImageIO",
        fmt::format("missing, nothing but list, export and explain --reference none works: {}",
                    refusal.what()));
    return false;
  }
}

int run_doctor() {
  const auto [scenes, left_out] = load_canonical_scenes();
  const Provenance provenance = provenance_of({});
  print_row("litmus", fmt::format("{} ({})", provenance.litmus_version, provenance.commit));
  const bool images = print_image_library();
  print_row("scenes", fmt::format("{} canonical, in {}", scenes.size(), data_directory().string()));
  for (const std::string& why : left_out) print_row("", "left out: " + why);
  print_row("store", default_store_directory().string());
  int exit_code = images && left_out.empty() ? kPass : kIncomplete;
  for (const Driver& driver : drivers()) {
    const auto installation = driver.find();
    if (!installation) exit_code = kIncomplete;
    print_row(driver.title, installation ? fmt::format("{} at {}", installation->version,
                                                       installation->program.string())
                                         : missing_text(driver));
    if (!images) continue;
    const auto stored = std::count_if(scenes.begin(), scenes.end(), [&](const Scene& scene) {
      return load_stored(scene, driver.name).images.has_value();
    });
    print_row("", fmt::format("stored images for {} of {} scenes", stored, scenes.size()));
  }
  return exit_code;
}

}  // namespace

void add_doctor(Program& program) {
  Subcommand command =
      program.add("doctor", "Say what is installed and what a missing thing costs");
  command.footer("Exit code 0: all is there; 3: something is missing.");
  command.on_run([] { return run_doctor(); });
}

}  // namespace litmus

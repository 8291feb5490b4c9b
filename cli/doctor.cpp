// doctor.cpp: litmus doctor, what is installed and what each missing thing costs.
#include <fmt/format.h>

#include "cli/commands.h"
#include "compare/image_io.h"
#include "reference/drivers.h"
#include "reference/store.h"
#include "reference/stored_images.h"
#include "scene/load.h"

namespace litmus {
namespace {

int stored_count(const Driver& driver) {
  int count = 0;
  for (const auto& file : canonical_scenes())
    count += load_stored(load_scene(file), driver.name).images.has_value();
  return count;
}

int run() {
  const std::size_t scenes = canonical_scenes().size();
  int exit_code = kPass;
  fmt::print("litmus        {} ({})\n", LITMUS_VERSION, LITMUS_COMMIT);
  fmt::print("OpenImageIO   {}\n", image_library_version());
  fmt::print(
      "scenes        {} in {}\n", scenes,
      (canonical_scenes().empty() ? data_directory() : canonical_scenes().front().parent_path())
          .string());
  fmt::print("store         {}\n", default_store_directory().string());
  for (const Driver& driver : drivers()) {
    const auto installation = driver.find();
    const int stored = stored_count(driver);
    if (installation) {
      fmt::print("{:<13} {} at {}\n", driver.title, installation->version,
                 installation->program.string());
    } else {
      fmt::print(
          "{:<13} not installed: only the {} scenes with stored images can be compared, and no "
          "scene of "
          "your own; remedy: apt-get install {}\n",
          driver.title, stored, driver.package);
      exit_code = kIncomplete;
    }
    fmt::print("{:<13} stored images for {} of {} scenes\n", "", stored, scenes);
  }
  return exit_code;
}

}  // namespace

void add_doctor(CLI::App& program, int& exit_code) {
  CLI::App* command =
      program.add_subcommand("doctor", "Say what is installed and what a missing thing costs");
  command->footer("Exit code 0: all is there; 3: something is missing.");
  command->callback([&exit_code] { exit_code = run(); });
}

}  // namespace litmus

// store_kill_test.cpp: kill -9 at random moments never leaves an entry that is used and wrong.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <thread>

#include "compare/image_io.h"
#include "reference/hash.h"
#include "reference/obtain.h"
#include "reference/process.h"
#include "tests/reference/sample_scene.h"

extern char** environ;

namespace litmus {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKillFolder = "LITMUS_KILL_TEST_FOLDER";
constexpr int kScenes = 8;

std::vector<Scene> run_scenes() {
  std::vector<Scene> scenes;
  for (int i = 0; i < kScenes; ++i) {
    scenes.push_back(sample_scene(fmt::format("scene-{}", i), 0.01 * (i + 1)));
    scenes.back().width = scenes.back().height = 20;
  }
  return scenes;
}

double seed_of(const Scene& scene) { return scene.ambient.x * 1000; }

std::optional<Installation> find_shell() { return Installation{"/bin/sh", "1.0"}; }
std::string shell_source(const Scene& scene) { return scene.name; }

/// Has a shell "render" each scene: it writes the seed that decides the pixels.
void render_in_shell(const Installation&, std::span<const Scene> scenes,
                     const ReferenceOptions& options, const ResultSink& sink) {
  for (const auto& scene : scenes) {
    ReferenceResult result;
    result.scene = scene.name;
    result.log = options.work / "log";
    Command command;
    command.arguments = {"sh", "-c", "echo $0 >seed", fmt::format("{}", seed_of(scene))};
    command.directory = options.work;
    command.log = result.log;
    const auto ran = run_process(command);
    if (ran.ok())
      result.layers = sample_layers(scene, std::stod(text_of(options.work / "seed")));
    else
      result.failure = ran.explanation;
    sink(std::move(result));
  }
}

std::vector<ObtainedReference> fill(const fs::path& folder, const Store& store, bool fresh) {
  ObtainOptions options;
  options.store = &store;
  options.fresh = fresh;
  options.program_version = "0.1.0";
  options.reference.work = folder / "work";
  const Driver driver{"fake", "Fake", "fake", 1, find_shell, shell_source, render_in_shell};
  return obtain(run_scenes(), driver, options);
}

/// What lies in the store, judged without the store's own code.
struct Inventory {
  int sound = 0, unsound = 0, temporary = 0, aside = 0;
};

Inventory take_inventory(const fs::path& root) {
  Inventory found;
  if (!fs::exists(root)) return found;
  for (const auto& two : fs::directory_iterator(root))
    for (const auto& entry : fs::directory_iterator(two.path())) {
      const auto name = entry.path().filename().string();
      if (name.starts_with(".tmp-")) {
        ++found.temporary;
      } else if (name.starts_with(".damaged-")) {
        ++found.aside;
      } else {
        const auto meta =
            nlohmann::json::parse(text_of(entry.path() / "meta.json"), nullptr, false);
        const bool sound = !meta.is_discarded() && fs::exists(entry.path() / "image.exr") &&
                           meta["checksum"] == hash_file(entry.path() / "image.exr");
        ++(sound ? found.sound : found.unsound);
      }
    }
  return found;
}

/// Starts a process that fills the store, then replaces its entries until it is killed.
pid_t start_run(const fs::path& folder) {
  const pid_t pid = ::fork();
  if (pid != 0) return pid;
  const auto store = open_store(folder / "store");
  for (bool fresh = false;; fresh = true) fill(folder, store, fresh);
}

/// Kills a run and returns whether that is what ended it.
bool kill_run(pid_t victim) {
  ::kill(victim, SIGKILL);
  int status = 0;
  return ::waitpid(victim, &status, 0) == victim && WIFSIGNALED(status);
}

/// How long a run takes on this machine until its first entry is in an empty store.
std::chrono::microseconds time_to_an_entry(const fs::path& folder) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t run = start_run(folder);
  while (take_inventory(folder / "store").sound == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill_run(run);
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() -
                                                               start);
}

/// Kills 100 runs at random moments and counts what they leave.
nlohmann::json kill_runs(const fs::path& folder) {
  image_library_version();  // opened before the forks, or most moments would fall into opening it
  const auto root = folder / "store";
  std::mt19937 random(20);
  std::uniform_int_distribution<long> moments(1, 3 * time_to_an_entry(folder).count());
  int killed = 0, partly = 0, left_behind = 0, unsound = 0;
  for (int run = 0; run < 100; ++run) {
    if (run % 3 == 0) fs::remove_all(root);  // begin from nothing, from a part, from the whole
    const pid_t victim = start_run(folder);
    std::this_thread::sleep_for(std::chrono::microseconds(moments(random)));
    killed += kill_run(victim);
    const auto found = take_inventory(root);
    partly += found.sound > 0 && found.sound < 3 * kScenes;
    left_behind += found.temporary > 0;
    unsound += found.unsound + found.aside;
  }
  return {
      {"killed", killed}, {"partly", partly}, {"left_behind", left_behind}, {"unsound", unsound}};
}

/// A fork lacks the threads that the image library may have started by then. So the kills happen in
/// this program started again, which finds the folder in its environment and never reaches main().
const bool outside_the_kills = [] {
  const char* folder = std::getenv(kKillFolder);
  if (!folder) return true;
  write_text(fs::path(folder) / "kills.json", kill_runs(folder).dump());
  ::_exit(0);
}();

nlohmann::json kills_in(const fs::path& folder) {
  ::setenv(kKillFolder, folder.c_str(), 1);
  char program[] = "/proc/self/exe";
  char* arguments[] = {program, nullptr};
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, program, nullptr, nullptr, arguments, environ);
  ::unsetenv(kKillFolder);
  int status = -1;
  if (error != 0 || ::waitpid(pid, &status, 0) != pid || status != 0)
    throw std::runtime_error("the kills did not take place");
  return nlohmann::json::parse(text_of(folder / "kills.json"));
}

void expect_the_right_pictures(const std::vector<ObtainedReference>& results) {
  const auto scenes = run_scenes();
  ASSERT_EQ(results.size(), scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto expected = sample_layers(scenes[i], seed_of(scenes[i]));
    ASSERT_EQ(results[i].layers.size(), expected.size()) << results[i].failure;
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_TRUE(same(results[i].layers[k].picture, expected[k].picture)) << i << " " << k;
  }
}

struct KilledRuns : InFolder {
  fs::path root = folder / "store";
};

TEST_F(KilledRuns, LeaveNoEntryThatIsUsedAndWrong) {
  ASSERT_TRUE(outside_the_kills);
  const auto kills = kills_in(folder);
  EXPECT_EQ(kills["killed"], 100);
  EXPECT_EQ(kills["unsound"], 0);
  // The moments were worth something: runs died in the midst, some while they wrote an entry.
  EXPECT_GT(kills["partly"], 0) << kills;
  EXPECT_GT(kills["left_behind"], 0) << kills;
  RecordProperty("kills", kills.dump());

  // The next run completes, from what they left.
  std::vector<std::string> warnings;
  const auto store = open_store(root, [&](const std::string& text) { warnings.push_back(text); });
  expect_the_right_pictures(fill(folder, store, false));
  const auto found = take_inventory(root);
  EXPECT_EQ(found.sound, 3 * kScenes);
  EXPECT_EQ(found.unsound + found.temporary + found.aside, 0);
  EXPECT_THAT(warnings, testing::IsEmpty());
}

TEST_F(KilledRuns, AreJudgedByAnInventoryThatSeesDamage) {
  const auto store = open_store(root);
  fill(folder, store, false);
  for (const auto& file : fs::recursive_directory_iterator(root))
    if (file.path().filename() == "image.exr") {
      fs::resize_file(file.path(), fs::file_size(file.path()) - 1);
      break;
    }
  EXPECT_EQ(take_inventory(root).unsound, 1);
  expect_the_right_pictures(fill(folder, store, false));
  EXPECT_EQ(take_inventory(root).unsound, 0);
  EXPECT_EQ(take_inventory(root).aside, 1);
}

}  // namespace
}  // namespace litmus

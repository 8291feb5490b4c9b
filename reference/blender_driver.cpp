// blender_driver.cpp: one Blender process for many scenes.
#include "reference/blender_driver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "exporters/blender.h"
#include "reference/frames.h"
#include "reference/process.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

// What decides the image apart from the export; --factory-startup and -Y keep the user's own
// settings and scripts out.
const std::vector<std::string> kArguments = {
    "-b", "--factory-startup", "-Y", "--debug-cycles", "--python-exit-code", "9"};

std::string as_blender(const Scene& scene) {
  std::ostringstream out;
  write_blender(scene, out);
  return out.str();
}

std::string blender_source(const Scene& scene) {
  return fmt::format("{}\n{}\n", as_blender(without_words(scene)), fmt::join(kArguments, " "));
}

std::optional<Installation> find_blender() { return find_installation("blender", "Blender "); }

std::string label(std::size_t scene) { return fmt::format("{:04}", scene); }

fs::path frame_file(const Scene& scene, const fs::path& folder, std::size_t frame) {
  return folder / fmt::format("{}_{:04}.exr", blender_stem(scene), frame + 1);
}

/// Adds a frame to a layer's picture.
void add_frame(const Scene& scene, const fs::path& file, Picture& sum) {
  const Picture frame = averaged(read_frame(scene, file), scene.samples);
  for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += frame.pixels[i];
}

Layers read_layers_of(const Scene& scene, const fs::path& folder) {
  Layers layers{{"ambient", "ambient", Picture(scene.width, scene.height)}};
  for (const Light& light : scene.lights) {
    layers.push_back(
        {light.name, std::string(light_type(light)), Picture(scene.width, scene.height)});
  }
  const std::vector<BlenderFrame> frames = blender_frames(scene);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    add_frame(scene, frame_file(scene, folder, i),
              layers[std::size_t(frames[i].light + 1)].picture);
  }
  return layers;
}

/// A batch under way: which scenes are still to do, and how far the running process has come.
struct Batch {
  const Installation& blender;
  std::span<const Scene> scenes;
  const ReferenceOptions& options;
  const ResultSink& sink;
  std::vector<std::size_t> waiting;  ///< in order
  std::string command;
  fs::path log;
  std::string text;      ///< of the log, as far as it has been read
  std::size_t done = 0;  ///< where in it the last line about an ended scene ends

  void report(std::size_t scene, const std::string& failure) {
    ReferenceResult result;
    result.scene = scenes[scene].name;
    result.command = command;
    result.log = log;
    result.failure = failure;
    const fs::path folder = options.work / label(scene);
    if (failure.empty()) try {
        result.layers = read_layers_of(scenes[scene], folder);
        result.seconds = blender_render_seconds(text, scene);
      } catch (const std::exception& error) {
        result.failure = error.what();
        result.layers.clear();
      }
    if (options.progress) {
      options.progress(fmt::format("Blender: {}{}", result.scene,
                                   result.failure.empty() ? "" : ": " + result.failure));
    }
    sink(std::move(result));
  }

  /// Reports the scenes that have ended since the last look at the log.
  void follow() {
    std::ifstream in(log, std::ios::binary);
    in.seekg(std::streamoff(text.size()));
    text.append(std::istreambuf_iterator<char>(in), {});
    while (!waiting.empty()) {
      const std::size_t scene = waiting.front();
      const std::string end = fmt::format("litmus end {} ", scene);
      const std::size_t at = text.find(end, done);
      const std::size_t newline = at == std::string::npos ? at : text.find('\n', at);
      if (newline == std::string::npos) break;
      const bool ok = text.substr(at + end.size(), newline - at - end.size()) == "ok";
      done = newline;
      waiting.erase(waiting.begin());
      report(scene, ok ? ""
                       : fmt::format("the script of {} failed in Blender (see {})",
                                     scenes[scene].name, log.string()));
    }
  }
};

void prepare(Batch& batch) {
  std::vector<std::size_t> ready;
  for (const std::size_t scene : batch.waiting) {
    try {
      fs::remove_all(batch.options.work / label(scene));
      write_text(batch.options.work / (label(scene) + ".py"), as_blender(batch.scenes[scene]));
      ready.push_back(scene);
    } catch (const std::exception& error) {
      batch.report(scene, error.what());
    }
  }
  batch.waiting = ready;
}

ProcessResult run_batch(Batch& batch, int attempt) {
  std::vector<std::string> arguments = kArguments;
  arguments.insert(arguments.end(), {"-P", "batch.py", "-t",
                                     std::to_string(std::max(batch.options.threads, 1)), "--"});
  for (const std::size_t scene : batch.waiting) arguments.push_back(std::to_string(scene));
  batch.command = fmt::format("blender {}", fmt::join(arguments, " "));
  batch.log = batch.options.work / fmt::format("blender-{}.log", attempt);
  std::error_code ignored;
  fs::remove(batch.log, ignored);
  batch.text.clear();
  batch.done = 0;
  arguments.insert(arguments.begin(), batch.blender.program.string());
  const ProcessResult result = run_process({.arguments = arguments,
                                            .directory = batch.options.work,
                                            .log = batch.log,
                                            .time_limit = batch.options.time_limit,
                                            .while_running = [&] { batch.follow(); }});
  batch.follow();
  return result;
}

void render_blender(const Installation& blender, std::span<const Scene> scenes,
                    const ReferenceOptions& options, const ResultSink& sink) {
  Batch batch{blender, scenes, options, sink, {}, {}, {}, {}, 0};
  for (std::size_t i = 0; i < scenes.size(); ++i) batch.waiting.push_back(i);
  fs::create_directories(options.work);
  write_text(options.work / "batch.py", blender_batch());
  prepare(batch);

  // Every turn ends at least one scene. Whatever a scene meets (a crash, the time limit) counts
  // only if it had a process of its own from the start.
  for (int attempt = 1; !batch.waiting.empty(); ++attempt) {
    const std::size_t before = batch.waiting.size();
    const ProcessResult result = run_batch(batch, attempt);
    if (batch.waiting.size() < before) continue;
    const std::string reason = result.ok() ? "Blender ended early" : result.explanation;
    const std::string begun = fmt::format("litmus begin {}\n", batch.waiting.front());
    const bool at_work = batch.text.find(begun) != std::string::npos;
    do {
      const std::size_t scene = batch.waiting.front();
      batch.waiting.erase(batch.waiting.begin());
      batch.report(scene, reason);
      // A process that began nothing would begin nothing again.
    } while (!at_work && !batch.waiting.empty());
  }
}

}  // namespace

std::string blender_batch() {
  return R"(# Runs the scripts of many scenes in one Blender. Behind "--": their numbers.
import os, sys, traceback

here = os.path.dirname(os.path.abspath(__file__))
for scene in sys.argv[sys.argv.index("--") + 1:]:
    label = scene.zfill(4)
    print("litmus begin " + scene, flush=True)
    sys.argv[sys.argv.index("--") + 1:] = [os.path.join(here, label), "--no-blend"]
    script = os.path.join(here, label + ".py")
    try:
        with open(script, encoding="utf-8") as text:
            exec(compile(text.read(), script, "exec"), {"__name__": "__main__"})
        state = "ok"
    except BaseException:
        traceback.print_exc()
        state = "failed"
    sys.stdout.flush()
    sys.stderr.flush()
    print("litmus end " + scene + " " + state, flush=True)
)";
}

double cycles_render_seconds(const std::string& log) {
  constexpr std::string_view kTotal = "Total render time: ";
  double total = 0;
  for (std::size_t at = log.find(kTotal); at != std::string::npos; at = log.find(kTotal, at + 1)) {
    double seconds = 0;
    const char* start = log.data() + at + kTotal.size();
    if (std::from_chars(start, log.data() + log.size(), seconds).ec == std::errc())
      total += seconds;
  }
  return total;
}

double blender_render_seconds(const std::string& log, std::size_t scene) {
  const std::size_t begin = log.find(fmt::format("litmus begin {}\n", scene));
  if (begin == std::string::npos) return 0;
  const std::size_t end = log.find(fmt::format("litmus end {} ", scene), begin);
  return cycles_render_seconds(log.substr(begin, end == std::string::npos ? end : end - begin));
}

Driver blender_driver() {
  return {.name = "blender",
          .title = "Blender Cycles",
          .package = "blender",
          .revision = 1,
          .find = find_blender,
          .source = blender_source,
          .render = render_blender};
}

}  // namespace litmus

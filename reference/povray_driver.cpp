// povray_driver.cpp: two passes of POV-Ray per scene, several scenes at a time.
#include "reference/povray_driver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <functional>
#include <future>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "exporters/povray.h"
#include "reference/frames.h"
#include "reference/process.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

constexpr double kBoost = 65536;  // one step of 16 bits becomes 1: well inside a half float
constexpr double kOpacity =
    0.5;  // of the screen: half of what it takes off, half of what is behind
constexpr double kScreen = 0.01;  // its distance; POV-Ray sees nothing nearer than 1e-4
// A process sleeps most of its time. Beside Blender, POV-Ray ends last with 4 of them, with 8
// first.
constexpr int kProcessesPerThread = 6;
constexpr std::size_t kFramesOfAProcess = 16;  // a frame sleeps 0.2 s
constexpr double kRaysOfAFrame = 1e5;          // that could be traced while it sleeps
// What it says where a busy machine has not started its threads within the time that it allows
// (vfeInitializeTimedOut of vfe/vfesession.h, 3.7): nothing has been read then, let alone traced,
// so that it is started once more.
constexpr std::string_view kNotStarted = "Timed out waiting for worker thread startup";
constexpr int kMostStarts = 5;

std::size_t frames(const Scene& scene) { return scene.lights.size() + 1; }

// POV-Ray's frame numbers have as many digits as the last one.
int digits(const Scene& scene) { return int(fmt::formatted_size("{}", frames(scene))); }

fs::path frame_file(const Scene& scene, const std::string& stem, std::size_t layer,
                    const char* extension) {
  if (scene.lights.empty()) return stem + extension;
  return fmt::format("{}{:0{}}{}", stem, layer + 1, digits(scene), extension);
}

std::string as_povray(const Scene& scene) {
  std::ostringstream out;
  write_povray(scene, out);
  return out.str();
}

std::vector<std::string> first_pass(const Scene& scene) { return povray_arguments(scene, "scene"); }

std::vector<std::string> second_pass(const Scene& scene) {
  std::vector<std::string> arguments = povray_arguments(scene, "residual");
  std::replace(arguments.begin(), arguments.end(), std::string("+Oresidual.png"),
               std::string("+Oresidual.exr"));
  std::replace(arguments.begin(), arguments.end(), std::string("+FN16"), std::string("+FE"));
  return arguments;
}

std::string povray_source(const Scene& scene) {
  return fmt::format("{}\n{}\n{}\n{}\n", as_povray(without_words(scene)), povray_residual(scene),
                     fmt::join(first_pass(scene), " "), fmt::join(second_pass(scene), " "));
}

// As in "POV-Ray 3.7.0.10.unofficial".
std::optional<Installation> find_povray() { return find_installation("povray", "POV-Ray "); }

bool never_started(const ProcessResult& result, const fs::path& log) {
  return result.outcome == Outcome::Exited && result.code != 0 &&
         read_text(log).find(kNotStarted) != std::string::npos;
}

// One run of POV-Ray in the scene's folder.
ProcessResult run_part(const Installation& povray, const fs::path& log,
                       std::vector<std::string> arguments, const ReferenceOptions& options) {
  arguments.insert(arguments.begin(), povray.program.string());
  const Command command{.arguments = arguments,
                        .directory = log.parent_path(),
                        .log = log,
                        .time_limit = options.time_limit};
  ProcessResult result = run_process(command);
  for (int starts = 1; starts < kMostStarts && never_started(result, log); ++starts)
    result = run_process(command);
  return result;
}

// All frames of a pass, many of them in several processes; the log is that of all. Returns the
// command that renders them in one. Throws std::runtime_error if one failed.
std::string run_pass(const Installation& povray, const fs::path& log, std::size_t frames,
                     std::vector<std::string> arguments, int threads,
                     const ReferenceOptions& options) {
  arguments.push_back(fmt::format("+WT{}", threads));
  const std::string whole = fmt::format("povray {}", fmt::join(arguments, " "));
  std::vector<std::future<ProcessResult>> parts;
  std::vector<fs::path> logs;
  for (std::size_t first = 1; first <= frames; first += kFramesOfAProcess) {
    std::vector<std::string> some = arguments;
    if (frames > kFramesOfAProcess) {
      some.push_back(fmt::format("+SF{}", first));
      some.push_back(fmt::format("+EF{}", std::min(first + kFramesOfAProcess - 1, frames)));
    }
    logs.push_back(fmt::format("{}.{}", log.string(), first));
    parts.push_back(std::async(std::launch::async, run_part, std::cref(povray), logs.back(),
                               std::move(some), std::cref(options)));
  }
  std::string failure, passed, failed;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ProcessResult result = parts[i].get();
    if (!result.ok()) failure = result.explanation;
    (result.ok() ? passed : failed) += read_text(logs[i]);
  }
  write_text(log, passed + failed);  // the end of a log says why
  if (!failure.empty()) throw std::runtime_error(fmt::format("{} ({})", failure, whole));
  return whole;
}

Layer read_layer(const Scene& scene, const fs::path& folder, std::size_t layer) {
  Picture picture = read_frame(scene, folder / frame_file(scene, "scene", layer, ".png"));
  const Picture residual = read_frame(scene, folder / frame_file(scene, "residual", layer, ".exr"));
  const double gain = povray_gain(scene, layer);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = (picture.pixels[i] + residual.pixels[i] / ((1 - kOpacity) * kBoost)) / gain;
  const Light* light = layer == 0 ? nullptr : &scene.lights[layer - 1];
  return {light ? light->name : "ambient", std::string(light ? light_type(*light) : "ambient"),
          averaged(picture, scene.samples)};
}

ReferenceResult render_one(const Installation& povray, const Scene& scene, const fs::path& folder,
                           int threads, const ReferenceOptions& options) {
  ReferenceResult result;
  result.scene = scene.name;
  try {
    fs::remove_all(folder);
    fs::create_directories(folder);
    write_text(folder / "scene.pov", as_povray(scene));
    write_text(folder / "residual.pov", povray_residual(scene));
    for (const char* stem : {"scene", "residual"}) {
      result.log = folder / fmt::format("{}.log", stem);
      const bool first = result.command.empty();
      const std::string command =
          run_pass(povray, result.log, frames(scene),
                   first ? first_pass(scene) : second_pass(scene), threads, options);
      result.command += (first ? "" : "; ") + command;
      result.seconds += povray_trace_seconds(read_text(result.log));
    }
    for (std::size_t layer = 0; layer < frames(scene); ++layer)
      result.layers.push_back(read_layer(scene, folder, layer));
  } catch (const std::exception& error) {
    result.layers.clear();
    result.failure = error.what();
  }
  return result;
}

// Rays to trace, roughly: the longest scene should not start last.
double work(const Scene& scene) {
  double lamps = 1;
  for (const Light& light : scene.lights) {
    const AreaLight* area = std::get_if<AreaLight>(&light.shape);
    lamps += area ? double(area->columns) * area->rows : 1;
  }
  double triangles = 0;
  for (const Object& object : scene.objects)
    if (const Mesh* mesh = std::get_if<Mesh>(&object.shape))
      triangles += double(mesh->triangles.size());
  const double rays = double(scene.width) * scene.height * scene.samples * scene.samples * lamps;
  return rays + (triangles + kRaysOfAFrame) * double(frames(scene));
}

void render_povray(const Installation& povray, std::span<const Scene> scenes,
                   const ReferenceOptions& options, const ResultSink& sink) {
  if (scenes.empty()) return;
  std::vector<std::size_t> order(scenes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work(scenes[a]) > work(scenes[b]); });
  const int count = int(scenes.size());
  const int threads = options.threads > 0 ? options.threads
                                          : int(std::max(std::thread::hardware_concurrency(), 1u));
  const int workers = std::min(count, threads * kProcessesPerThread);
  const int threads_each = std::max(threads / count, 1);

  std::atomic<std::size_t> next = 0;
  std::mutex reporting;
  std::exception_ptr broken;  // thrown by the sink
  const auto worker = [&] {
    for (std::size_t i = next++; i < order.size(); i = next++) {
      const Scene& scene = scenes[order[i]];
      const fs::path folder = options.work / fmt::format("{:04}", order[i]);
      ReferenceResult result = render_one(povray, scene, folder, threads_each, options);
      const std::lock_guard lock(reporting);
      try {
        if (options.progress)
          options.progress(fmt::format("POV-Ray: {}{}", scene.name,
                                       result.failure.empty() ? "" : ": " + result.failure));
        sink(std::move(result));
      } catch (...) {
        broken = std::current_exception();
        next = order.size();
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    for (int i = 0; i < workers; ++i) pool.emplace_back(worker);
  }
  if (broken) std::rethrow_exception(broken);
}

}  // namespace

std::string povray_residual(const Scene& scene) {
  const bool flat = scene.camera.projection == Projection::Orthographic;
  const std::string picture =
      scene.lights.empty()
          ? "\"scene.png\""
          : fmt::format("concat(\"scene\", str(frame_number, -{}, 0), \".png\")", digits(scene));
  return fmt::format(
      R"(// What 16 bits lost of scene.pov, {0} times as strong: a screen just before the camera takes the
// picture that has been rendered off the light that comes through it.
#version 3.7;
#declare Boost = {0};
#include "scene.pov"
#declare Near = {1};
#declare Size = {2};
#declare Corner = Eye + Near*Forward - Size/2*(PictureRight + PictureUp);
plane {{
  z, 0  // endless, because a polygon's bounding box has single precision
  pigment {{ image_map {{ png {3} gamma 1.0 once transmit all {4} }} }}
  finish {{ emission -Boost }}
  interior {{ ior 1 }}
  no_shadow
  matrix <Size*PictureRight.x, Size*PictureRight.y, Size*PictureRight.z,
          Size*PictureUp.x, Size*PictureUp.y, Size*PictureUp.z,
          Forward.x, Forward.y, Forward.z, Corner.x, Corner.y, Corner.z>
}}
)",
      kBoost, kScreen, flat ? "1" : "Near", picture, kOpacity);
}

double povray_trace_seconds(const std::string& log) {
  double total = 0;
  for (std::size_t at = log.find("Trace Time:"); at != std::string::npos;
       at = log.find("Trace Time:", at + 1)) {
    constexpr std::string_view kWith = "thread(s) with ";
    const std::size_t with = log.find(kWith, at);
    if (with == std::string::npos) break;
    double seconds = 0;
    const char* start = log.data() + with + kWith.size();
    if (std::from_chars(start, log.data() + log.size(), seconds).ec == std::errc())
      total += seconds;
  }
  return total;
}

Driver povray_driver() {
  return {.name = "povray",
          .title = "POV-Ray",
          .package = "povray",
          .revision = 1,
          .find = find_povray,
          .source = povray_source,
          .render = render_povray};
}

}  // namespace litmus

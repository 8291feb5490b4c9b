// candidate.cpp: runs a candidate's command for each layer of each scene, or looks its images up.
#include "reference/candidate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "compare/image_io.h"
#include "compare/whole_file.h"
#include "exporters/json.h"
#include "reference/frames.h"
#include "reference/hash.h"
#include "reference/process.h"
#include "reference/scene_pool.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

std::string as_json(const Scene& scene) {
  std::ostringstream out;
  write_scene_json(scene, out);
  return out.str();
}

/// The layers' names: "ambient", then each light's.
std::vector<std::string> layer_names(const Scene& scene) {
  std::vector<std::string> names{"ambient"};
  for (const Light& light : scene.lights) names.push_back(light.name);
  return names;
}

Layer layer_of(const Scene& scene, std::size_t index, Picture picture) {
  if (index == 0) return {"ambient", "ambient", std::move(picture)};
  const Light& light = scene.lights[index - 1];
  return {light.name, std::string(light_type(light)), std::move(picture)};
}

// ---- The command -----------------------------------------------------------------------------

/// The arguments with files beside litmus.toml by their full path. The program is one of those only
/// if it has a slash; else it is looked up on PATH.
std::vector<std::string> resolved(const Candidate& candidate) {
  std::vector<std::string> arguments = candidate.command;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const fs::path file = fs::absolute(candidate.folder / arguments[i]).lexically_normal();
    const bool by_path = i > 0 || arguments[i].find('/') != std::string::npos;
    std::error_code error;
    if (by_path && fs::is_regular_file(file, error)) arguments[i] = file.string();
  }
  return arguments;
}

struct Word {
  std::string_view name;  ///< with its braces
  std::string value;
};

/// Replaces the words in one go, so that a light named "{output}" is only a name.
std::string filled(const std::string& text, const std::vector<Word>& words) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto word = std::find_if(words.begin(), words.end(), [&](const Word& each) {
      return text.compare(at, each.name.size(), each.name) == 0;
    });
    if (word == words.end()) {
      result += text[at++];
    } else {
      result += word->value;
      at += word->name.size();
    }
  }
  return result;
}

/// A checksum over every file that the command names, the program first.
std::string version_of(const std::vector<std::string>& arguments) {
  std::string parts;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const fs::path file = i == 0 ? find_program(arguments[i]) : fs::path(arguments[i]);
    std::error_code error;
    if (!file.is_absolute() || !fs::is_regular_file(file, error)) continue;
    try {
      parts += hash_file(file) + "\n";
    } catch (const Refusal&) {
      parts += "unreadable\n";
    }
  }
  return "files " + hash_text(parts).substr(0, 12);
}

/// What decides the images: the words of the command, the encoding and the scene without its name.
std::string source(const Candidate& candidate, const Scene& scene) {
  return fmt::format("{}\n{}\n{}\n{}", fmt::join(candidate.command, "\n"),
                     name_of(candidate.encoding), candidate.encoding.exposure,
                     as_json(without_words(scene)));
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n");
  if (end == std::string::npos) return "";
  const std::size_t start = text.find_last_of('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? std::size_t(-1) : start));
}

/// Runs one layer after the other and gathers the images; stops at the first failure.
ReferenceResult render_one(const Candidate& candidate, const Scene& scene, const fs::path& folder,
                           const ReferenceOptions& options) {
  ReferenceResult result;
  result.scene = scene.name;
  result.command = fmt::format("{}", fmt::join(candidate.command, " "));
  try {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const fs::path json = fs::absolute(folder / "scene.json");
    write_whole(json, as_json(scene));
    const std::vector<std::string> names = layer_names(scene);
    for (std::size_t layer = 0; layer < names.size(); ++layer) {
      const fs::path output = fs::absolute(folder / fmt::format("layer-{}", layer));
      const std::vector<Word> words{{"{scene}", json.string()},
                                    {"{light}", names[layer]},
                                    {"{output}", output.string()},
                                    {"{width}", std::to_string(scene.width)},
                                    {"{height}", std::to_string(scene.height)}};
      Command command;
      for (const std::string& argument : resolved(candidate))
        command.arguments.push_back(filled(argument, words));
      command.directory = folder;
      command.log = result.log = folder / fmt::format("layer-{}.log", layer);
      command.time_limit = candidate.time_limit.value_or(options.time_limit);
      const ProcessResult process = run_process(command);
      result.seconds += process.seconds;
      if (process.outcome == Outcome::Exited && process.code == kDeclined) {
        const std::string reason = last_line(tail(result.log));
        result.skipped = fmt::format("{} declined the scene{}", candidate.name,
                                     reason.empty() ? "" : ": " + reason);
        result.layers.clear();
        return result;
      }
      if (!process.ok())
        throw Refusal(fmt::format("light \"{}\": {}", names[layer], process.explanation));
      result.layers.push_back(
          layer_of(scene, layer, read_candidate_image(output, scene, candidate.encoding)));
    }
  } catch (const std::exception& wrong) {
    result.layers.clear();
    result.failure = wrong.what();
  }
  return result;
}

// ---- A folder of images ----------------------------------------------------------------------

ObtainedReference from_folder(const Scene& scene, const Candidate& candidate) {
  ObtainedReference result;
  result.scene = scene.name;
  result.reference = candidate.name;
  result.command = "images in " + candidate.images.string();
  const fs::path folder = candidate.images / scene.name;
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    result.skipped = fmt::format("{} has no images of it: there is no folder {}", candidate.name,
                                 folder.string());
    return result;
  }
  try {
    const std::vector<std::string> names = layer_names(scene);
    for (std::size_t layer = 0; layer < names.size(); ++layer) {
      if (names[layer].find('/') != std::string::npos)
        throw Refusal(fmt::format("light \"{}\" cannot be the name of a file", names[layer]));
      result.layers.push_back(layer_of(
          scene, layer, read_candidate_image(folder / names[layer], scene, candidate.encoding)));
    }
    result.source = "stored";
  } catch (const std::exception& wrong) {
    result.layers.clear();
    result.failure = wrong.what();
  }
  return result;
}

}  // namespace

Picture read_candidate_image(const fs::path& stem, const Scene& scene, const Encoding& encoding) {
  const std::vector<std::string> endings = encoding.bits == 0
                                               ? std::vector<std::string>{".exr", ".pfm"}
                                               : std::vector<std::string>{".png"};
  std::vector<fs::path> files;
  for (const std::string& ending : endings) {
    fs::path file = stem;
    file += ending;
    std::error_code error;
    if (fs::is_regular_file(file, error)) files.push_back(file);
  }
  if (files.size() != 1)
    throw Refusal(
        fmt::format("there is {} {}{} (encoding \"{}\"); in a command write it with its ending, as "
                    "in {{output}}{}",
                    files.empty() ? "no" : "more than one", stem.filename().string(),
                    fmt::join(endings, " or "), name_of(encoding), endings.back()));
  const fs::path& file = files.front();
  const Picture read = read_picture(file);
  const auto refuse = [&](const std::string& what) {
    throw Refusal(fmt::format("{} {}", file.filename().string(), what));
  };
  if (read.width != scene.width || read.height != scene.height)
    refuse(fmt::format("has {} x {} pixels instead of {} x {}", read.width, read.height,
                       scene.width, scene.height));
  for (int y = 0; y < read.height; ++y)
    for (int x = 0; x < read.width; ++x)
      for (int c = 0; c < 3; ++c)
        if (!std::isfinite(read.at(x, y)[c]))
          refuse(fmt::format("has a pixel at {}, {} that is not a finite number", x, y));
  if (const auto fine = finer_than(read, encoding))
    refuse(fmt::format("has more than {} bits (at {}, {}), and the encoding is said to be \"{}\"",
                       encoding.bits, (*fine)[0], (*fine)[1], name_of(encoding)));
  return to_light(read, encoding);
}

Driver candidate_driver(const Candidate& candidate) {
  return {.name = candidate.name,
          .title = candidate.name,
          .package = "",
          .revision = 1,
          .find =
              [candidate] {
                const std::vector<std::string> arguments = resolved(candidate);
                return std::optional(Installation{arguments.front(), version_of(arguments)});
              },
          .source = [candidate](const Scene& scene) { return source(candidate, scene); },
          .render =
              [candidate](const Installation&, std::span<const Scene> scenes,
                          const ReferenceOptions& options, const ResultSink& sink) {
                render_in_pool(
                    scenes, options, candidate.name,
                    [&](const Scene& scene, const fs::path& folder) {
                      return render_one(candidate, scene, folder, options);
                    },
                    sink);
              }};
}

std::vector<ObtainedReference> obtain_candidate(std::span<const Scene> scenes,
                                                const Candidate& candidate,
                                                const ObtainOptions& options) {
  if (candidate.images.empty()) {
    ObtainOptions live = options;
    live.sources = Sources::Live;
    return obtain(scenes, candidate_driver(candidate), live);
  }
  std::vector<ObtainedReference> results;
  for (const Scene& scene : scenes) results.push_back(from_folder(scene, candidate));
  return results;
}

}  // namespace litmus

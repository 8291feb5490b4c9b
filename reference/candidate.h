// candidate.h: somebody's own renderer, or a folder of its images, as one more source of layers.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/encoding.h"
#include "reference/obtain.h"

namespace litmus {

/// A [[candidate]] of litmus.toml (candidates_file.h). It has a command or a folder of images.
struct Candidate {
  std::string name;
  /// The program and its arguments, never a shell. These words in braces are replaced in each of
  /// them: {scene} by the path of the scene as JSON (exporters/scene.schema.json), {light} by
  /// "ambient" or the light's name, {output} by the path of the image without its extension,
  /// {width} and {height} by the pixels of the image.
  std::vector<std::string> command;
  /// Or: images that are there already, images/SCENE/LIGHT.exr, .pfm or .png.
  std::filesystem::path images;
  Encoding encoding;
  std::optional<std::chrono::seconds> time_limit;  ///< for one process; absent: that of the run
  bool expected_to_differ = false;                 ///< measured, never judged: `expect = "differs"`
  /// The folder of litmus.toml. An argument that is the name of a file there is passed as its full
  /// path, because the command runs in a scratch folder.
  std::filesystem::path folder;
};

/// By this exit code a command says that it does not do this scene (as test programs do for
/// automake); the last line of its output is the reason.
inline constexpr int kDeclined = 77;

/// The candidate as a driver. It runs the command once per scene and layer, several at a time, each
/// under the limits of process.h; a scene fails with its first layer whose command fails or whose
/// image is missing, unreadable, of another size or depth, or not finite. `seconds` is the wall
/// clock of all its processes, starts included. The version is a checksum over the program and all
/// arguments that are files, so that a changed script is run again.
Driver candidate_driver(const Candidate& candidate);

/// One result per scene, as obtain() gives them: `source` is "live" for a command (whose images the
/// store keeps) and "stored" for a folder. A scene without a folder of its own is skipped.
std::vector<ObtainedReference> obtain_candidate(std::span<const Scene> scenes,
                                                const Candidate& candidate,
                                                const ObtainOptions& options);

/// Reads one image of a candidate as linear light: `stem` with .exr or .pfm (floats) or .png.
/// Throws Refusal if there is none or more than one, it does not fit the scene or the encoding, or
/// a pixel is not a number.
Picture read_candidate_image(const std::filesystem::path& stem, const Scene& scene,
                             const Encoding& encoding);

}  // namespace litmus

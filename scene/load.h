// load.h: reads a scene file (TOML, schema 1) and refuses whatever the model does not allow.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace litmus {

/// Reads and validates one scene file, with the meshes it names (paths relative to the file).
/// Throws Refusal "file:line:column: field: what is wrong and what is allowed".
Scene load_scene(const std::filesystem::path& file);

/// The canonical scenes' files, in order of name.
std::vector<std::filesystem::path> canonical_scenes();

/// The canonical scenes that can be loaded here, in order of name.
struct CanonicalScenes {
  std::vector<Scene> scenes;
  std::vector<std::string> left_out;  ///< of each that needs data of a package: why, and the remedy
};

/// Loads them all but those that need data which is not installed (MissingData of observer.h).
/// Throws Refusal for any other fault.
CanonicalScenes load_canonical_scenes();

/// A path as given, or the canonical scene of that name ("d1-sun-floor") or id ("d1"; any case).
/// Throws Refusal that lists near names if there is none.
std::filesystem::path find_scene(const std::string& name_or_path);

/// The folder that holds canonical/, reference images and report assets: $LITMUS_DATA, else the
/// installed share/litmus beside the program, else the source tree it was built from.
std::filesystem::path data_directory();

/// 32 hexadecimal digits (XXH3-128) over everything that decides the picture; the name, about, tags
/// and comments do not count.
std::string fingerprint(const Scene& scene);

}  // namespace litmus

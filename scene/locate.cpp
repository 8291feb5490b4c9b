// locate.cpp: where the canonical scenes and the other data files are.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "scene/load.h"
#include "scene/observer.h"
#include "scene/refusal.h"
#include "scene/words.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// canonical/ in an installed folder, scene/canonical/ in the source tree; empty if neither is
/// there.
fs::path canonical_folder(const fs::path& data) {
  std::error_code ignored;
  for (const fs::path& folder : {data / "canonical", data / "scene" / "canonical"})
    if (fs::is_directory(folder, ignored)) return folder;
  return {};
}

/// "d1" of "d1-sun-floor"
std::string id_of(const std::string& name) { return name.substr(0, name.find('-')); }

std::vector<std::string> near_names(const std::string& wanted,
                                    const std::vector<std::string>& names) {
  std::vector<std::string> near = near_words(wanted, names);
  for (const std::string& name : names) {
    const bool by_id = edit_distance(wanted, id_of(name)) <= 1;
    const bool by_part = wanted.size() >= 3 && name.find(wanted) != std::string::npos;
    if ((by_id || by_part) && std::find(near.begin(), near.end(), name) == near.end())
      near.push_back(name);
  }
  if (near.size() > 8) near.resize(8);
  return near;
}

}  // namespace

fs::path data_directory() {
  if (const char* chosen = std::getenv("LITMUS_DATA"); chosen && *chosen) return chosen;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed =
        (program.parent_path() / ".." / "share" / "litmus").lexically_normal();
    if (fs::is_directory(installed / "canonical", error)) return installed;
  }
  return LITMUS_SOURCE_DATA;
}

std::vector<fs::path> canonical_scenes() {
  const fs::path data = data_directory(), folder = canonical_folder(data);
  if (folder.empty())
    throw Refusal(
        fmt::format("{}: holds no canonical scenes; set LITMUS_DATA to the folder that does "
                    "(share/litmus, or the source tree)",
                    data.string()));
  std::vector<fs::path> scenes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

CanonicalScenes load_canonical_scenes() {
  CanonicalScenes all;
  for (const fs::path& file : canonical_scenes()) {
    try {
      all.scenes.push_back(load_scene(file));
    } catch (const MissingData& missing) {
      all.left_out.push_back(missing.what());
    }
  }
  return all;
}

fs::path find_scene(const std::string& name_or_path) {
  std::error_code ignored;
  if (fs::is_regular_file(name_or_path, ignored)) return name_or_path;
  if (name_or_path.find('/') != std::string::npos || fs::path(name_or_path).extension() == ".toml")
    throw Refusal(fmt::format("{}: no such scene file; `litmus list` names the canonical scenes",
                              name_or_path));
  const std::string wanted = lower_case(name_or_path);
  std::vector<std::string> names;
  for (const fs::path& file : canonical_scenes()) {
    names.push_back(lower_case(file.stem().string()));
    if (wanted == names.back() || wanted == id_of(names.back())) return file;
  }
  const std::vector<std::string> near = near_names(wanted, names);
  throw Refusal(
      fmt::format("{}: no canonical scene has this name or id, and no file is there{} `litmus "
                  "list` names them all",
                  name_or_path, near.empty() ? ";" : "; did you mean " + listed(near, "or") + "?"));
}

}  // namespace litmus

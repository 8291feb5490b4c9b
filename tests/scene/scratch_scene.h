// scratch_scene.h: small scenes for the loader's tests, written to a folder of the test's own.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "scene/load.h"
#include "scene/refusal.h"

namespace litmus {

/// A folder that is gone with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "litmus-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no scratch folder");
    path_ = pattern;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Every table and nearly every key of the format.
inline const std::string kScratchScene = R"(schema = 1
about = "A scene to spoil."
tags = ["test"]
ambient = 0.1
shadows = true
shading = "equation"
[image]
width = 8
height = 6
samples = 1
[camera]
projection = "perspective"
eye = [4, -6, 3]
target = [0, 0, 0.5]
up = [0, 0, 1]
fov_degrees = 40
[[material]]
name = "matte"
diffuse = 0.8
shininess = 10
[[object]]
name = "floor"
shape = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
material = "matte"
[[object]]
name = "ball"
shape = "sphere"
center = [0, 0, 1]
radius = 0.5
material = "matte"
camera_visible = false
[[object]]
name = "block"
shape = "box"
min = [1, 1, 0]
max = [2, 2, 1]
material = "matte"
[[object]]
name = "sail"
shape = "triangle"
a = [0, 0, 3]
b = [1, 0, 3]
c = [0, 1, 3]
material = "matte"
[[object]]
name = "gem"
shape = "mesh"
generator = "icosphere"
center = [3, 0, 1]
radius = 0.25
level = 1
smooth = false
material = "matte"
[[light]]
name = "sun"
type = "directional"
direction = [-1, 0.5, -2]
intensity = 0.75
color = [1, 0.9, 0.8]
[[light]]
name = "lamp"
type = "point"
origin = [1, 2, 3]
range = 4
linear = 0.5
quadratic = 0.25
[[light]]
name = "spot"
type = "spot"
origin = [-1, 2, 3]
direction = [0, 0, -1]
cutoff_degrees = 25
exponent = 3
[[light]]
name = "panel"
type = "area"
origin = [0, -2, 4]
normal = [0, 0, -1]
right = [1, 0, 0]
width = 1
height = 0.5
columns = 3
rows = 2
placement = "centres"
)";

/// The text with its only occurrence of `find` replaced.
inline std::string replaced(std::string text, const std::string& find, const std::string& with) {
  const std::size_t at = text.find(find);
  if (at == std::string::npos || text.find(find, at + 1) != std::string::npos)
    throw std::logic_error("not exactly once in the text: " + find);
  return text.replace(at, find.size(), with);
}

/// "line:column" of the first '@' in the text, which is taken out.
inline std::string take_mark(std::string& text) {
  const std::size_t at = text.find('@');
  if (at == std::string::npos) throw std::logic_error("no @ in the text");
  text.erase(at, 1);
  std::size_t line = 1, start = 0;
  for (std::size_t i = 0; i < at; ++i)
    if (text[i] == '\n') ++line, start = i + 1;
  return std::to_string(line) + ':' + std::to_string(at - start + 1);
}

/// What the loader says, or nothing if it takes the scene.
inline std::string refusal_of(const std::filesystem::path& file) {
  try {
    load_scene(file);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return {};
}

}  // namespace litmus

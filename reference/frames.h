// frames.h: what the drivers share: asking a renderer for its version, reading its frames.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "reference/drivers.h"

namespace litmus {

/// A whole file, empty if it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// Throws std::runtime_error naming the file if it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

/// The renderer on PATH whose --version prints `title` and then digits and dots; nothing if there
/// is none or if it does not start. A program is asked once in a process, and again when its file
/// was written since.
std::optional<Installation> find_installation(const std::string& program, std::string_view title);

/// The scene without the words that are for people only: they do not change the picture.
Scene without_words(Scene scene);

/// A frame of scene.samples times the scene's size. Throws std::runtime_error naming the file if it
/// is missing, damaged, of another size, or has a pixel that is not finite.
Picture read_frame(const Scene& scene, const std::filesystem::path& file);

/// The mean of samples x samples pixels as one pixel.
Picture averaged(const Picture& fine, int samples);

}  // namespace litmus

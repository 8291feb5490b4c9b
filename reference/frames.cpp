// frames.cpp: versions and frames of renderers.
#include "reference/frames.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <stdexcept>

#include "compare/image_io.h"
#include "reference/process.h"

namespace litmus {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

namespace {

std::optional<Installation> ask(const fs::path& program, const std::string& name,
                                std::string_view title) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("litmus-{}-{}", name, ::getpid());
  const fs::path log = folder / "version.log";
  const ProcessResult result =
      run_process({.arguments = {program.string(), "--version"}, .directory = folder, .log = log});
  const std::string text = read_text(log);
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  const std::size_t at = text.find(title);
  if (!result.ok() || at == std::string::npos) return std::nullopt;
  const std::size_t start = at + title.size();
  std::string version = text.substr(start, text.find_first_not_of("0123456789.", start) - start);
  while (!version.empty() && version.back() == '.') version.pop_back();
  return Installation{program, version};
}

/// What a program said when it was last asked, and when its file had been written.
struct Answer {
  std::mutex asking;
  fs::file_time_type written{};
  std::optional<Installation> installation{};
};

Answer& answer_of(const fs::path& program) {
  static std::mutex lock;
  static std::map<fs::path, Answer> answers;
  const std::lock_guard guard(lock);
  return answers[program];
}

}  // namespace

std::optional<Installation> find_installation(const std::string& name, std::string_view title) {
  const fs::path program = find_program(name);
  if (program.empty()) return std::nullopt;
  Answer& answer = answer_of(program);
  const std::lock_guard guard(answer.asking);
  std::error_code error;
  const fs::file_time_type written = fs::last_write_time(program, error);
  if (!error && answer.installation && answer.written == written) return answer.installation;
  answer.installation = ask(program, name, title);
  answer.written = written;
  return answer.installation;
}

Scene without_words(Scene scene) {
  scene.name = "scene";
  scene.file.clear();
  scene.about.clear();
  return scene;
}

Picture read_frame(const Scene& scene, const fs::path& file) {
  Picture picture = read_picture(file);
  const int width = scene.width * scene.samples, height = scene.height * scene.samples;
  if (picture.width != width || picture.height != height)
    throw std::runtime_error(fmt::format("{} has {} x {} pixels instead of {} x {}",
                                         file.filename().string(), picture.width, picture.height,
                                         width, height));
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const glm::dvec3& p = picture.pixels[i];
    if (!std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b))
      throw std::runtime_error(fmt::format("{} has a pixel at {}, {} that is not a number",
                                           file.filename().string(), i % std::size_t(width),
                                           i / std::size_t(width)));
  }
  return picture;
}

Picture averaged(const Picture& fine, int samples) {
  if (samples == 1) return fine;
  Picture picture(fine.width / samples, fine.height / samples);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x)
      picture.at(x / samples, y / samples) += fine.at(x, y) / double(samples * samples);
  return picture;
}

}  // namespace litmus

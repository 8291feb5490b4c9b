// whole_file.cpp: a temporary name, fsync, rename.
#include "compare/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "scene/refusal.h"

namespace litmus {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse_writing(const fs::path& file, const std::string& what) {
  throw Refusal(
      fmt::format("{}: cannot be written: {}; check the folder, its permissions and the "
                  "free space",
                  file.string(), what));
}

// Unique among processes and threads; hidden, so that a crash leaves nothing that looks finished.
fs::path temporary_name(const fs::path& file) {
  static std::atomic<unsigned> counter{0};
  return file.parent_path() / fmt::format(".{}.{}-{}.tmp{}", file.stem().string(), ::getpid(),
                                          counter++, file.extension().string());
}

void flush_to_disk(const fs::path& temporary, const fs::path& file) {
  const int descriptor = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) refuse_writing(file, std::strerror(errno));
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  if (result != 0) refuse_writing(file, std::strerror(error));
}

}  // namespace

void write_whole(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  const fs::path temporary = temporary_name(file);
  try {
    write(temporary);
    flush_to_disk(temporary, file);
    std::error_code error;
    fs::rename(temporary, file, error);
    if (error) refuse_writing(file, error.message());
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

void write_whole(const fs::path& file, std::string_view text) {
  write_whole(file, [&](const fs::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream) refuse_writing(file, std::strerror(errno));
  });
}

}  // namespace litmus

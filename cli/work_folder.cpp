// work_folder.cpp: makes, locks and removes scratch folders.
#include "cli/work_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <system_error>

#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "litmus-run-";
constexpr const char* kLock = "lock";

/// The locked file's descriptor, or -1 if another process holds it or it cannot be opened.
int try_lock(const fs::path& folder, int flags) {
  const int file = ::open((folder / kLock).c_str(), flags | O_CLOEXEC, 0600);
  if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  if (file >= 0) ::close(file);
  return -1;
}

void sweep() {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), ignored)) {
    if (entry.path().filename().string().rfind(kPrefix, 0) != 0) continue;
    const int lock = try_lock(entry.path(), O_RDWR);
    if (lock < 0) continue;
    fs::remove_all(entry.path(), ignored);
    ::close(lock);
  }
}

}  // namespace

WorkFolder::WorkFolder() {
  sweep();
  std::string name = fs::temp_directory_path() / (std::string(kPrefix) + "XXXXXX");
  if (!::mkdtemp(name.data())) throw Refusal(name + ": cannot make a scratch folder; set TMPDIR");
  path = name;
  lock = try_lock(path, O_RDWR | O_CREAT);
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
  if (lock >= 0) ::close(lock);
}

}  // namespace litmus

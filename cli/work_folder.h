// work_folder.h: a scratch folder that goes away with its owner.
#pragma once

#include <filesystem>

namespace litmus {

/// A new folder below the system's temporary folder, removed at the end of its scope. Folders of
/// processes that were killed are removed when the next one is made: a live one holds a lock.
struct WorkFolder {
  std::filesystem::path path;
  int lock = -1;  ///< descriptor of the locked file in it

  /// Throws Refusal if it cannot be made.
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
};

}  // namespace litmus

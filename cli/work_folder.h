// work_folder.h: a scratch folder that goes away with its owner.
#pragma once

#include <filesystem>

namespace litmus {

struct WorkFolder {
  std::filesystem::path path;
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
};

}  // namespace litmus

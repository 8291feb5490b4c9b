// work_folder.cpp: makes and removes a scratch folder.
#include "cli/work_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "scene/refusal.h"

namespace litmus {

WorkFolder::WorkFolder() {
  std::string name = std::filesystem::temp_directory_path() / "litmus-XXXXXX";
  if (!mkdtemp(name.data())) throw Refusal(name + ": cannot make a scratch folder; set TMPDIR");
  path = name;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

}  // namespace litmus

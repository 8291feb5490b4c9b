// stored_study.h: the study of one canonical scene against the stored images.
#pragma once

#include <string>
#include <vector>

#include "reports/study.h"
#include "scene/load.h"

namespace litmus {

/// `control` is a mistake of reports/controls.h, or "".
inline Study stored_study(const std::string& scene, const std::string& control = "") {
  StudyOptions options;
  options.obtain.sources = Sources::Stored;
  options.control = control;
  const std::vector<Scene> scenes{load_scene(find_scene(scene))};
  return run_study(scenes, options);
}

}  // namespace litmus

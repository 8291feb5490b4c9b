// stored_study.h: studies of canonical scenes against the stored images.
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

/// All canonical scenes, loaded once.
inline const std::vector<Scene>& canonical() {
  static const std::vector<Scene> scenes = load_canonical_scenes().scenes;
  return scenes;
}

/// The study of all of them, made once.
inline const Study& canonical_study() {
  static const Study study = [] {
    StudyOptions options;
    options.obtain.sources = Sources::Stored;
    return run_study(canonical(), options);
  }();
  return study;
}

}  // namespace litmus

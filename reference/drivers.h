// drivers.h: the table of reference renderers. A renderer is a record: how to find it, how to run it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

struct Installation {
  std::filesystem::path program;
  std::string version;  ///< as the renderer prints it: "3.7.0.10", "3.4.1"
};

struct ReferenceOptions {
  std::filesystem::path work;                ///< scratch folder: scripts, images and logs stay here
  std::chrono::seconds time_limit{300};      ///< for one process
  int threads = 2;
  std::function<void(const std::string&)> progress;  ///< may be empty; one short line per step
};

/// One scene rendered by a reference, or the reason why not.
struct ReferenceResult {
  std::string scene;        ///< Scene::name
  Layers layers;            ///< empty on failure
  double seconds = 0;       ///< rendering alone as the renderer reports it, all layers together
  std::string command;      ///< the command line(s) that made it, for provenance
  std::string failure;      ///< empty, or one sentence for people
  std::string skipped;      ///< empty, or why the renderer declined the scene; then no failure
  std::filesystem::path log;
};

/// Called as soon as a scene is finished or has failed, so that results can be kept at once.
using ResultSink = std::function<void(ReferenceResult)>;

struct Driver {
  std::string name;   ///< "povray", "blender": the word in results, options and paths
  std::string title;  ///< "POV-Ray", "Blender Cycles"
  std::string package;  ///< Debian package that installs it
  int revision = 1;   ///< raised when the driver computes something else from the same export
  std::function<std::optional<Installation>()> find;
  /// Text that decides the image (what is exported), for the store's key. Throws Refusal if the scene
  /// cannot be expressed.
  std::function<std::string(const Scene&)> source;
  /// Renders all scenes with as few processes as possible; calls the sink once per scene.
  std::function<void(const Installation&, std::span<const Scene>, const ReferenceOptions&,
                     const ResultSink&)>
      render;
};

/// POV-Ray, then Blender.
std::span<const Driver> drivers();

/// nullptr if there is no such driver.
const Driver* find_driver(std::string_view name);

}  // namespace litmus

// exporters.h: the table of exporters. Each writes a scene in the language of one renderer.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace litmus {

struct Exporter {
  std::string name;       ///< "povray", "blender", "json"
  std::string extension;  ///< ".pov", ".py", ".json"
  /// The exact mapping: every light type of the model to the renderer's own precision.
  void (*write)(const Scene&, std::ostream&);
  /// What a user of that renderer would write, at best fit; a header comment says what it cannot express.
  /// Throws Refusal where there is no such form (json).
  void (*write_native)(const Scene&, std::ostream&);
  /// Sentences about what the export cannot express exactly; empty where it is exact.
  std::vector<std::string> (*caveats)(const Scene&);
};

/// POV-Ray, Blender, then JSON for any other renderer.
std::span<const Exporter> exporters();

/// nullptr if there is no such exporter.
const Exporter* find_exporter(std::string_view name);

}  // namespace litmus

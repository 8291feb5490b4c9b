// exporters.cpp: the table of exporters. A further renderer is one row here.
#include "exporters/exporters.h"

#include <array>

#include "exporters/blender.h"
#include "exporters/json.h"
#include "exporters/povray.h"
#include "scene/refusal.h"

namespace litmus {

namespace {

void refuse_native_json(const Scene&, std::ostream&) {
  throw Refusal("--native: JSON belongs to no renderer, so there is no native form of it");
}

std::vector<std::string> no_caveats(const Scene&) { return {}; }

}  // namespace

std::span<const Exporter> exporters() {
  static const std::array table{
      Exporter{"povray", ".pov", write_povray, write_povray_native, povray_caveats},
      Exporter{"blender", ".py", write_blender, write_blender_native, blender_caveats},
      Exporter{"json", ".json", write_scene_json, refuse_native_json, no_caveats},
  };
  return table;
}

const Exporter* find_exporter(std::string_view name) {
  for (const Exporter& exporter : exporters())
    if (exporter.name == name) return &exporter;
  return nullptr;
}

}  // namespace litmus

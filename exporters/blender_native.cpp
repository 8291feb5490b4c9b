// blender_native.cpp: what a user of Blender would write.
#include <ostream>

#include "exporters/blender.h"
#include "scene/refusal.h"

namespace litmus {

void write_blender_native(const Scene& scene, std::ostream&) {
  throw Refusal(scene.name + ": --native: not available for Blender");
}

}  // namespace litmus

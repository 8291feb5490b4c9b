// scene.cpp: names of the kinds of light.
#include "scene/scene.h"

namespace litmus {

std::string_view light_type(const Light& light) {
  static constexpr std::string_view kNames[] = {"directional", "point", "spot", "area"};
  return kNames[light.shape.index()];
}

}  // namespace litmus

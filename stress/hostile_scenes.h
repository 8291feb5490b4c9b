// hostile_scenes.h: small scenes that the loader accepts and that break careless code.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace litmus {

/// Every hostile light over every hostile view of a floor, a sphere, a box and a smooth mesh, in
/// both readings of slide 5. Each scene's name says what is hostile; 17 x 17 pixels. Intensities
/// and coefficients fit into float.
std::vector<Scene> hostile_scenes();

}  // namespace litmus

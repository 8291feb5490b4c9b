// regions.h: which pixels lie on an edge of the scene, its shadows or its cones.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/picture.h"

namespace litmus {

/// 1 where the signature of any 3 x 3 neighbour inside the image differs from the pixel's own, else
/// 0; width * height, row by row. There a rounding error may decide between lit and dark;
/// everywhere else a layer is smooth.
std::vector<std::uint8_t> edge_mask(const Signature& signature);

}  // namespace litmus

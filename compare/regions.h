// regions.h: which pixels lie on an edge of the scene, its shadows or its cones, and what a light
// does to the others.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compare/difference.h"
#include "scene/picture.h"

namespace litmus {

/// 1 where the signature of any 3 x 3 neighbour inside the image differs from the pixel's own, else
/// 0; width * height, row by row. There a rounding error may decide between lit and dark;
/// everywhere else a layer is smooth.
std::vector<std::uint8_t> edge_mask(const Signature& signature);

/// The regions that a light divides its interior into, and its highlight. They leave out where it
/// does not shine anyway: the background, surfaces turned away from all its lamps, and outside a
/// cone.
inline constexpr std::array<Region, 4> kLightRegions{Region::Lit, Region::Penumbra, Region::Umbra,
                                                     Region::Highlight};

/// 1 where a pixel is no edge and belongs to one of kLightRegions, by its flags (kLit and so on),
/// both width * height:
/// - lit: of the lamps that would light the surface, none is hidden, in any sample of the pixel;
/// - umbra: all of them are hidden;
/// - penumbra: anything between;
/// - highlight: the specular power (h.n)^ns of a lamp in view is above 1/2 in some sample.
std::vector<std::uint8_t> region_mask(std::span<const std::uint8_t> flags,
                                      std::span<const std::uint8_t> edge, Region region);

}  // namespace litmus

// smooth_pieces.h: where a picture is smooth, and what it is between its pixels there.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/picture.h"

namespace litmus {

/// A place along a row or a column, pixels' centres being whole numbers: the first of the four
/// pixels around it, and their weights in a Catmull-Rom cubic and in its derivative.
struct CubicPlace {
  int first;
  std::array<double, 4> value, slope;
};
CubicPlace cubic_place(double at);

struct PlacedSample {
  glm::dvec3 value{0}, along_x{0}, along_y{0};  ///< and derivatives, per pixel
};

/// The picture at a column and a row. All 16 pixels around lie inside the picture.
PlacedSample sample_at(const Picture& picture, const CubicPlace& column, const CubicPlace& row);

/// 1 where the 5 x 5 pixels around one are inside, finite and of one smooth piece: no edge (as by
/// edge_mask; may be empty) among the inner 3 x 3, each of which vouches for its own neighbours.
std::vector<std::uint8_t> smooth_pixels(const Picture& picture, std::span<const std::uint8_t> edge);

/// The same without pixels beside a crease that no mask knows, as between the flat facets of a
/// mesh: where the third difference along a row or a column, which a step makes twice as large as
/// the step itself and a smooth piece far smaller, is over the first.
std::vector<std::uint8_t> without_creases(const Picture& picture, std::vector<std::uint8_t> smooth);

}  // namespace litmus

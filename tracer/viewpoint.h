// viewpoint.h: a surface point that looks at an area light, and what may be in the way.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracer/plan.h"
#include "tracer/shaft.h"
#include "tracer/silhouette.h"
#include "tracer/visibility.h"

namespace litmus {

/// An area light as the rectangle that its samples stand for.
struct Panel {
  Lamp<double> lamp;       ///< any sample: its origin is moved
  Vec<double> center;      ///< scene units
  Vec<double> across, up;  ///< half the sides, along `right` and `up` (slide 20)
  Direction<double> across_side = direction_of(across), up_side = direction_of(up);
  bool meets_triangles = false;  ///< some triangle may pass through the rectangle
};

/// What the integration needs of a scene's objects besides its plan, made once.
struct Occluders {
  EdgeTree edges;
};

/// A piece of the rectangle: u and v of its centre, from -1 to 1, and half its side.
struct Piece {
  double u = 0, v = 0, half = 1;
};

/// Something at which a shadow may end: an object, or (as Kind::Triangle) an edge of a mesh. Index
/// -1: unknown ones, which stay in the way of everything.
struct Obstacle {
  Kind kind;
  int index;
};

/// Whether a piece lies on the side of the surface that is lit.
enum class Facing { Yes, No, Mixed };

/// What is in the way of a piece, as far as it is known.
struct Cover {
  std::array<ConvexSet, kMostHidden> sets;
  std::array<SeenEdge, kMostCuts> edges;
  std::size_t set_count = 0, edge_count = 0;
  double uncertain = 0;  ///< share of the piece

  Cover() {}
  std::span<const ConvexSet> all_sets() const { return {sets.data(), set_count}; }
  std::span<const SeenEdge> all_edges() const { return {edges.data(), edge_count}; }
};

struct Viewpoint {
  const Plan<double>& plan;
  const Occluders& occluders;
  const Panel& panel;
  const Hit<double>& hit;

  Vec<double> at(double u, double v) const {  ///< of the rectangle, relative to the point
    return panel.center + u * panel.across + v * panel.up - hit.point;
  }
  Shaft shaft(const Piece& piece) const {
    return shaft_to(at(piece.u, piece.v), piece.half * panel.across, piece.half * panel.up);
  }
  Incident<double> light(double u, double v) const;
  Facing facing(const Shaft& shaft) const;
  /// The part of the shaft's base above the horizon.
  Polygon above_horizon(const Shaft& shaft, Facing side) const;

  /// Every object but the surface itself, where it is flat or seen from outside, and if `meshes`
  /// the edges of meshes before the whole rectangle.
  std::vector<Obstacle> obstacles(const Shaft& whole, bool meshes) const;
  Sight sight(const Shaft& shaft, const Obstacle& one) const;
  /// Nothing if there are too many or one of them cannot be told. `widest`: see hidden_part().
  std::optional<Cover> cover(const Shaft& shaft, std::span<const Obstacle> undecided,
                             std::size_t most_edges, double widest) const;

  /// Whether any triangle may be in the way.
  bool near_triangles(const Shaft& shaft) const;
  /// Triangles alone.
  bool triangles_block(double u, double v) const;
};

}  // namespace litmus

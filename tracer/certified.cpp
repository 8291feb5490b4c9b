// certified.cpp: splitting an area light's rectangle until nothing is left to chance.
#include "tracer/certified.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "scene/picture.h"
#include "tracer/area_sampling.h"
#include "tracer/quadrature_bound.h"

namespace litmus {
namespace {

using V3 = Vec<double>;

/// Something at which a shadow may end: an object, or (as Kind::Triangle) an edge of a mesh. Index
/// -1: unknown ones, which stay in the way of everything.
struct Obstacle {
  Kind kind;
  int index;
};

Terms<double> operator*(double s, const Terms<double>& t) {
  return {s * t.diffuse, s * t.specular};
}
Terms<double>& operator+=(Terms<double>& a, const Terms<double>& b) {
  a.diffuse += b.diffuse, a.specular += b.specular;
  return a;
}

/// Up to so many edges of meshes cut a piece that could still be split.
constexpr std::size_t kFewEdges = 8;
/// A polygon smaller than that is all rounding, as a share of its piece.
constexpr double kNothing = 1e-12;

/// A piece of the rectangle: u and v of its centre, from -1 to 1, and half its side.
struct Piece {
  double u, v, half;
  int splits;  ///< still allowed
};

/// Whether a piece lies on the side of the surface that is lit.
enum class Facing { Yes, No, Mixed };

struct Integrator {
  const Plan<double>& plan;
  const Occluders& occluders;
  const Panel& panel;
  const Hit<double>& hit;
  const V3& eye;
  const Finish<double>& finish;
  Terms<double> weight;
  double tolerance;                   ///< of quadrature
  double outline_tolerance;           ///< of what is in view
  double widest_side;                 ///< of a sphere's outline, radians
  int fewest_points;                  ///< of quadrature along a side of a piece
  int first_parts;                    ///< along a side of the whole: 2 or 3; later ones are 2
  std::vector<Obstacle> obstacles{};  ///< a stack: each piece's are a range of it
  PanelTerms result{};
  bool mesh_ends = false;  ///< some mesh's shadow ends on the rectangle
  bool seen = false, hidden = false;

  SphereSurface<double> sphere(int i) const {
    const auto& shape = plan.spheres[std::size_t(i)].shape;
    return {shape.center - hit.point, shape.radius};
  }
  BoxSurface<double> box(int i) const {
    const auto& shape = plan.boxes[std::size_t(i)].shape;
    return {shape.min - hit.point, shape.max - hit.point};
  }
  PlaneSurface<double> plane(int i) const {
    const auto& shape = plan.planes[std::size_t(i)].shape;
    return {shape.point - hit.point, shape.normal};
  }

  Sight sight(const Shaft& shaft, const Obstacle& one) const {
    switch (one.kind) {
      case Kind::Sphere:
        return sight_past(shaft, sphere(one.index));
      case Kind::Box:
        return sight_past(shaft, box(one.index));
      case Kind::Plane:
        return sight_past(shaft, plane(one.index));
      case Kind::Triangle: {
        if (one.index < 0) return Sight::Undecided;
        const MeshEdge& edge = occluders.edges.edges[std::size_t(one.index)];
        return may_meet(shaft, edge.a - hit.point, edge.b - hit.point) ? Sight::Undecided
                                                                       : Sight::Clear;
      }
      case Kind::None:
        break;
    }
    return Sight::Undecided;
  }

  HiddenPart hidden_by(const Shaft& shaft, const Obstacle& one) const {
    switch (one.kind) {
      case Kind::Sphere:
        return hidden_part(shaft, sphere(one.index), widest_side);
      case Kind::Box:
        return hidden_part(shaft, box(one.index));
      case Kind::Plane:
        return hidden_part(shaft, plane(one.index));
      case Kind::Triangle:
      case Kind::None:
        break;
    }
    return {};
  }

  /// Every object but the surface itself, where it is flat or seen from outside, and the edges of
  /// meshes before the whole rectangle. False where no light comes from it.
  bool collect() {
    const Shaft shaft = shaft_to(at(0, 0) - hit.point, panel.across, panel.up);
    if (facing(shaft) == Facing::No) return false;
    if (!plan.shadows) return true;
    const auto add = [&](Kind kind, std::size_t count, bool own_counts) {
      for (int i = 0; i < int(count); ++i)
        if (own_counts || hit.kind != kind || hit.index != i) obstacles.push_back({kind, i});
    };
    add(Kind::Sphere, plan.spheres.size(), seen_from_inside());
    add(Kind::Box, plan.boxes.size(), seen_from_inside());
    add(Kind::Plane, plan.planes.size(), false);
    if (!near_triangles(shaft)) return true;
    thread_local std::vector<std::uint32_t> edges;
    edges.clear();
    find_shadow_ends(occluders.edges, hit.point, shaft, edges);
    for (const std::uint32_t edge : edges) obstacles.push_back({Kind::Triangle, int(edge)});
    if (panel.meets_triangles) obstacles.push_back({Kind::Triangle, -1});
    // All of the rectangle is behind triangles, or nothing of it.
    mesh_ends = !edges.empty() || panel.meets_triangles;
    if (!mesh_ends) hidden = triangles_block(0, 0);
    return !hidden;
  }

  bool seen_from_inside() const {
    if (hit.kind == Kind::Sphere)
      return dot(hit.geometric, hit.point - plan.spheres[std::size_t(hit.index)].shape.center) < 0;
    if (hit.kind == Kind::Box) return (hit.face % 2 ? 1 : -1) * hit.geometric[hit.face / 2] < 0;
    return false;
  }

  Facing facing(const Shaft& shaft) const {
    bool all = true, none = false;
    for (const V3& normal : {hit.geometric, hit.normal}) {
      bool any = false;
      for (const V3& corner : shaft.corners) {
        const bool faces = dot(corner, normal) > 0;
        all = all && faces, any = any || faces;
      }
      none = none || !any;
    }
    return none ? Facing::No : all ? Facing::Yes : Facing::Mixed;
  }

  bool near_triangles(const Shaft& shaft) const {
    if (!plan.shadows || occluders.edges.nodes.empty()) return false;
    const BoxSurface<double>& all = occluders.edges.nodes[0].box;
    return may_meet(shaft, BoxSurface<double>{all.min - hit.point, all.max - hit.point});
  }

  V3 at(double u, double v) const { return panel.center + u * panel.across + v * panel.up; }

  Incident<double> lamp_at(double u, double v) const {
    Lamp<double> lamp = panel.lamp;
    lamp.origin = at(u, v);
    return incident(lamp, hit.point);
  }

  /// D and S of a lamp on the rectangle, with nothing in the way; D goes on below the horizon.
  Terms<double> terms_at(double u, double v) {
    const Incident<double> light = lamp_at(u, v);
    ++result.evaluations;
    Terms<double> terms{light.intensity * dot(light.direction, hit.normal), 0};
    if (finish.shiny) {
      terms.specular =
          light.intensity * specular_power(light.direction, eye, hit.normal, finish.shininess);
      if (terms.specular > light.intensity / 2) result.flags |= kHighlight;
    }
    return terms;
  }

  /// Triangles only: what the other objects hide is known.
  bool triangles_block(double u, double v) {
    ++result.rays;
    const ShadowRay<double> ray = shadow_ray(hit, lamp_at(u, v));
    return blocking_triangle<double>(plan, ray, own_triangle(hit, 0)) >= 0;
  }

  LightPatch patch_of(const Piece& piece) const {
    const Direction<double> to = direction_of(at(piece.u, piece.v) - hit.point);
    const Direction<double> across = direction_of(panel.across), up = direction_of(panel.up);
    return {panel.lamp,
            to.length,
            piece.half * across.length / to.length,
            piece.half * up.length / to.length,
            std::max(std::fabs(dot(across.unit, to.unit)), std::fabs(dot(up.unit, to.unit))),
            to.unit,
            eye,
            hit.normal,
            finish.shininess.value,
            finish.shiny};
  }

  double weighed(const Terms<double>& terms) const {
    return weight.diffuse * terms.diffuse + weight.specular * terms.specular;
  }
  bool within_tolerance(const Terms<double>& bound) const { return weighed(bound) <= tolerance; }

  /// The fewest points that keep the tolerance, or the most if none do.
  int points_for(const std::array<Terms<double>, kMostPoints>& bounds) const {
    int points = fewest_points;
    while (points < kMostPoints && !within_tolerance(bounds[std::size_t(points - 1)])) ++points;
    return points;
  }

  /// Adds the light of the region of a piece that has these moments.
  void add_light(const Piece& piece, const Moments& moments, const Terms<double>& largest) {
    const int points = moments.points;
    const auto weights = node_weights(moments);
    const GaussRule& rule = short_rule(points);
    Terms<double> sum;
    for (int i = 0; i < points; ++i) {
      for (int j = 0; j < points; ++j) {
        sum += weights[std::size_t(i * points + j)] *
               terms_at(piece.u + piece.half * rule.nodes[std::size_t(i)],
                        piece.v + piece.half * rule.nodes[std::size_t(j)]);
      }
    }
    const double share = moments.share();
    sum.diffuse = std::clamp(sum.diffuse, 0.0, share * largest.diffuse);
    sum.specular = std::clamp(sum.specular, 0.0, share * largest.specular);
    result.value += piece.half * piece.half * sum;
    seen = true;
  }

  /// Calls visit(part) for parts of a polygon that no edge crosses.
  template <class Visit>
  void cut(const Polygon& polygon, std::span<const SeenEdge> edges, const Visit& visit) {
    if (polygon.area() < kNothing) return;
    while (!edges.empty() && !may_cross(polygon, edges[0])) edges = edges.subspan(1);
    if (edges.empty()) return visit(polygon);
    const HalfPlane& one = edges[0].line;
    for (const HalfPlane& side : {one, HalfPlane{-one.constant, -one.along_u, -one.along_v}}) {
      Polygon part = polygon;
      part.clip(side);
      cut(part, edges.subspan(1), visit);
    }
  }

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

  /// Nothing if the obstacles from `first` on are too many or one of them cannot be told.
  std::optional<Cover> cover_of(const Shaft& shaft, std::size_t first,
                                std::size_t most_edges) const {
    std::optional<Cover> cover(std::in_place);
    for (std::size_t i = first; i < obstacles.size(); ++i) {
      const Obstacle& one = obstacles[i];
      if (one.kind == Kind::Triangle) {
        if (one.index < 0 || cover->edge_count == most_edges) return {};
        const MeshEdge& edge = occluders.edges.edges[std::size_t(one.index)];
        cover->edges[cover->edge_count++] =
            seen_edge(shaft, edge.a - hit.point, edge.b - hit.point);
      } else {
        if (cover->set_count == kMostHidden) return {};
        const HiddenPart part = hidden_by(shaft, one);
        if (part.set.count == 0) return {};
        cover->sets[cover->set_count++] = part.set;
        cover->uncertain += part.uncertain;
      }
    }
    return cover;
  }

  /// Adds a piece whose obstacles are those from `first` on; false if it has to be split.
  bool integrate(const Piece& piece, const Shaft& shaft, Facing side, std::size_t first) {
    const bool last = piece.splits == 0;
    const bool whole = side == Facing::Yes && first == obstacles.size();
    const LightPatch patch = patch_of(piece);
    const auto bounds = quadrature_bounds(patch, whole ? Region::Whole : Region::Part);
    Moments moments{points_for(bounds)};
    const Terms<double>& bound = bounds[std::size_t(moments.points - 1)];
    if (!last && !within_tolerance(bound)) return false;
    const std::optional<Cover> cover = cover_of(shaft, first, last ? kMostCuts : kFewEdges);
    const Terms<double> largest = largest_terms(patch);
    if (!cover) return last && (estimate(piece, largest), true);
    if (!last && cover->uncertain * weighed(largest) > outline_tolerance) return false;

    Polygon facing = Polygon::square();
    if (side == Facing::Mixed)
      facing.clip(above(shaft, hit.geometric)), facing.clip(above(shaft, hit.normal));
    const bool ask = mesh_ends && near_triangles(shaft);
    cut(facing, cover->all_edges(), [&](const Polygon& part) {
      const Corner middle = part.centroid();
      if (!ask ||
          !triangles_block(piece.u + piece.half * middle.u, piece.v + piece.half * middle.v))
        add_visible(moments, part, cover->all_sets());
    });
    const double share = std::clamp(moments.share(), 0.0, 1.0);
    hidden = hidden || share < facing.area() / 4 - kNothing;
    const double area = piece.half * piece.half;
    result.bound += area * share * bound;
    result.bound += area * cover->uncertain * largest;
    if (share > kNothing) add_light(piece, moments, largest);
    return true;
  }

  /// A piece about which little is known, by its centre.
  void estimate(const Piece& piece, const Terms<double>& largest) {
    const double area = piece.half * piece.half;
    result.bound += area * largest;
    const Incident<double> light = lamp_at(piece.u, piece.v);
    ++result.rays;
    if (occluded(plan, hit, light)) {
      hidden = true;
    } else {
      Moments moments{1};
      moments.of[0][0] = 1;
      add_light(piece, moments, largest);
    }
  }

  void split(const Piece& piece, std::size_t first) {
    const int parts = piece.half == 1 ? first_parts : 2;
    const double half = piece.half / parts;
    const std::size_t last = obstacles.size();
    for (int row = 0; row < parts; ++row) {
      for (int column = 0; column < parts; ++column) {
        const std::size_t begin = obstacles.size();
        for (std::size_t i = first; i < last; ++i) obstacles.push_back(obstacles[i]);
        look({piece.u + (2 * column + 1 - parts) * half, piece.v + (2 * row + 1 - parts) * half,
              half, piece.splits - 1},
             begin);
        obstacles.resize(begin);
      }
    }
  }

  /// Adds a piece's light. Its obstacles are those from `first` on; only the undecided ones stay.
  void look(const Piece& piece, std::size_t first) {
    ++result.pieces;
    const Shaft shaft = shaft_to(at(piece.u, piece.v) - hit.point, piece.half * panel.across,
                                 piece.half * panel.up);
    const Facing side = facing(shaft);
    if (side == Facing::No) return;
    // What is not clear stays; one object that covers everything ends it.
    std::size_t kept = first;
    for (std::size_t i = first; i < obstacles.size(); ++i) {
      const Obstacle one = obstacles[i];
      const Sight past = sight(shaft, one);
      if (past == Sight::Blocked) {
        hidden = true;
        return;
      }
      if (past == Sight::Undecided) obstacles[kept++] = one;
    }
    obstacles.resize(kept);
    if (!integrate(piece, shaft, side, first)) split(piece, first);
  }
};

}  // namespace

PanelTerms certified_terms(const Plan<double>& plan, const Occluders& occluders, const Panel& panel,
                           const Hit<double>& hit, const V3& eye, const Terms<double>& weight,
                           int n) {
  // The least of 1, 2, 3, 4, 6, 8, 12, 16, ... that is not below n.
  int splits = 0, finest = 1;
  while (finest < n) finest *= 2, ++splits;
  const bool thirds = finest >= 4 && finest / 4 * 3 >= n;
  if (thirds) finest = finest / 4 * 3;
  Integrator integrator{plan,
                        occluders,
                        panel,
                        hit,
                        eye,
                        plan.finishes[std::size_t(hit.object)],
                        weight,
                        std::pow(finest, -3.0),
                        std::pow(finest, -2.0),
                        std::min(std::numbers::pi / 4, 1.0 / finest),
                        std::min(1 + splits, 3),
                        thirds ? 3 : 2};
  if (integrator.collect()) integrator.look({0, 0, 1, thirds ? splits - 1 : splits}, 0);
  PanelTerms& result = integrator.result;
  if (integrator.seen) result.flags |= integrator.hidden ? kPenumbra : kLit;
  if (!integrator.seen && integrator.hidden) result.flags |= kUmbra;
  return result;
}

}  // namespace litmus

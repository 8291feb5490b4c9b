// certified.cpp: splitting an area light's rectangle until nothing is left to chance.
#include "tracer/certified.h"

#include <array>
#include <cmath>

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

constexpr int kSplitsForSmallSpheres = 8;

const GaussRule& rule_of(int points) {
  static const std::array rules{gauss_rule(1), gauss_rule(2), gauss_rule(3)};
  return rules[std::size_t(points - 1)];
}

/// A piece of the rectangle: u and v of its centre, from -1 to 1, and half its side.
struct Piece {
  double u, v, half;
  int splits;  ///< still allowed; below zero: done for the sake of a small sphere
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
  double tolerance;
  int first_parts;                    ///< along a side of the whole: 2 or 3; later ones are 2
  std::vector<Obstacle> obstacles{};  ///< a stack: each piece's are a range of it
  PanelTerms result{};
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

  std::vector<HalfPlane> hidden_by(const Shaft& shaft, const Obstacle& one) const {
    switch (one.kind) {
      case Kind::Sphere:
        return hidden_part(shaft, sphere(one.index));
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
  /// meshes before the whole rectangle.
  void collect() {
    const auto add = [&](Kind kind, std::size_t count, bool own_counts) {
      for (int i = 0; i < int(count); ++i)
        if (own_counts || hit.kind != kind || hit.index != i) obstacles.push_back({kind, i});
    };
    add(Kind::Sphere, plan.spheres.size(), seen_from_inside());
    add(Kind::Box, plan.boxes.size(), seen_from_inside());
    add(Kind::Plane, plan.planes.size(), false);
    const Shaft shaft = shaft_to(at(0, 0) - hit.point, panel.across, panel.up);
    if (!near_triangles(shaft)) return;
    std::vector<std::uint32_t> edges;
    find_shadow_ends(occluders.edges, hit.point, shaft, edges);
    for (const std::uint32_t edge : edges) obstacles.push_back({Kind::Triangle, int(edge)});
    if (panel.meets_triangles) obstacles.push_back({Kind::Triangle, -1});
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

  /// D and S of a lamp on the rectangle, with nothing in the way.
  Terms<double> terms_at(double u, double v) {
    Lamp<double> lamp = panel.lamp;
    lamp.origin = at(u, v);
    const Incident<double> light = incident(lamp, hit.point);
    ++result.evaluations;
    if (!(dot(light.direction, hit.geometric) > 0)) return {};
    const Terms<double> terms = equation_terms(light.direction, eye, hit.normal, finish.shininess,
                                               light.intensity, finish.shiny);
    if (terms.specular > light.intensity / 2) result.flags |= kHighlight;
    return terms;
  }

  bool ray_blocked(double u, double v) {
    Lamp<double> lamp = panel.lamp;
    lamp.origin = at(u, v);
    ++result.rays;
    return occluded(plan, hit, incident(lamp, hit.point));
  }

  LightPatch patch_of(const Piece& piece) const {
    const Direction<double> to = direction_of(at(piece.u, piece.v) - hit.point);
    return {panel.lamp,
            to.length,
            piece.half * direction_of(panel.across).length / to.length,
            piece.half * direction_of(panel.up).length / to.length,
            to.unit,
            eye,
            hit.normal,
            finish.shininess.value,
            finish.shiny};
  }

  bool within_tolerance(const Terms<double>& bound) const {
    return weight.diffuse * bound.diffuse + weight.specular * bound.specular <= tolerance;
  }

  /// A piece in full view; false if it has to be split.
  bool integrate(const Piece& piece) {
    const auto bounds = quadrature_bounds(patch_of(piece));
    int points = 1;
    while (!within_tolerance(bounds[std::size_t(points - 1)]) && points < kMostPoints) ++points;
    const Terms<double>& bound = bounds[std::size_t(points - 1)];
    if (!within_tolerance(bound) && piece.splits > 0) return false;
    const GaussRule& rule = rule_of(points);
    const double share = piece.half * piece.half;
    for (int i = 0; i < points; ++i) {
      for (int j = 0; j < points; ++j) {
        result.value += share * rule.weights[std::size_t(i)] * rule.weights[std::size_t(j)] *
                        terms_at(piece.u + piece.half * rule.nodes[std::size_t(i)],
                                 piece.v + piece.half * rule.nodes[std::size_t(j)]);
      }
    }
    result.bound += share * bound;
    seen = true;
    return true;
  }

  /// Whether an undecided sphere looks smaller than the piece: its outline is then no tangent.
  bool hides_a_small_sphere(const Piece& piece, const Shaft& shaft, std::size_t first) const {
    if (piece.splits <= -kSplitsForSmallSpheres) return false;
    const double size = direction_of(shaft.across + shaft.up).length;
    const double distance = direction_of(shaft.center).length;
    for (std::size_t i = first; i < obstacles.size(); ++i) {
      if (obstacles[i].kind != Kind::Sphere) continue;
      const SphereSurface<double> one = sphere(obstacles[i].index);
      if (one.radius * distance < size * direction_of(one.center).length) return true;
    }
    return false;
  }

  /// Adds a part of a piece, seen or not as its centroid is.
  void add_part(const Piece& piece, const VisiblePart& part, bool ask) {
    if (part.share == 0) return;
    const double u = piece.u + piece.half * part.u, v = piece.v + piece.half * part.v;
    if (ask && ray_blocked(u, v)) {
      hidden = true;
      return;
    }
    seen = true;
    result.value += piece.half * piece.half * part.share * terms_at(u, v);
  }

  /// A piece that is partly in view, or may be: past the one thing at which the shadow ends, or by
  /// its centre.
  void estimate(const Piece& piece, const Shaft& shaft, std::size_t first) {
    const bool one = obstacles.size() - first == 1 && obstacles[first].index >= 0;
    if (one && obstacles[first].kind == Kind::Triangle) {
      const MeshEdge& edge = occluders.edges.edges[std::size_t(obstacles[first].index)];
      const HalfPlane half = beyond_edge(shaft, edge.a - hit.point, edge.b - hit.point);
      const HalfPlane other{-half.constant, -half.along_u, -half.along_v};
      for (const HalfPlane& side : {half, other})
        add_part(piece, visible_part(std::span(&side, 1)), true);
    } else if (const auto planes =
                   one ? hidden_by(shaft, obstacles[first]) : std::vector<HalfPlane>{};
               !planes.empty()) {
      const VisiblePart part = visible_part(planes);
      hidden = hidden || part.share < 1;
      add_part(piece, part, near_triangles(shaft));
    } else {
      add_part(piece, {1, 0, 0}, plan.shadows);
    }
    result.bound += piece.half * piece.half * largest_terms(patch_of(piece));
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
    if (side == Facing::Mixed) {
      if (piece.splits > 0) return split(piece, first);
      obstacles.resize(first);
      return estimate(piece, shaft, first);
    }

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
    if (kept > first) {
      return piece.splits > 0 || hides_a_small_sphere(piece, shaft, first)
                 ? split(piece, first)
                 : estimate(piece, shaft, first);
    }
    // All of it meets a triangle, or nothing of it does.
    if (near_triangles(shaft) && ray_blocked(piece.u, piece.v)) {
      hidden = true;
      return;
    }
    if (!integrate(piece)) split(piece, first);
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
  Integrator integrator{plan,          occluders,
                        panel,         hit,
                        eye,           plan.finishes[std::size_t(hit.object)],
                        weight,        1 / (double(finest) * finest),
                        thirds ? 3 : 2};
  if (plan.shadows) integrator.collect();
  integrator.look({0, 0, 1, thirds ? splits - 1 : splits}, 0);
  PanelTerms& result = integrator.result;
  if (integrator.seen) result.flags |= integrator.hidden ? kPenumbra : kLit;
  if (!integrator.seen && integrator.hidden) result.flags |= kUmbra;
  return result;
}

}  // namespace litmus

// certified.cpp: splitting an area light's rectangle until nothing is left to chance.
#include "tracer/certified.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/picture.h"
#include "tracer/quadrature_bound.h"

namespace litmus {
namespace {

using V3 = Vec<double>;

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

/// What n asks for.
struct Fineness {
  int splits;                ///< of the rectangle, at most
  int first_parts;           ///< along a side of the whole: 2 or 3; later ones are 2
  int fewest_points;         ///< of quadrature, along a side of a piece
  double tolerance;          ///< of quadrature, over the area integrated
  double outline_tolerance;  ///< of what is in view, over the area
  double widest_side;        ///< of a sphere's outline, radians
};

Fineness fineness_of(int n) {
  // The least of 1, 2, 3, 4, 6, 8, 12, 16, ... that is not below n.
  int splits = 0, finest = 1;
  while (finest < n) finest *= 2, ++splits;
  const int points = std::min(1 + splits, 3);
  const bool thirds = finest >= 4 && finest / 4 * 3 >= n;
  if (thirds) finest = finest / 4 * 3, --splits;
  return {splits,
          thirds ? 3 : 2,
          points,
          std::pow(finest, -3.0),
          std::pow(finest, -2.0),
          std::min(std::numbers::pi / 4, 1.0 / finest)};
}

struct Integrator {
  const Viewpoint& from;
  const V3& eye;
  const Finish<double>& finish;
  Terms<double> weight;
  Fineness fineness;
  std::vector<Obstacle> obstacles{};  ///< a stack: each piece's are a range of it
  PanelTerms result{};
  bool mesh_ends = false;  ///< some mesh's shadow ends on the rectangle
  bool seen = false, hidden = false;

  /// D and S of a lamp on the rectangle, with nothing in the way; D goes on below the horizon.
  Terms<double> terms_at(double u, double v) {
    const Incident<double> light = from.light(u, v);
    ++result.evaluations;
    const Terms<double> terms = ungated_terms(light.direction, eye, from.hit.normal,
                                              finish.shininess, light.intensity, finish.shiny);
    if (terms.specular > light.intensity / 2) result.flags |= kHighlight;
    return terms;
  }

  LightPatch patch_of(const Piece& piece) const {
    const Direction<double> to = direction_of(from.at(piece.u, piece.v));
    const Direction<double>&across = from.panel.across_side, &up = from.panel.up_side;
    return {from.panel.lamp,
            to.length,
            piece.half * across.length / to.length,
            piece.half * up.length / to.length,
            std::max(std::fabs(dot(across.unit, to.unit)), std::fabs(dot(up.unit, to.unit))),
            to.unit,
            eye,
            from.hit.normal,
            finish.shininess.value,
            finish.shiny};
  }

  double weighed(const Terms<double>& terms) const {
    return weight.diffuse * terms.diffuse + weight.specular * terms.specular;
  }

  /// The fewest points that keep the tolerance, or the most if none do.
  int points_for(const std::array<Terms<double>, kMostPoints>& bounds) const {
    int points = fineness.fewest_points;
    while (points < kMostPoints && weighed(bounds[std::size_t(points - 1)]) > fineness.tolerance)
      ++points;
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

  /// Adds the moments of what is in view of a part of a piece.
  void add_view(Moments& moments, const Piece& piece, const Shaft& shaft, const Polygon& part,
                const Cover& cover) {
    const bool ask = mesh_ends && from.near_triangles(shaft);
    cut(part, cover.all_edges(), [&](const Polygon& uncrossed) {
      const Corner middle = uncrossed.centroid();
      result.rays += ask;
      if (!ask ||
          !from.triangles_block(piece.u + piece.half * middle.u, piece.v + piece.half * middle.v))
        add_visible(moments, uncrossed, cover.all_sets());
    });
  }

  /// Adds a piece whose obstacles are those from `first` on; false if it has to be split.
  bool integrate(const Piece& piece, const Shaft& shaft, Facing side, std::size_t first,
                 bool last) {
    const bool whole = side == Facing::Yes && first == obstacles.size();
    const LightPatch patch = patch_of(piece);
    const auto [largest, errors] = quadrature_bounds(patch, whole ? Region::Whole : Region::Part);
    Moments moments{points_for(errors)};
    const Terms<double>& bound = errors[std::size_t(moments.points - 1)];
    if (!last && weighed(bound) > fineness.tolerance) return false;
    const auto undecided = std::span<const Obstacle>(obstacles).subspan(first);
    const std::optional<Cover> cover =
        from.cover(shaft, undecided, last ? kMostCuts : kFewEdges, fineness.widest_side);
    if (!cover) return last && (estimate(piece, largest), true);
    if (!last && cover->uncertain * weighed(largest) > fineness.outline_tolerance) return false;

    const Polygon part = from.above_horizon(shaft, side);
    add_view(moments, piece, shaft, part, *cover);
    const double share = std::clamp(moments.share(), 0.0, 1.0), area = piece.half * piece.half;
    hidden = hidden || share < part.area() / 4 - kNothing;
    result.bound += area * share * bound;
    result.bound += area * cover->uncertain * largest;
    if (share > kNothing) add_light(piece, moments, largest);
    return true;
  }

  /// A piece about which little is known, by its centre.
  void estimate(const Piece& piece, const Terms<double>& largest) {
    result.bound += piece.half * piece.half * largest;
    const Incident<double> light = from.light(piece.u, piece.v);
    const Hit<double>& hit = from.hit;
    if (!(dot(light.direction, hit.geometric) > 0) || !(dot(light.direction, hit.normal) > 0))
      return;
    ++result.rays;
    if (occluded(from.plan, hit, light)) {
      hidden = true;
    } else {
      Moments moments{1};
      moments.of[0][0] = 1;
      add_light(piece, moments, largest);
    }
  }

  void split(const Piece& piece, int splits, std::size_t first) {
    const int parts = piece.half == 1 ? fineness.first_parts : 2;
    const double half = piece.half / parts;
    const std::size_t last = obstacles.size();
    for (int row = 0; row < parts; ++row) {
      for (int column = 0; column < parts; ++column) {
        const std::size_t begin = obstacles.size();
        for (std::size_t i = first; i < last; ++i) obstacles.push_back(obstacles[i]);
        const Piece part{piece.u + (2 * column + 1 - parts) * half,
                         piece.v + (2 * row + 1 - parts) * half, half};
        look(part, from.shaft(part), splits - 1, begin);
        obstacles.resize(begin);
      }
    }
  }

  /// Adds a piece's light. Its obstacles are those from `first` on; only the undecided ones stay.
  void look(const Piece& piece, const Shaft& shaft, int splits, std::size_t first) {
    ++result.pieces;
    const Facing side = from.facing(shaft);
    if (side == Facing::No) return;
    // What is not clear stays; one object that covers everything ends it.
    std::size_t kept = first;
    for (std::size_t i = first; i < obstacles.size(); ++i) {
      const Obstacle one = obstacles[i];
      const Sight past = from.sight(shaft, one);
      if (past == Sight::Blocked) {
        hidden = true;
        return;
      }
      if (past == Sight::Undecided) obstacles[kept++] = one;
    }
    obstacles.resize(kept);
    if (!integrate(piece, shaft, side, first, splits == 0)) split(piece, splits, first);
  }

  void look_at_all() {
    const Piece whole;
    const Shaft shaft = from.shaft(whole);
    if (from.facing(shaft) == Facing::No) return;
    const bool meshes = from.near_triangles(shaft);
    obstacles = from.obstacles(shaft, meshes);
    mesh_ends = !obstacles.empty() && obstacles.back().kind == Kind::Triangle;
    if (!mesh_ends && meshes) {
      // All of the rectangle is behind triangles, or nothing of it.
      ++result.rays;
      hidden = from.triangles_block(0, 0);
      if (hidden) return;
    }
    look(whole, shaft, fineness.splits, 0);
  }
};

}  // namespace

PanelTerms certified_terms(const Plan<double>& plan, const Occluders& occluders, const Panel& panel,
                           const Hit<double>& hit, const V3& eye, const Terms<double>& weight,
                           int n) {
  const Viewpoint from{plan, occluders, panel, hit};
  Integrator integrator{from, eye, plan.finishes[std::size_t(hit.object)], weight, fineness_of(n)};
  integrator.look_at_all();
  PanelTerms& result = integrator.result;
  if (integrator.seen) result.flags |= integrator.hidden ? kPenumbra : kLit;
  if (!integrator.seen && integrator.hidden) result.flags |= kUmbra;
  return result;
}

}  // namespace litmus

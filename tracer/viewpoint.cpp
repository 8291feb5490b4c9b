// viewpoint.cpp: a scene's objects, relative to a surface point.
#include "tracer/viewpoint.h"

namespace litmus {
namespace {

using V3 = Vec<double>;

SphereSurface<double> sphere_of(const Viewpoint& from, int i) {
  const auto& shape = from.plan.spheres[std::size_t(i)].shape;
  return {shape.center - from.hit.point, shape.radius};
}
BoxSurface<double> box_of(const Viewpoint& from, int i) {
  const auto& shape = from.plan.boxes[std::size_t(i)].shape;
  return {shape.min - from.hit.point, shape.max - from.hit.point};
}
PlaneSurface<double> plane_of(const Viewpoint& from, int i) {
  const auto& shape = from.plan.planes[std::size_t(i)].shape;
  return {shape.point - from.hit.point, shape.normal};
}

HiddenPart hidden_by(const Viewpoint& from, const Shaft& shaft, const Obstacle& one,
                     double widest) {
  switch (one.kind) {
    case Kind::Sphere:
      return hidden_part(shaft, sphere_of(from, one.index), widest);
    case Kind::Box:
      return hidden_part(shaft, box_of(from, one.index));
    case Kind::Plane:
      return hidden_part(shaft, plane_of(from, one.index));
    case Kind::Triangle:
    case Kind::None:
      break;
  }
  return {};
}

bool inside_own_surface(const Viewpoint& from) {
  const Hit<double>& hit = from.hit;
  if (hit.kind == Kind::Sphere) return dot(hit.geometric, sphere_of(from, hit.index).center) > 0;
  if (hit.kind == Kind::Box) return (hit.face % 2 ? 1 : -1) * hit.geometric[hit.face / 2] < 0;
  return false;
}

}  // namespace

Incident<double> Viewpoint::light(double u, double v) const {
  Lamp<double> lamp = panel.lamp;
  lamp.origin = panel.center + u * panel.across + v * panel.up;
  return incident(lamp, hit.point);
}

Facing Viewpoint::facing(const Shaft& shaft) const {
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

Polygon Viewpoint::above_horizon(const Shaft& shaft, Facing side) const {
  Polygon part = Polygon::square();
  if (side == Facing::Mixed)
    for (const V3& normal : {hit.geometric, hit.normal}) part.clip(above(shaft, normal));
  return part;
}

std::vector<Obstacle> Viewpoint::obstacles(const Shaft& whole, bool meshes) const {
  std::vector<Obstacle> all;
  if (!plan.shadows) return all;
  const bool own_counts = inside_own_surface(*this);
  const auto add = [&](Kind kind, std::size_t count) {
    for (int i = 0; i < int(count); ++i)
      if (own_counts || hit.kind != kind || hit.index != i) all.push_back({kind, i});
  };
  add(Kind::Sphere, plan.spheres.size());
  add(Kind::Box, plan.boxes.size());
  add(Kind::Plane, plan.planes.size());
  if (!meshes) return all;
  thread_local std::vector<std::uint32_t> edges;
  edges.clear();
  find_shadow_ends(occluders.edges, hit.point, whole, edges);
  for (const std::uint32_t edge : edges) all.push_back({Kind::Triangle, int(edge)});
  if (panel.meets_triangles) all.push_back({Kind::Triangle, -1});
  return all;
}

Sight Viewpoint::sight(const Shaft& shaft, const Obstacle& one) const {
  switch (one.kind) {
    case Kind::Sphere:
      return sight_past(shaft, sphere_of(*this, one.index));
    case Kind::Box:
      return sight_past(shaft, box_of(*this, one.index));
    case Kind::Plane:
      return sight_past(shaft, plane_of(*this, one.index));
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

std::optional<Cover> Viewpoint::cover(const Shaft& shaft, std::span<const Obstacle> undecided,
                                      std::size_t most_edges, double widest) const {
  std::optional<Cover> cover(std::in_place);
  for (const Obstacle& one : undecided) {
    if (one.kind == Kind::Triangle) {
      if (one.index < 0 || cover->edge_count == most_edges) return {};
      const MeshEdge& edge = occluders.edges.edges[std::size_t(one.index)];
      cover->edges[cover->edge_count++] = seen_edge(shaft, edge.a - hit.point, edge.b - hit.point);
    } else {
      if (cover->set_count == kMostHidden) return {};
      const HiddenPart part = hidden_by(*this, shaft, one, widest);
      if (part.set.count == 0) return {};
      cover->sets[cover->set_count++] = part.set;
      cover->uncertain += part.uncertain;
    }
  }
  return cover;
}

bool Viewpoint::near_triangles(const Shaft& shaft) const {
  if (!plan.shadows || occluders.edges.nodes.empty()) return false;
  const BoxSurface<double>& all = occluders.edges.nodes[0].box;
  return may_meet(shaft, BoxSurface<double>{all.min - hit.point, all.max - hit.point});
}

bool Viewpoint::triangles_block(double u, double v) const {
  return blocking_triangle<double>(plan, shadow_ray(hit, light(u, v)), own_triangle(hit, 0)) >= 0;
}

}  // namespace litmus

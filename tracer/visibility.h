// visibility.h: what a ray from the eye hits first, and whether anything stands between a point and
// a lamp.
#pragma once

#include "tracer/plan.h"

namespace litmus {

enum class Kind { None, Sphere, Plane, Box, Triangle };

/// The point seen. `kind` and `index` name the entry of the plan's list; `face` the face of a box.
template <Real R>
struct Hit {
  Kind kind = Kind::None;
  int index = -1, face = 0, object = -1;
  R t = std::numeric_limits<R>::infinity();
  R u{}, v{}, w{};   ///< triangles: barycentric weights
  Vec<R> point;      ///< on the surface itself, not just on the ray
  Vec<R> geometric;  ///< unit normal of the surface, turned towards the eye
  Vec<R> normal;     ///< unit normal for shading, turned towards the eye by itself
};

/// Nearest first; of equals the object that comes first in the scene, then the lower index.
template <Real R>
bool comes_before(R t, int object, int index, const Hit<R>& best) {
  if (t != best.t) return t < best.t;
  return object != best.object ? object < best.object : index < best.index;
}

/// The geometric and shading normal of a hit, and its point moved onto the surface.
template <Real R>
void settle(const Plan<R>& plan, const Ray<R>& ray, Hit<R>& hit) {
  hit.point = ray.origin + hit.t * ray.direction;
  switch (hit.kind) {
    case Kind::None:
      return;
    case Kind::Sphere: {
      const SphereSurface<R>& sphere = plan.spheres[std::size_t(hit.index)].shape;
      hit.geometric = normalize(hit.point - sphere.center);
      hit.point = sphere.center + sphere.radius * hit.geometric;
      hit.normal = hit.geometric;
      break;
    }
    case Kind::Plane: {
      const PlaneSurface<R>& plane = plan.planes[std::size_t(hit.index)].shape;
      hit.point = hit.point - dot(hit.point - plane.point, plane.normal) * plane.normal;
      hit.geometric = hit.normal = plane.normal;
      break;
    }
    case Kind::Box: {
      const BoxSurface<R>& box = plan.boxes[std::size_t(hit.index)].shape;
      const int axis = hit.face / 2;
      const Vec<R>& corner = hit.face % 2 ? box.max : box.min;
      const R side = hit.face % 2 ? R(1) : R(-1);
      (axis == 0 ? hit.point.x : axis == 1 ? hit.point.y : hit.point.z) = corner[axis];
      hit.geometric = {axis == 0 ? side : R(0), axis == 1 ? side : R(0), axis == 2 ? side : R(0)};
      hit.normal = hit.geometric;
      break;
    }
    case Kind::Triangle: {
      const auto& corners = plan.triangles[std::size_t(hit.index)];
      const TriangleInfo<R>& info = plan.triangle_info[std::size_t(hit.index)];
      hit.point = hit.u * corners[0] + hit.v * corners[1] + hit.w * corners[2];
      hit.geometric = hit.normal = info.normal;
      if (!info.smooth) break;
      hit.normal =
          normalize(hit.u * info.normals[0] + hit.v * info.normals[1] + hit.w * info.normals[2]);
      break;
    }
  }
  if (dot(hit.geometric, ray.direction) > 0) hit.geometric = -hit.geometric;
  if (dot(hit.normal, ray.direction) > 0) hit.normal = -hit.normal;
}

/// What a ray from the eye sees first among the objects that a camera sees.
template <Real R>
Hit<R> closest_hit(const Plan<R>& plan, Ray<R> ray) {
  Hit<R> best;
  const auto offer = [&](Kind kind, R t, int object, int index, int face) {
    if (t > 0 && plan.camera_visible[std::size_t(object)] && comes_before(t, object, index, best)) {
      best.kind = kind, best.t = t, best.object = object, best.index = index, best.face = face;
      return true;
    }
    return false;
  };
  const auto offer_chord = [&](Kind kind, const Chord<R>& chord, int object, int index) {
    if (chord.enter > chord.leave) return;
    if (chord.enter > 0) {
      offer(kind, chord.enter, object, index, chord.enter_face);
    } else {
      offer(kind, chord.leave, object, index, chord.leave_face);
    }
  };
  for (int i = 0; const auto& part : plan.planes) {
    offer(Kind::Plane, intersect(part.shape, ray), part.object, i++, 0);
  }
  for (int i = 0; const auto& part : plan.spheres) {
    offer_chord(Kind::Sphere, intersect(part.shape, ray), part.object, i++);
  }
  for (int i = 0; const auto& part : plan.boxes) {
    offer_chord(Kind::Box, intersect(part.shape, ray), part.object, i++);
  }
  ray.limit = best.t;
  const ShearedRay<R> sheared(ray.direction);
  traverse(plan.bvh, ray, [&](std::uint32_t i) {
    const TriangleHit<R> hit = intersect(plan.triangles[i], ray, sheared);
    if (offer(Kind::Triangle, hit.t, plan.triangle_info[i].object, int(i), 0)) {
      best.u = hit.u, best.v = hit.v, best.w = hit.w;
      ray.limit = best.t;
    }
    return false;
  });
  settle(plan, ray, best);
  return best;
}

/// A ray that leaves the surface of a hit and ends before the lamp: nothing at or behind the lamp
/// is met. Off a triangle it starts above the rounding error of the hit point, so that neighbours
/// are not met either.
template <Real R>
Ray<R> shadow_ray(const Hit<R>& hit, const Incident<R>& light) {
  Ray<R> ray{hit.point, light.direction, light.distance};
  if (hit.kind == Kind::Triangle) {
    const R bound = gamma_bound<R>(16) * max_abs(hit.point);
    ray.origin = hit.point +
                 bound * (dot(hit.geometric, light.direction) < 0 ? -hit.geometric : hit.geometric);
  }
  if (light.distance < std::numeric_limits<R>::infinity()) {
    ray.limit = light.distance - gamma_bound<R>(16) * (max_abs(hit.point) + light.distance);
  }
  return ray;
}

/// How far a ray that starts on a sphere's or box's own surface runs inside it; not positive if it
/// leaves at once.
template <Real R>
R own_exit(const Plan<R>& plan, const Hit<R>& hit, const Ray<R>& ray) {
  if (hit.kind == Kind::Sphere) {
    const Vec<R> outward = hit.point - plan.spheres[std::size_t(hit.index)].shape.center;
    return -2 * dot(outward, ray.direction) / dot(ray.direction, ray.direction);
  }
  const R outward = hit.face % 2 ? ray.direction[hit.face / 2] : -ray.direction[hit.face / 2];
  return outward >= 0 ? R(-1) : intersect(plan.boxes[std::size_t(hit.index)].shape, ray).leave;
}

/// The first object found strictly between a hit and a lamp, not always the nearest: an index into
/// Scene::objects, -1 if there is none. The surface hit is left out where it is flat; where it is a
/// sphere or a box, only its far side can be in the way.
template <Real R>
int first_blocker(const Plan<R>& plan, const Hit<R>& hit, const Incident<R>& light) {
  Ray<R> ray = shadow_ray(hit, light);
  const auto blocks = [&](R t) { return t > 0 && t < ray.limit; };
  const auto chord_blocks = [&](const Chord<R>& chord) {
    return chord.enter <= chord.leave && (blocks(chord.enter) || blocks(chord.leave));
  };
  const auto own = [&](Kind kind, int index) { return hit.kind == kind && hit.index == index; };
  for (int i = 0; const auto& part : plan.spheres) {
    if (own(Kind::Sphere, i) ? blocks(own_exit(plan, hit, ray))
                             : chord_blocks(intersect(part.shape, ray))) {
      return part.object;
    }
    ++i;
  }
  for (int i = 0; const auto& part : plan.boxes) {
    if (own(Kind::Box, i) ? blocks(own_exit(plan, hit, ray))
                          : chord_blocks(intersect(part.shape, ray))) {
      return part.object;
    }
    ++i;
  }
  for (int i = 0; const auto& part : plan.planes) {
    if (!own(Kind::Plane, i) && blocks(intersect(part.shape, ray))) return part.object;
    ++i;
  }
  int blocker = -1;
  const ShearedRay<R> sheared(ray.direction);
  traverse(plan.bvh, ray, [&](std::uint32_t i) {
    if (own(Kind::Triangle, int(i)) || !blocks(intersect(plan.triangles[i], ray, sheared).t)) {
      return false;
    }
    blocker = plan.triangle_info[i].object;
    return true;
  });
  return blocker;
}

/// Whether anything lies strictly between a hit and a lamp.
template <Real R>
bool occluded(const Plan<R>& plan, const Hit<R>& hit, const Incident<R>& light) {
  return first_blocker(plan, hit, light) >= 0;
}

}  // namespace litmus

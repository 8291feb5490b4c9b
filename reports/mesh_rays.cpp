// mesh_rays.cpp: rays from the eye and to the lamp, as a picture has them.
#include "reports/mesh_rays.h"

#include "tracer/camera.h"
#include "tracer/closest.h"
#include "tracer/visibility.h"

namespace litmus {
namespace {

/// Of the way to the lamp, left out at its start: many times the rounding of a float, and less than
/// the triangles' size.
constexpr float kStart = 1e-4f;

FloatRay in_float(const Vec<double>& from, const Vec<double>& along) {
  return {{float(from.x), float(from.y), float(from.z)},
          {float(along.x), float(along.y), float(along.z)}};
}

template <class Visit>
void for_each_ray(const View<double>& view, Visit visit) {
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      visit(camera_ray(view, screen<double>(x, view.width), -screen<double>(y, view.height)));
}

template <class List>
double bytes_of(const List& list) {
  return double(list.size() * sizeof(typename List::value_type));
}

}  // namespace

RaySet primary_rays(const Plan<double>& plan) {
  RaySet set;
  for_each_ray(plan.view, [&](const Ray<double>& ray) {
    set.rays.push_back(in_float(ray.origin, ray.direction));
    set.met += closest_hit<double>(plan, ray).object >= 0;
  });
  return set;
}

RaySet shadow_rays(const Plan<double>& plan) {
  const Lamp<double>& lamp = plan.sources.at(0).lamps.at(0);
  RaySet set;
  for_each_ray(plan.view, [&](const Ray<double>& ray) {
    const Hit<double> hit = closest_hit<double>(plan, ray);
    if (hit.object < 0) return;
    const Incident<double> light = incident(lamp, hit.point);
    if (!(dot(hit.normal, light.direction) > 0 && dot(hit.geometric, light.direction) > 0)) return;
    FloatRay shadow = in_float(hit.point, light.distance * light.direction);
    shadow.from = kStart, shadow.to = 1;
    set.rays.push_back(shadow);
    set.met += first_blocker(plan, hit, light) >= 0;
  });
  return set;
}

double mesh_bytes(const Plan<double>& plan) {
  return bytes_of(plan.triangles) + bytes_of(plan.triangle_info) + bytes_of(plan.bvh.nodes) +
         bytes_of(plan.bvh.blocks);
}

}  // namespace litmus

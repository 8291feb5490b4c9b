// plan.cpp: lowering a scene to what the kernel reads.
#include "tracer/plan.h"

#include <algorithm>

#include "scene/overload.h"

namespace litmus {
namespace {

template <Real R>
Lamp<R> point_lamp(const PointLight& light, const Vec<R>& origin) {
  Lamp<R> lamp;
  lamp.origin = origin;
  lamp.range = R(light.attenuation.range);
  lamp.linear = R(light.attenuation.linear);
  lamp.quadratic = R(light.attenuation.quadratic);
  return lamp;
}

template <Real R>
std::vector<Lamp<R>> lamps_of(const Light& light, const Effects& effects) {
  return std::visit(Overload{
                        [](const DirectionalLight& sun) {
                          Lamp<R> lamp;
                          lamp.directional = true;
                          lamp.toward = -normalize(Vec<R>(sun.direction));
                          return std::vector{lamp};
                        },
                        [](const PointLight& point) {
                          return std::vector{point_lamp(point, Vec<R>(point.origin))};
                        },
                        [](const SpotLight& spot) {
                          Lamp<R> lamp = point_lamp(spot.point, Vec<R>(spot.point.origin));
                          lamp.cone = true;
                          lamp.axis = normalize(Vec<R>(spot.direction));
                          lamp.cutoff = R(spot.cutoff), lamp.exponent = R(spot.exponent);
                          lamp.outside = surely_outside(lamp.cutoff);
                          return std::vector{lamp};
                        },
                        [&](const AreaLight& area) {
                          if (!effects.area) {
                            return std::vector{point_lamp(area.point, Vec<R>(area.point.origin))};
                          }
                          std::vector<Lamp<R>> lamps;
                          for (const Vec<R>& origin : area_samples<R>(area)) {
                            lamps.push_back(point_lamp(area.point, origin));
                          }
                          return lamps;
                        },
                    },
                    light.shape);
}

/// Leaves a lamp the effects that are asked for; everywhere means those it lacks, too, with values
/// that change nothing.
template <Real R>
void set_effects(Lamp<R>& lamp, const Effects& effects) {
  if (!effects.linear) lamp.linear = 0;
  if (!effects.quadratic) lamp.quadratic = 0;
  if (!effects.cone) lamp.cone = false;
  lamp.attenuated = lamp.linear != 0 || lamp.quadratic != 0;
  if (!effects.everywhere) return;
  lamp.everything = lamp.attenuated = true;
  if (lamp.cone) return;
  lamp.cone = true;
  lamp.axis = lamp.directional ? -lamp.toward : Vec<R>{R(0), R(0), R(-1)};
  lamp.cutoff = 4;  // more than any angle
  lamp.exponent = std::numeric_limits<R>::infinity();
}

template <Real R>
void add_triangle(Plan<R>& plan, int object, const std::array<Vec<R>, 3>& corners,
                  const std::array<Vec<R>, 3>* normals) {
  TriangleInfo<R> info;
  info.object = object;
  info.normal = normalize(cross(corners[1] - corners[0], corners[2] - corners[0]));
  if (info.normal == Vec<R>{}) return;
  if (normals) info.normals = *normals, info.smooth = plan.smooth = true;
  plan.triangles.push_back(corners);
  plan.triangle_info.push_back(info);
}

template <Real R>
void add_mesh(Plan<R>& plan, int object, const Mesh& mesh, bool smooth) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array corners{Vec<R>(mesh.vertices[std::size_t(a)]),
                             Vec<R>(mesh.vertices[std::size_t(b)]),
                             Vec<R>(mesh.vertices[std::size_t(c)])};
    if (mesh.normals.empty() || !smooth) {
      add_triangle<R>(plan, object, corners, nullptr);
    } else {
      const std::array normals{normalize(Vec<R>(mesh.normals[std::size_t(a)])),
                               normalize(Vec<R>(mesh.normals[std::size_t(b)])),
                               normalize(Vec<R>(mesh.normals[std::size_t(c)]))};
      add_triangle<R>(plan, object, corners, &normals);
    }
  }
}

template <Real R>
void add_object(Plan<R>& plan, int index, const Object& object, bool smooth) {
  std::visit(Overload{
                 [&](const Sphere& s) {
                   plan.spheres.push_back({{Vec<R>(s.center), R(s.radius)}, index});
                 },
                 [&](const Plane& p) {
                   plan.planes.push_back({{Vec<R>(p.point), normalize(Vec<R>(p.normal))}, index});
                 },
                 [&](const Box& b) {
                   const Vec<R> min(b.min), max(b.max);
                   plan.boxes.push_back({{{min, max}, box_ball(min, max)}, index});
                 },
                 [&](const Triangle& t) {
                   add_triangle<R>(plan, index, {Vec<R>(t.a), Vec<R>(t.b), Vec<R>(t.c)}, nullptr);
                 },
                 [&](const Mesh& m) { add_mesh(plan, index, m, smooth); },
             },
             object.shape);
}

/// The ball around the box of some points.
template <Real R>
Ball<R> ball_of(const std::vector<Lamp<R>>& lamps) {
  if (lamps.empty()) return {};
  Vec<R> min = lamps.front().origin, max = min;
  for (const Lamp<R>& lamp : lamps) {
    const Vec<R>& p = lamp.origin;
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
  return box_ball(min, max);
}

template <Real R>
Finish<R> finish_from(const Material& material, const Effects& effects, bool sample_code) {
  Finish<R> finish{Vec<R>(material.ambient), {}, {}, Exponent<R>(R(material.shininess))};
  if (effects.diffuse) finish.diffuse = Vec<R>(material.diffuse);
  if (effects.specular) finish.specular = Vec<R>(material.specular);
  finish.shiny = finish.specular != Vec<R>{};
  finish.reflects = sample_code || finish.shiny || finish.diffuse != Vec<R>{};
  return finish;
}

template <Real R>
View<R> view_of(const Scene& scene) {
  using std::tan;
  const Camera& camera = scene.camera;
  const R aspect = R(scene.width) / R(scene.height);
  const R half_height = camera.projection == Projection::Orthographic ? R(camera.height) / 2
                                                                      : R(tan(R(camera.fov) / 2));
  View<R> view{camera.projection == Projection::Orthographic,
               Vec<R>(camera.eye),
               {},
               {},
               {},
               scene.width,
               scene.height,
               scene.samples};
  view.forward = normalize(Vec<R>(camera.target) - view.eye);
  const Vec<R> right = normalize(cross(view.forward, Vec<R>(camera.up)));
  view.right = (half_height * aspect) * right;
  view.up = half_height * cross(right, view.forward);
  return view;
}

}  // namespace

template <Real R>
Plan<R> lower(const Scene& scene, const Effects& effects) {
  Plan<R> plan;
  plan.view = view_of<R>(scene);
  if (!effects.supersampling) plan.view.samples = 1;
  plan.shadows = scene.shadows && effects.shadows;
  plan.idle_shadows = effects.shadows && effects.everywhere && !plan.shadows;
  plan.specular = effects.specular;
  plan.everything = effects.everywhere;
  plan.sample_code = scene.shading == Shading::SampleCode;
  if (effects.ambient) plan.ambient = Vec<R>(scene.ambient);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    add_object(plan, int(i), object, effects.smooth_normals);
    plan.camera_visible.push_back(object.camera_visible);
    plan.finishes.push_back(
        finish_from<R>(scene.materials[std::size_t(object.material)], effects, plan.sample_code));
  }
  std::vector<int> objects;
  for (const TriangleInfo<R>& info : plan.triangle_info) objects.push_back(info.object);
  plan.bvh = build_bvh(plan.triangles, objects);
  if (!plan.triangles.empty()) {
    plan.mesh_ball = box_ball(plan.bvh.min, plan.bvh.max);
  }
  for (const Light& light : scene.lights) {
    const R intensity(light.intensity);
    Source<R> source{
        {}, R(1), intensity * Vec<R>(light.diffuse), intensity * Vec<R>(light.specular)};
    // The sample code adds ambient light for each light in view, one of intensity 0 included.
    if (light.intensity != 0 || plan.sample_code) source.lamps = lamps_of<R>(light, effects);
    for (Lamp<R>& lamp : source.lamps) set_effects(lamp, effects);
    source.ball = ball_of(source.lamps);
    if (source.lamps.size() > 1) source.weight = 1 / R(double(source.lamps.size()));
    if (!plan.sample_code && effects.ambient) {
      plan.ambient = plan.ambient + intensity * Vec<R>(light.ambient);
    }
    plan.sources.push_back(std::move(source));
  }
  return plan;
}

template Plan<float> lower(const Scene&, const Effects&);
template Plan<double> lower(const Scene&, const Effects&);
template Plan<long double> lower(const Scene&, const Effects&);
template Plan<Quad> lower(const Scene&, const Effects&);

}  // namespace litmus

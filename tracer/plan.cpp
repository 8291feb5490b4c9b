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
  lamp.attenuated = lamp.linear != 0 || lamp.quadratic != 0;
  return lamp;
}

template <Real R>
std::vector<Lamp<R>> lamps_of(const Light& light) {
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
                          return std::vector{lamp};
                        },
                        [](const AreaLight& area) {
                          std::vector<Lamp<R>> lamps;
                          for (const Vec<R>& origin : area_samples<R>(area)) {
                            lamps.push_back(point_lamp(area.point, origin));
                          }
                          return lamps;
                        },
                    },
                    light.shape);
}

template <Real R>
void add_triangle(Plan<R>& plan, int object, const std::array<Vec<R>, 3>& corners,
                  const std::array<Vec<R>, 3>* normals) {
  TriangleInfo<R> info;
  info.object = object;
  info.normal = normalize(cross(corners[1] - corners[0], corners[2] - corners[0]));
  if (info.normal == Vec<R>{}) return;
  if (normals) info.normals = *normals, info.smooth = true;
  plan.triangles.push_back(corners);
  plan.triangle_info.push_back(info);
}

template <Real R>
void add_mesh(Plan<R>& plan, int object, const Mesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array corners{Vec<R>(mesh.vertices[std::size_t(a)]),
                             Vec<R>(mesh.vertices[std::size_t(b)]),
                             Vec<R>(mesh.vertices[std::size_t(c)])};
    if (mesh.normals.empty()) {
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
void add_object(Plan<R>& plan, int index, const Object& object) {
  std::visit(Overload{
                 [&](const Sphere& s) {
                   plan.spheres.push_back({{Vec<R>(s.center), R(s.radius)}, index});
                 },
                 [&](const Plane& p) {
                   plan.planes.push_back({{Vec<R>(p.point), normalize(Vec<R>(p.normal))}, index});
                 },
                 [&](const Box& b) {
                   plan.boxes.push_back({{Vec<R>(b.min), Vec<R>(b.max)}, index});
                 },
                 [&](const Triangle& t) {
                   add_triangle<R>(plan, index, {Vec<R>(t.a), Vec<R>(t.b), Vec<R>(t.c)}, nullptr);
                 },
                 [&](const Mesh& m) { add_mesh(plan, index, m); },
             },
             object.shape);
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
Plan<R> lower(const Scene& scene) {
  Plan<R> plan;
  plan.view = view_of<R>(scene);
  plan.shadows = scene.shadows;
  plan.sample_code = scene.shading == Shading::SampleCode;
  plan.ambient = Vec<R>(scene.ambient);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const Material& material = scene.materials[std::size_t(object.material)];
    add_object(plan, int(i), object);
    plan.camera_visible.push_back(object.camera_visible);
    plan.finishes.push_back({Vec<R>(material.ambient), Vec<R>(material.diffuse),
                             Vec<R>(material.specular), R(material.shininess),
                             material.specular != Color(0)});
  }
  plan.bvh = build_bvh(plan.triangles);
  for (const Light& light : scene.lights) {
    const R intensity(light.intensity);
    Source<R> source{
        {}, R(1), intensity * Vec<R>(light.diffuse), intensity * Vec<R>(light.specular)};
    if (light.intensity != 0) source.lamps = lamps_of<R>(light);
    if (source.lamps.size() > 1) source.weight = 1 / R(double(source.lamps.size()));
    if (!plan.sample_code) plan.ambient = plan.ambient + intensity * Vec<R>(light.ambient);
    plan.sources.push_back(std::move(source));
  }
  return plan;
}

template Plan<float> lower(const Scene&);
template Plan<double> lower(const Scene&);
template Plan<long double> lower(const Scene&);
template Plan<Quad> lower(const Scene&);

}  // namespace litmus

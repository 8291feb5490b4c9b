// hostile_scenes.cpp: lights at the limits of their parameters, over surfaces at theirs.
#include "stress/hostile_scenes.h"

#include <numbers>

namespace litmus {
namespace {

using std::numbers::pi;

struct Named {
  const char* name;
  decltype(Light::shape) shape;
  double intensity = 1;
};

PointLight bulb(const Point& origin, double range = 1, double linear = 0, double quadratic = 0) {
  return {origin, {range, linear, quadratic}};
}

SpotLight spot(double cutoff, double exponent, const Point& origin = {0, 0, 2}) {
  return {bulb(origin), -origin, cutoff, exponent};
}

AreaLight panel(const Point& origin, const Vector& normal, double size, int columns, int rows) {
  AreaLight area;
  area.point = bulb(origin), area.normal = normal;
  area.width = area.height = size, area.columns = columns, area.rows = rows;
  return area;
}

std::vector<Named> hostile_lights() {
  const Point skew{0.3, 0.7, 1.9};
  return {
      {"spot straight above its centre", spot(0.4, 3)},
      {"spot with a skew axis", spot(0.7, 1, skew)},
      {"spot of 0.1 degrees", spot(0.1 * pi / 180, 1)},
      {"spot with exponent 0", spot(0.4, 0)},
      {"spot with exponent 1e-6", spot(0.4, 1e-6)},
      {"spot with exponent 1e6", spot(0.4, 1e6)},
      {"spot with exponent 1e30", spot(0.4, 1e30)},
      {"spot of 90 degrees", spot(pi / 2, 2)},
      {"spot of 120 degrees", spot(pi * 2 / 3, 2)},
      {"spot of 180 degrees", spot(pi, 0.5)},
      {"spot on the floor", spot(0.4, 2, {0, 0, 0x1p-1000})},
      {"light on a point that is seen", bulb({0, 0, 0}, 1, 1, 1)},
      {"light 1e-30 above a point that is seen", bulb({0, 0, 1e-30}, 1, 1, 1)},
      {"light 1e-200 above a point that is seen", bulb({0, 0, 1e-200}, 1, 0, 1)},
      {"light at the centre of the sphere", bulb({0.8, 0.6, 0.7}, 1, 0, 1)},
      {"light at the eye", bulb({0, 0, 10})},
      {"light 1e30 away", bulb({1e29, 2e29, 1e30}, 1, 1, 1)},
      {"range 1e-30", bulb({0, 0, 2}, 1e-30, 1, 1)},
      {"range 1e30", bulb({0, 0, 2}, 1e30, 1, 1)},
      {"coefficients 1e38", bulb({0, 0, 2}, 1, 1e38, 1e38)},
      {"coefficients 1e-38", bulb({0, 0, 2}, 1, 1e-38, 1e-38)},
      {"coefficient 1e38 on a point that is seen", bulb({0, 0, 0}, 1, 0, 1e38)},
      {"intensity 1e-45", bulb({0, 0, 2}), 1e-45},
      {"intensity 1e37", bulb({0, 0, 2}), 1e37},
      {"sun along the floor", DirectionalLight{{1, 0, 0}}},
      {"sun from below", DirectionalLight{{0, 0, 1}}},
      {"sun of length 1e-90", DirectionalLight{{1e-91, 0, -1e-90}}},
      {"sun straight into the eye", DirectionalLight{{0, 0, -1}}},
      {"area light straight overhead", panel({0, 0, 2}, {0, 0, -1}, 1, 3, 2)},
      {"area light almost overhead", panel({0, 0, 2}, {1e-300, 0, -1}, 1, 3, 2)},
      {"area light of one sample", panel({0, 0, 2}, {0, 0, -1}, 1, 1, 1)},
      {"area light of size 0", panel({0, 0, 2}, {0, 1, -1}, 0, 3, 3)},
      {"area light through the floor", panel({0, 0, 0}, {1, 0, 0}, 2, 3, 3)},
      {"line of lights", panel({0, 0, 2}, {0, 0, -1}, 1, 1, 9)},
  };
}

/// Shares vertices and normals; its normals disagree with its faces.
Mesh smooth_roof() {
  return {{{-2, -2, 0.1}, {-0.5, -2, 0.1}, {-0.5, -0.8, 1}, {-2, -0.8, 0.6}},
          {{0, 0, 1}, {1, 0, 0.01}, {0, -1, 0.2}, {-1, 0, 0.1}},
          {{0, 1, 2}, {0, 2, 3}}};
}

/// Everything seen from above, or from inside the sphere, or along the floor.
std::vector<Camera> hostile_cameras() {
  Camera above;
  above.projection = Projection::Orthographic;
  above.eye = {0, 0, 10}, above.up = {0, 1, 0}, above.height = 5;
  Camera inside;
  inside.eye = {0.8, 0.6, 0.7}, inside.target = {0, 0, 0.5}, inside.fov = 2.5;
  Camera along;
  along.eye = {-5, 0, 0x1p-40}, along.target = {0, 0, 0x1p-40}, along.fov = 0.8;
  return {above, inside, along};
}

Scene stage() {
  Scene scene;
  scene.width = scene.height = 17;  // odd: one ray meets the origin
  scene.ambient = Color(0.1);
  for (const double shininess : {0.0, 7.3, 1e6, 1.0})
    scene.materials.push_back({"gloss", Color(1), Color(0.6), Color(0.4), shininess});
  scene.objects.push_back({"floor", Plane{}, 0, true});
  scene.objects.push_back({"ball", Sphere{{0.8, 0.6, 0.7}, 0.5}, 2, true});
  scene.objects.push_back({"block", Box{{-1.5, 0.5, 0}, {-0.7, 1.5, 0.8}}, 1, true});
  scene.objects.push_back({"roof", smooth_roof(), 3, true});
  scene.objects.push_back(
      {"sliver", Triangle{{1, -1, 0.3}, {2, -1, 0.3}, {1.5, -1 + 1e-9, 0.3}}, 1, true});
  return scene;
}

}  // namespace

std::vector<Scene> hostile_scenes() {
  std::vector<Scene> scenes;
  for (const Named& named : hostile_lights()) {
    for (const Camera& camera : hostile_cameras()) {
      for (const Shading shading : {Shading::Equation, Shading::SampleCode}) {
        Scene scene = stage();
        scene.name = named.name, scene.camera = camera, scene.shading = shading;
        Light light;
        light.name = named.name, light.shape = named.shape, light.intensity = named.intensity;
        scene.lights.push_back(light);
        scenes.push_back(std::move(scene));
      }
    }
  }
  return scenes;
}

}  // namespace litmus

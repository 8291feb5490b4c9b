// json.cpp: the resolved scene as JSON.
#include "exporters/json.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>

#include "exporters/area_grid.h"
#include "scene/overload.h"
#include "exporters/text.h"

namespace litmus {
namespace {

using Json = nlohmann::ordered_json;

Json triple(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

/// hypot neither overflows nor underflows where squares do.
Vector unit(const Vector& v) { return v / std::hypot(v.x, v.y, v.z); }

template <class T>
Json triples(const std::vector<T>& list) {
  Json array = Json::array();
  for (const T& each : list) array.push_back(Json::array({each[0], each[1], each[2]}));
  return array;
}

// ---- The parts of the scene ------------------------------------------------------------------

Json camera_json(const Scene& scene) {
  const Camera& camera = scene.camera;
  const bool flat = camera.projection == Projection::Orthographic;
  const Vector forward = unit(camera.target - camera.eye);
  // Unit factors: the product of two very long or short vectors is not representable.
  const Vector right = unit(glm::cross(forward, unit(camera.up)));
  const double half_height = flat ? camera.height / 2 : std::tan(camera.fov / 2);
  return {{"projection", flat ? "orthographic" : "perspective"},
          {"eye", triple(camera.eye)},
          {"forward", triple(forward)},
          {"right", triple(right)},
          {"up", triple(glm::cross(right, forward))},
          {"half_width", half_height * scene.width / scene.height},
          {"half_height", half_height}};
}

/// Ia of slide 5. The sample code knows no ambient colour of a light.
Color ambient_of(const Scene& scene) {
  Color sum = scene.ambient;
  if (scene.shading == Shading::Equation)
    for (const Light& light : scene.lights) sum += light.intensity * light.ambient;
  return sum;
}

Json material_json(const Material& m) {
  return {{"name", m.name},
          {"ambient", triple(m.ambient)},
          {"diffuse", triple(m.diffuse)},
          {"specular", triple(m.specular)},
          {"shininess", m.shininess}};
}

Json mesh_json(const Mesh& mesh) {
  return {{"shape", "mesh"},
          {"vertices", triples(mesh.vertices)},
          {"normals", triples(mesh.normals)},
          {"triangles", triples(mesh.triangles)}};
}

Json object_json(const Object& object) {
  Json json = std::visit(
      Overload{
          [](const Sphere& s) {
            return Json{{"shape", "sphere"}, {"center", triple(s.center)}, {"radius", s.radius}};
          },
          [](const Plane& p) {
            return Json{
                {"shape", "plane"}, {"point", triple(p.point)}, {"normal", triple(unit(p.normal))}};
          },
          [](const Box& b) {
            return Json{{"shape", "box"}, {"min", triple(b.min)}, {"max", triple(b.max)}};
          },
          [](const Triangle& t) {
            return mesh_json({{t.a, t.b, t.c}, {}, {{0, 1, 2}}});
          },
          [](const Mesh& m) { return mesh_json(m); },
      },
      object.shape);
  json["name"] = object.name;
  json["material"] = object.material;
  json["camera_visible"] = object.camera_visible;
  return json;
}

Json positional(const PointLight& light, const std::vector<Point>& points) {
  return {{"points", triples(points)},
          {"share", 1 / double(points.size())},
          {"range", light.attenuation.range},
          {"linear", light.attenuation.linear},
          {"quadratic", light.attenuation.quadratic}};
}

Json light_json(const Light& light) {
  Json json{{"name", light.name},
            {"type", light_type(light)},
            {"diffuse", triple(light.intensity * light.diffuse)},
            {"specular", triple(light.intensity * light.specular)}};
  json.update(
      std::visit(Overload{
                     [](const DirectionalLight& d) {
                       return Json{{"direction", triple(unit(d.direction))}};
                     },
                     [](const PointLight& p) { return positional(p, {p.origin}); },
                     [](const SpotLight& s) {
                       Json spot = positional(s.point, {s.point.origin});
                       spot["direction"] = triple(unit(s.direction));
                       spot["cutoff_radians"] = s.cutoff;
                       spot["cutoff_degrees"] = s.cutoff * 180 / std::numbers::pi;
                       spot["exponent"] = s.exponent;
                       return spot;
                     },
                     [](const AreaLight& a) { return positional(a.point, area_samples(a)); },
                 },
                 light.shape));
  return json;
}

template <class T, class Convert>
Json list(const std::vector<T>& items, const Convert& convert) {
  Json array = Json::array();
  for (const T& item : items) array.push_back(convert(item));
  return array;
}

// ---- Text ------------------------------------------------------------------------------------

/// Objects over several lines, a triple on one; numbers as in text.h.
void print(const Json& value, const std::string& indent, std::ostream& out) {
  const std::string inner = indent + "  ";
  if (value.is_number_float()) {
    out << number(value.get<double>());
  } else if (value.is_object()) {
    const char* separator = "{";
    for (const auto& [key, member] : value.items()) {
      out << separator << '\n' << inner << Json(key).dump() << ": ";
      print(member, inner, out);
      separator = ",";
    }
    out << '\n' << indent << '}';
  } else if (value.is_array()) {
    const bool on_one_line =
        std::all_of(value.begin(), value.end(), [](const Json& each) { return each.is_number(); });
    out << '[';
    for (std::size_t i = 0; i < value.size(); ++i) {
      out << (i == 0 ? "" : on_one_line ? ", " : ",");
      if (!on_one_line) out << '\n' << inner;
      print(value[i], inner, out);
    }
    if (!on_one_line) out << '\n' << indent;
    out << ']';
  } else {
    out << value.dump(-1, ' ', true, Json::error_handler_t::replace);
  }
}

}  // namespace

void write_scene_json(const Scene& scene, std::ostream& out) {
  const Json json{
      {"litmus_scene", kSceneJsonVersion},
      {"name", scene.name},
      {"about", scene.about},
      {"image", {{"width", scene.width}, {"height", scene.height}, {"samples", scene.samples}}},
      {"camera", camera_json(scene)},
      {"ambient", triple(ambient_of(scene))},
      {"shadows", scene.shadows},
      {"shading", scene.shading == Shading::Equation ? "equation" : "sample-code"},
      {"materials", list(scene.materials, material_json)},
      {"objects", list(scene.objects, object_json)},
      {"lights", list(scene.lights, light_json)},
  };
  print(json, "", out);
  out << '\n';
}

}  // namespace litmus

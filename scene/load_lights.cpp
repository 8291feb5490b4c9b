// load_lights.cpp: one [[light]] of a scene file (slides 6-20).
#include <fmt/format.h>

#include <numbers>

#include "scene/load_parts.h"

namespace litmus {
namespace {

constexpr Range kCutoff{0, false, "degrees in (0, 180]", 180, true};

Attenuation read_attenuation(const Fields& fields) {
  Attenuation attenuation;
  attenuation.range = fields.number("range", kPositive, attenuation.range);
  attenuation.linear = fields.number("linear", kNotNegative, attenuation.linear);
  attenuation.quadratic = fields.number("quadratic", kNotNegative, attenuation.quadratic);
  return attenuation;
}

PointLight read_point(const Fields& fields) {
  return {fields.point("origin"), read_attenuation(fields)};
}

SpotLight read_spot(const Fields& fields) {
  SpotLight spot;
  spot.point = read_point(fields);
  spot.direction = fields.direction("direction");
  spot.cutoff = fields.number("cutoff_degrees", kCutoff) * (std::numbers::pi / 180);
  spot.exponent = fields.number("exponent", kNotNegative, spot.exponent);
  return spot;
}

/// The rectangle must have a normal (slide 20), and its own right must not point along it.
void check_frame(const Fields& fields, const AreaLight& area) {
  if (!area.normal && !normalizable(area.point.origin))
    fields.refuse("normal",
                  "missing, and a light at [0, 0, 0] has no direction to the origin; give normal = "
                  "[x, y, z]");
  const Vector normal = area.normal.value_or(-area.point.origin);
  if (area.right && nearly_parallel(normal, *area.right))
    fields.refuse("right", "must not be parallel to the light's normal");
}

AreaLight read_area(const Fields& fields) {
  AreaLight area;
  area.point = read_point(fields);
  if (fields.has("normal")) area.normal = fields.direction("normal");
  if (fields.has("right")) area.right = fields.direction("right");
  check_frame(fields, area);
  area.width = fields.number("width", kNotNegative);
  area.height = fields.number("height", kNotNegative);
  area.columns = fields.integer("columns", 1, kMostLightSamples);
  area.rows = fields.integer("rows", 1, kMostLightSamples);
  if (area.columns * area.rows > kMostLightSamples)
    fields.refuse(
        "rows", fmt::format("columns * rows must be at most {}, not {} * {} = {}",
                            kMostLightSamples, area.columns, area.rows, area.columns * area.rows));
  if (fields.has("placement"))
    area.placement = fields.choice<Placement>(
        "placement", {{"centres", Placement::Centres}, {"corners", Placement::Corners}});
  return area;
}

/// `color` is short for diffuse and specular alike.
void read_colors(const Fields& fields, Light& light) {
  if (fields.has("color")) {
    for (const char* other : {"diffuse", "specular"})
      if (fields.has(other))
        fields.refuse("color", fmt::format("stands for diffuse and specular; give either color or "
                                           "{}, not both",
                                           other));
    light.diffuse = light.specular = fields.color("color", light.diffuse);
  }
  light.diffuse = fields.color("diffuse", light.diffuse);
  light.specular = fields.color("specular", light.specular);
  light.ambient = fields.color("ambient", light.ambient);
}

}  // namespace

Light read_light(const Fields& fields) {
  enum class Type { Directional, Point, Spot, Area };
  Light light;
  switch (fields.choice<Type>("type", {{"directional", Type::Directional},
                                       {"point", Type::Point},
                                       {"spot", Type::Spot},
                                       {"area", Type::Area}})) {
    case Type::Directional:
      fields.only(
          {"name", "type", "intensity", "color", "diffuse", "specular", "ambient", "direction"});
      light.shape = DirectionalLight{fields.direction("direction")};
      break;
    case Type::Point:
      fields.only({"name", "type", "intensity", "color", "diffuse", "specular", "ambient", "origin",
                   "range", "linear", "quadratic"});
      light.shape = read_point(fields);
      break;
    case Type::Spot:
      fields.only({"name", "type", "intensity", "color", "diffuse", "specular", "ambient", "origin",
                   "range", "linear", "quadratic", "direction", "cutoff_degrees", "exponent"});
      light.shape = read_spot(fields);
      break;
    case Type::Area:
      fields.only({"name", "type", "intensity", "color", "diffuse", "specular", "ambient", "origin",
                   "range", "linear", "quadratic", "normal", "right", "width", "height", "columns",
                   "rows", "placement"});
      light.shape = read_area(fields);
      break;
  }
  light.intensity = fields.number("intensity", kNotNegative, light.intensity);
  read_colors(fields, light);
  return light;
}

}  // namespace litmus

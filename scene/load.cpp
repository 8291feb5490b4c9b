// load.cpp: a scene file to a Scene. The tables' contents are read by load_shapes and load_lights.
#include "scene/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "scene/expect.h"
#include "scene/load_parts.h"
#include "scene/words.h"

namespace litmus {
namespace {

/// The names given so far in one kind of table. Those not given are "sphere-1", "sphere-2", ...
class Names {
 public:
  /// The table's name, or the next default for its kind; refuses one that is taken.
  std::string next(const Fields& fields, const std::string& kind) {
    const std::string fallback = fmt::format("{}-{}", kind, ++counts_[kind]);
    const std::string name = fields.text("name", fallback);
    const auto [taken, is_new] = lines_.emplace(name, fields.place("name").line);
    if (!is_new)
      fields.refuse("name", fmt::format("\"{}\" is already the name of the one in line {}; names "
                                        "must differ",
                                        name, taken->second));
    return name;
  }

 private:
  std::map<std::string, int> counts_;
  std::map<std::string, std::uint32_t> lines_;
};

void check_schema(const Fields& fields) {
  const Node* schema = fields.find("schema");
  if (!schema) fields.refuse_missing("schema", "1: begin the file with schema = 1");
  const auto* version = std::get_if<std::int64_t>(&schema->value);
  if (!version || *version != 1) fields.refuse_value("schema", *schema, "1");
}

void read_image(const Fields& fields, Scene& scene) {
  fields.only({"width", "height", "samples"});
  scene.width = fields.integer("width", 1, kLargestSide);
  scene.height = fields.integer("height", 1, kLargestSide);
  scene.samples = fields.integer("samples", 1, kMostSamples, 1);
}

std::vector<Oracle> read_expect(const Fields& fields) {
  fields.only({"oracles"});
  std::vector<std::string> known;
  for (const OracleName& each : oracle_names()) known.emplace_back(each.name);
  std::vector<Oracle> oracles;
  for (const std::string& word : fields.texts("oracles")) {
    const auto at = std::find(known.begin(), known.end(), word);
    if (at == known.end())
      fields.refuse("oracles",
                    fmt::format("there is no closed form \"{}\"{} There are: {}", word,
                                near_words(word, known).empty() ? "." : suggestion(word, known),
                                listed(known)));
    const Oracle oracle = oracle_names()[std::size_t(at - known.begin())].oracle;
    if (std::find(oracles.begin(), oracles.end(), oracle) != oracles.end())
      fields.refuse("oracles", fmt::format("\"{}\" is listed twice", word));
    oracles.push_back(oracle);
  }
  if (oracles.empty())
    fields.refuse_missing("oracles", "a list of closed forms; leave [expect] out where none holds");
  return oracles;
}

Material read_material(const Fields& fields) {
  fields.only({"name", "ambient", "diffuse", "specular", "shininess"});
  Material material;
  material.name = fields.text("name");
  material.ambient = fields.color("ambient", material.ambient);
  material.diffuse = fields.color("diffuse", material.diffuse);
  material.specular = fields.color("specular", material.specular);
  material.shininess = fields.number("shininess", kNotNegative, material.shininess);
  return material;
}

int find_material(const Fields& fields, const std::vector<Material>& materials) {
  const std::string name = fields.text("material");
  std::vector<std::string> names;
  for (const Material& material : materials) names.push_back(material.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    fields.refuse("material",
                  fmt::format("no [[material]] is named \"{}\"{} Named: {}", name,
                              near_words(name, names).empty() ? "." : suggestion(name, names),
                              listed(names)));
  return int(found - names.begin());
}

/// Reads one object; adds it unless none of its triangles has an area.
void read_object(const Fields& fields, Names& names, std::int64_t& room, Scene& scene) {
  std::int64_t dropped = 0;
  Object object;
  object.shape = read_shape(fields, room, dropped);
  object.name = names.next(fields, fields.text("shape"));
  object.material = find_material(fields, scene.materials);
  object.camera_visible = fields.boolean("camera_visible", true);
  if (dropped)
    scene.warnings.push_back(fmt::format(
        "{}:{}:{}: object \"{}\": dropped {} triangle{} without area", scene.file.string(),
        fields.place().line, fields.place().column, object.name, dropped, dropped == 1 ? "" : "s"));
  const std::int64_t count = primitives(object);
  if (count == 0 || (dropped && std::holds_alternative<Triangle>(object.shape))) return;
  room -= count;
  scene.objects.push_back(std::move(object));
}

Light read_named_light(const Fields& fields, Names& names) {
  Light light = read_light(fields);
  light.name = names.next(fields, std::string(light_type(light)));
  if (light.name == "ambient" || light.name == "all")
    fields.refuse("name",
                  fmt::format("\"{}\" is reserved for reports; choose another name", light.name));
  return light;
}

}  // namespace

Camera read_camera(const Fields& fields) {
  const bool perspective =
      fields.choice<bool>("projection", {{"perspective", true}, {"orthographic", false}});
  if (perspective)
    fields.only({"projection", "eye", "target", "up", "fov_degrees"});
  else
    fields.only({"projection", "eye", "target", "up", "height"});
  Camera camera;
  camera.projection = perspective ? Projection::Perspective : Projection::Orthographic;
  camera.eye = fields.point("eye");
  camera.target = fields.point("target");
  camera.up = fields.direction("up", camera.up);
  if (perspective)
    camera.fov = fields.number("fov_degrees",
                               {0, false, "degrees within 0..180, both excluded", 180, false}) *
                 (std::numbers::pi / 180);
  else
    camera.height = fields.number("height", kPositive);
  if (!normalizable(camera.target - camera.eye))
    fields.refuse("target", "must lie away from eye, at a distance within 1e-100..1e100");
  if (nearly_parallel(camera.target - camera.eye, camera.up))
    fields.refuse(
        fields.has("up") ? "up" : "target",
        "up must not be parallel to the line from eye to target; give another up, such as "
        "[0, 1, 0]");
  return camera;
}

Scene load_scene(const std::filesystem::path& file) {
  const Node document = read_document(file);
  const Fields root(file, document, "a scene");
  check_schema(root);
  root.only({"schema", "about", "tags", "ambient", "shadows", "shading", "expect", "bands", "spectra",
             "image", "camera", "material", "object", "light"});
  Scene scene;
  scene.name = file.stem().string();
  scene.file = file;
  scene.about = root.text("about", "");
  scene.tags = root.texts("tags");
  scene.ambient = root.color("ambient", scene.ambient);
  scene.shadows = root.boolean("shadows", true);
  if (root.has("shading"))
    scene.shading = root.choice<Shading>(
        "shading", {{"equation", Shading::Equation}, {"sample-code", Shading::SampleCode}});

  if (root.has("expect"))
    scene.expect = read_expect(Fields(file, *root.find("expect"), "[expect]"));

  for (const char* section : {"image", "camera"})
    if (!root.has(section))
      root.refuse_missing(section, fmt::format("a table headed [{}]", section));
  read_image(Fields(file, *root.find("image"), "[image]"), scene);
  scene.camera = read_camera(Fields(file, *root.find("camera"), "[camera]"));

  Names materials, objects, lights;
  for (const Node& node : root.tables("material")) {
    const Fields fields(file, node, "a material");
    scene.materials.push_back(read_material(fields));
    materials.next(fields, "material");
  }
  std::int64_t room = kMostPrimitives;
  for (const Node& node : root.tables("object"))
    read_object(Fields(file, node, "an object"), objects, room, scene);
  for (const Node& node : root.tables("light"))
    scene.lights.push_back(read_named_light(Fields(file, node, "a light"), lights));
  read_spectra(root, scene);
  return scene;
}

}  // namespace litmus

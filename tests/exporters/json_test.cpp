// json_test.cpp: the resolved scene, by hand and by its schema.
#include "exporters/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "scene/load.h"
#include "tests/json_schema.h"

namespace litmus {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::IsEmpty;
using testing::StartsWith;

std::string text_of(const Scene& scene) {
  std::ostringstream out;
  write_scene_json(scene, out);
  return out.str();
}

json exported(const Scene& scene) { return json::parse(text_of(scene)); }

std::vector<std::string> schema_errors(const json& scene) {
  return schema_mismatches("exporters/scene.schema.json", scene);
}

/// One object of each kind under one light of each type.
Scene full_scene() {
  Scene scene;
  scene.name = "full";
  scene.camera.eye = {0, -8, 0};
  scene.materials.push_back({"plain", Color(1), Color(0.5), Color(0.25), 20});
  scene.objects.push_back({"floor", Plane{{0, 0, 0}, {0, 0, 5}}, 0, true});
  scene.objects.push_back({"ball", Sphere{{0, 0, 1}, 1}, 0, true});
  scene.objects.push_back({"crate", Box{{1, 1, 0}, {2, 2, 1}}, 0, false});
  scene.objects.push_back({"sail", Triangle{{-2, 0, 0}, {-1, 0, 0}, {-1, 0, 2}}, 0, true});
  scene.lights.push_back({.name = "sun", .shape = DirectionalLight{{0, 0, -3}}});
  scene.lights.push_back({.name = "lamp", .shape = PointLight{{0, 0, 4}, {3, 0.5, 0.25}}});
  scene.lights.push_back(
      {.name = "spot", .shape = SpotLight{{{0, 0, 4}, {}}, {0, 0, -2}, std::numbers::pi / 6, 3}});
  AreaLight panel;
  panel.point.origin = {0, 0, 4};
  panel.columns = 2;
  panel.width = 2;
  scene.lights.push_back({.name = "panel", .shape = panel});
  return scene;
}

class CanonicalExport : public testing::TestWithParam<Scene> {};

TEST_P(CanonicalExport, SatisfiesTheSchema) {
  EXPECT_THAT(schema_errors(exported(GetParam())), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Json, CanonicalExport, testing::ValuesIn(load_canonical_scenes().scenes),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           std::erase(name, '-');
                           return name;
                         });

TEST(SceneSchema, RefusesWhatIsMissingUnknownOrOutOfRange) {
  const json good = exported(full_scene());
  ASSERT_THAT(schema_errors(good), IsEmpty());
  json bad = good;
  bad["lights"][2].erase("cutoff_radians");
  EXPECT_THAT(schema_errors(bad),
              Contains("<root>[lights][2]: Missing required property 'cutoff_radians'."));
  bad = good;
  bad["objects"][1]["radius"] = 0;
  EXPECT_THAT(schema_errors(bad),
              Contains("<root>[objects][1][radius]: Expected number greater than 0.000000"));
  bad = good;
  bad["shadows"] = 1;
  EXPECT_THAT(schema_errors(bad),
              Contains("<root>[shadows]: Value type not permitted by 'type' constraint."));
  bad = good;
  bad["camera"]["fov"] = 40;
  EXPECT_THAT(schema_errors(bad), Contains(StartsWith("<root>[camera]: Object contains")));
  bad = good;
  bad["lights"][3]["points"] = json::array();
  EXPECT_THAT(
      schema_errors(bad),
      Contains("<root>[lights][3][points]: Array should contain no fewer than 1 elements."));
}

TEST(SceneJson, HasUnitVectors) {
  const json scene = exported(full_scene());
  EXPECT_EQ(scene["camera"]["forward"], json({0, 1, 0}));
  EXPECT_EQ(scene["camera"]["right"], json({1, 0, 0}));
  EXPECT_EQ(scene["camera"]["up"], json({0, 0, 1}));
  EXPECT_EQ(scene["objects"][0]["normal"], json({0, 0, 1}));
  EXPECT_EQ(scene["lights"][0]["direction"], json({0, 0, -1}));
  EXPECT_EQ(scene["lights"][2]["direction"], json({0, 0, -1}));
}

TEST(SceneJson, SpansThePictureByHalfItsSides) {
  Scene scene = full_scene();
  scene.width = 200, scene.height = 100;
  EXPECT_DOUBLE_EQ(exported(scene)["camera"]["half_height"], std::tan(scene.camera.fov / 2));
  EXPECT_DOUBLE_EQ(exported(scene)["camera"]["half_width"], 2 * std::tan(scene.camera.fov / 2));
  scene.camera.projection = Projection::Orthographic;
  scene.camera.height = 3;
  EXPECT_EQ(exported(scene)["camera"]["half_height"], 1.5);
  EXPECT_EQ(exported(scene)["camera"]["half_width"], 3);
}

TEST(SceneJson, MultipliesColoursByTheIntensityAndAddsUpAmbientLight) {
  Scene scene = full_scene();
  scene.ambient = Color(0.125);
  scene.lights[0].intensity = 2;
  scene.lights[0].diffuse = Color(0.25, 0.5, 1);
  scene.lights[0].ambient = Color(0.5);
  EXPECT_EQ(exported(scene)["lights"][0]["diffuse"], json({0.5, 1, 2}));
  EXPECT_EQ(exported(scene)["ambient"], json({1.125, 1.125, 1.125}));
  scene.shading = Shading::SampleCode;
  EXPECT_EQ(exported(scene)["ambient"], json({0.125, 0.125, 0.125}));
}

TEST(SceneJson, ListsThePointsOfAnAreaLight) {
  const json panel = exported(full_scene())["lights"][3];
  EXPECT_EQ(panel["points"], json({{-0.5, 0, 4}, {0.5, 0, 4}}));
  EXPECT_EQ(panel["share"], 0.5);
}

TEST(SceneJson, GivesTheCutoffInBothUnits) {
  const json spot = exported(full_scene())["lights"][2];
  EXPECT_EQ(spot["cutoff_radians"].get<double>(), std::numbers::pi / 6);
  EXPECT_NEAR(spot["cutoff_degrees"], 30, 1e-13);
}

TEST(SceneJson, WritesATriangleAsAMesh) {
  const json sail = exported(full_scene())["objects"][3];
  EXPECT_EQ(sail["shape"], "mesh");
  EXPECT_EQ(sail["vertices"].size(), 3u);
  EXPECT_EQ(sail["triangles"], json({{0, 1, 2}}));
}

TEST(SceneJson, KeepsEveryDigitInTheShortestText) {
  Scene scene = full_scene();
  scene.objects[1].shape = Sphere{{0.1, 1e-300, 0.1 + 0.2}, 1e22};
  const std::string text = text_of(scene);
  EXPECT_NE(text.find("[0.1, 1e-300, 0.30000000000000004]"), std::string::npos);
  EXPECT_EQ(json::parse(text)["objects"][1]["radius"].get<double>(), 1e22);
}

TEST(SceneJson, SurvivesAnyName) {
  Scene scene = full_scene();
  scene.name = "\"\\\n\xff";
  EXPECT_EQ(exported(scene)["name"], "\"\\\n\xEF\xBF\xBD");
}

}  // namespace
}  // namespace litmus

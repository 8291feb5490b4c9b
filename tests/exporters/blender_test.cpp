// blender_test.cpp: the text of the Blender exports. Whether Blender agrees is tested in
// reference/.
#include "exporters/blender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>

#include "scene/load.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

using Writer = void (*)(const Scene&, std::ostream&);

std::string as_blender(const Scene& scene, Writer write = write_blender) {
  std::ostringstream out;
  write(scene, out);
  return out.str();
}

/// One object of each kind under one light of each type.
Scene full_blender_scene() {
  Scene scene;
  scene.name = "full";
  scene.about = "One of everything.";
  scene.camera.eye = {0, -8, 4};
  scene.materials.push_back({"plain", {}, {}, {}, 1});
  scene.objects.push_back({"floor", Plane{}, 0, true});
  scene.objects.push_back({"ball", Sphere{{0, 0, 1}, 1}, 0, true});
  scene.objects.push_back({"crate", Box{{1, 1, 0}, {2, 2, 1}}, 0, false});
  scene.objects.push_back({"sail", Triangle{{-2, 0, 0}, {-1, 0, 0}, {-1, 0, 2}}, 0, true});
  scene.objects.push_back(
      {"net",
       Mesh{{{3, 0, 0}, {4, 0, 0}, {3, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2}}}, 0,
       true});
  scene.lights.push_back({.name = "sun", .shape = DirectionalLight{}});
  scene.lights.push_back({.name = "lamp", .shape = PointLight{{0, 0, 4}, {3, 0.5, 0.25}}});
  scene.lights.push_back({.name = "spot", .shape = SpotLight{{{0, 0, 4}, {}}, {0, 0, -1}, 0.5, 3}});
  AreaLight panel;
  panel.point.origin = {1, 1, 4};
  panel.columns = 3;
  panel.rows = 2;
  scene.lights.push_back({.name = "panel", .shape = panel});
  return scene;
}

/// Python's opinion of a text: "" if it parses, else its complaint; and how many imports it has.
struct Parsed {
  bool ok = false;
  int imports = 0;
};
Parsed parse(const std::string& python) {
  const fs::path folder = fs::path(testing::TempDir()) / ("blender-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "script.py", std::ios::binary) << python;
  std::ofstream(folder / "count.py")
      << "import ast, sys\n"
         "tree = ast.parse(open(sys.argv[1], encoding='utf-8').read())\n"
         "count = sum(isinstance(n, (ast.Import, ast.ImportFrom)) for n in ast.walk(tree))\n"
         "open(sys.argv[2], 'w').write(str(count))\n";
  const std::string command =
      "cd '" + folder.string() + "' && python3 count.py script.py result 2>/dev/null";
  Parsed parsed;
  parsed.ok = std::system(command.c_str()) == 0;
  std::ifstream(folder / "result") >> parsed.imports;
  fs::remove_all(folder);
  return parsed;
}
bool has_python() { return std::system("python3 -c '' 2>/dev/null") == 0; }

TEST(BlenderExport, WritesEveryCanonicalScene) {
  for (const Scene& scene : load_canonical_scenes().scenes) {
    for (const Writer write : {&write_blender, &write_blender_native}) {
      const std::string text = as_blender(scene, write);
      EXPECT_THAT(text, HasSubstr("finish(\"" + scene.name + "\")")) << scene.name;
      for (const Light& light : scene.lights) {
        EXPECT_THAT(text, HasSubstr('"' + light.name + '"')) << scene.name;
      }
    }
  }
}

TEST(BlenderExport, NamesObjectsMaterialsAndLights) {
  const std::string text = as_blender(full_blender_scene());
  for (const char* line :
       {"plane(\"floor\", Material_Plain, [", "sphere(\"ball\", Material_Plain, (0, 0, 1), 1)",
        "box(\"crate\", Material_Plain, (1, 1, 0), (2, 2, 1), visible=False)",
        "mesh(\"sail\", Material_Plain, vertices=\"\"\"\n-2 0 0\n", "normals=\"\"\"\n0 0 1\n",
        "directional_light(\"sun\", direction=(0, 0, -1), intensity=1",
        "positional_light(\"lamp\", [(0, 0, 4)]", "range=3, linear=0.5, quadratic=0.25)",
        "axis=(0, 0, -1), cutoff=0.5, exponent=3)"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
}

TEST(BlenderExport, ListsItsFramesInTheHeader) {
  EXPECT_THAT(as_blender(full_blender_scene()),
              HasSubstr("#   1  ambient light\n"
                        "#   2  directional light sun\n"
                        "#   3  point light lamp\n"
                        "#   4  spot light spot\n"
                        "#   5-10  area light panel: its 3 x 2 samples"));
}

TEST(BlenderExport, HasAFrameForEachSampleOfAnAreaLight) {
  const auto frames = blender_frames(full_blender_scene());
  ASSERT_EQ(frames.size(), 10u);
  EXPECT_EQ(frames[0].light, -1);
  EXPECT_EQ(frames[3].light, 2);
  EXPECT_EQ(frames[4].light, 3);
  EXPECT_EQ(frames[9].light, 3);
  EXPECT_EQ(frames[9].sample, 5);
}

TEST(BlenderExport, AddsTheAmbientLightOfAllLightsOnce) {
  Scene scene = full_blender_scene();
  scene.ambient = {0.5, 0.25, 0};
  scene.lights[0].intensity = 2;
  scene.lights[0].ambient = {0.25, 0, 0};
  scene.lights[1].ambient = {0, 0.5, 0.125};
  EXPECT_THAT(as_blender(scene), HasSubstr("\nambient((1, 0.75, 0.125))\n"));
}

TEST(BlenderExport, TurnsShadowsOffWhereTheSceneDoes) {
  Scene scene = full_blender_scene();
  EXPECT_THAT(as_blender(scene), Not(HasSubstr("shadows=False)")));
  scene.shadows = false;
  EXPECT_THAT(as_blender(scene), HasSubstr("specular=(1, 1, 1), shadows=False)"));
}

TEST(BlenderExport, SaysWhereTheSceneWasMoved) {
  Scene scene = full_blender_scene();
  EXPECT_THAT(as_blender(scene), Not(HasSubstr("Moved and scaled")));
  scene.objects = {{"far ball", Sphere{{1e5, 0, 0}, 1}, 0, true}};
  scene.camera.eye = {1e5, -5, 0};
  scene.camera.target = {1e5, 0, 0};
  scene.lights.clear();
  EXPECT_THAT(as_blender(scene), HasSubstr("Moved and scaled"));
}

TEST(BlenderExport, ParsesAsPythonWhateverTheNamesAre) {
  if (!has_python()) GTEST_SKIP() << "python3 is not installed";
  const Parsed plain = parse(as_blender(full_blender_scene()));
  ASSERT_TRUE(plain.ok);
  ASSERT_GT(plain.imports, 0);
  Scene hostile = full_blender_scene();
  const std::string name = "\"\"\"; import os #\n\rimport os\\\n'''\x01\xff\u2028import os\n\"";
  hostile.name = hostile.about = name;
  for (Material& material : hostile.materials) material.name = name;
  for (Object& object : hostile.objects) object.name = name;
  for (Light& light : hostile.lights) light.name = name;
  for (const Writer write : {&write_blender, &write_blender_native}) {
    const Parsed parsed = parse(as_blender(hostile, write));
    EXPECT_TRUE(parsed.ok);
    EXPECT_EQ(parsed.imports, parse(as_blender(full_blender_scene(), write)).imports);
  }
}

TEST(BlenderExport, ParsedImportsAreCounted) {
  if (!has_python()) GTEST_SKIP() << "python3 is not installed";
  EXPECT_EQ(parse("import os\nimport sys").imports, 2);
  EXPECT_FALSE(parse("import os\n\"").ok);
}

/// A locale like de_DE: comma for the point, points between thousands.
struct German : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(BlenderExport, DoesNotDependOnTheLocale) {
  Scene scene = full_blender_scene();
  scene.width = 1920;
  auto& mesh = std::get<Mesh>(scene.objects.back().shape);
  mesh.vertices.resize(2000, Point(0.5));
  mesh.normals.clear();
  mesh.triangles.push_back({0, 1, 1999});
  for (const Writer write : {&write_blender, &write_blender_native}) {
    const std::string usual = as_blender(scene, write);
    EXPECT_THAT(usual, HasSubstr("\n0 1 1999\n"));
    const std::locale before = std::locale::global(std::locale(std::locale(), new German));
    const std::string german = as_blender(scene, write);
    std::locale::global(before);
    EXPECT_EQ(german, usual);
  }
}

TEST(BlenderExport, RefusesTheSampleCode) {
  Scene scene = full_blender_scene();
  scene.shading = Shading::SampleCode;
  for (const Writer write : {&write_blender, &write_blender_native}) {
    try {
      as_blender(scene, write);
      ADD_FAILURE() << "not refused";
    } catch (const Refusal& refusal) {
      EXPECT_THAT(refusal.what(), HasSubstr("full: shading"));
    }
  }
}

TEST(BlenderExport, RefusesPicturesThatBlenderWouldEnlarge) {
  Scene scene = full_blender_scene();
  scene.width = 3;
  EXPECT_THROW(as_blender(scene), Refusal);
  scene.samples = 2;
  EXPECT_NO_THROW(as_blender(scene));
}

TEST(BlenderExport, HasNoCaveatsButWhereTheEyeIsInsideASphereOrAConeIsSteep) {
  Scene scene = full_blender_scene();
  EXPECT_TRUE(blender_caveats(scene).empty());
  scene.objects.push_back({"dome", Sphere{{0, 0, 0}, 20}, 0, true});
  ASSERT_EQ(blender_caveats(scene).size(), 1u);
  EXPECT_THAT(blender_caveats(scene)[0], HasSubstr("sphere \"dome\""));
  std::get<SpotLight>(scene.lights[2].shape).exponent = 1000;
  EXPECT_EQ(blender_caveats(scene).size(), 2u);
}

TEST(BlenderExport, FilesAreNamedSafely) {
  Scene scene;
  for (const auto& [name, stem] : {std::pair{"d1-sun_floor.2", "d1-sun_floor.2"},
                                   {"../../etc/passwd", "etcpasswd"},
                                   {"-o", "scene-o"},
                                   {"", "scene"},
                                   {"a b\n\"c", "abc"}}) {
    scene.name = name;
    EXPECT_EQ(blender_stem(scene), stem);
  }
}

TEST(BlenderNative, SaysWhatItCannotExpress) {
  Scene scene = full_blender_scene();
  const std::string all = as_blender(scene, write_blender_native);
  EXPECT_THAT(all, HasSubstr("fall off as 1 / d^2"));
  EXPECT_THAT(all, HasSubstr("smoothstep"));
  EXPECT_THAT(all, HasSubstr("not a grid of points"));
  scene.lights.resize(1);
  EXPECT_THAT(as_blender(scene, write_blender_native), Not(HasSubstr("fall off as 1 / d^2")));
}

TEST(BlenderNative, UsesTheLampsOfBlender) {
  const std::string text = as_blender(full_blender_scene(), write_blender_native);
  for (const char* line :
       {"\nsun(\"sun\", (0, 0, -1), 3.14159", "\npoint(\"lamp\", (0, 0, 4), ",
        "\nspot(\"spot\", (0, 0, 4), (0, 0, -1), ", "size=1, blend=0.6" /* 28.6 degrees */,
        "\narea(\"panel\", (1, 1, 4), "}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
}

}  // namespace
}  // namespace litmus

// blender_driver_test.cpp: what Blender renders against closed forms. Needs Blender, else skips.
#include "reference/blender_driver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "compare/image_io.h"
#include "exporters/blender.h"
#include "reference/process.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

constexpr double kInterior =
    2e-5;  // the tolerance of interior pixels: single precision, measured 8e-6

const std::optional<Installation>& blender() {
  static const std::optional<Installation> found = blender_driver().find();
  return found;
}

struct BlenderLive : InFolder {
  void SetUp() override {
    if (!blender()) GTEST_SKIP() << "blender is not installed";
    InFolder::SetUp();
  }
  std::map<std::string, ReferenceResult> render(const std::vector<Scene>& scenes) {
    std::map<std::string, ReferenceResult> results;
    blender_driver().render(*blender(), scenes, {.work = folder}, [&](ReferenceResult result) {
      results[result.scene] = std::move(result);
    });
    return results;
  }
};

/// A floor of 6 x 4 units from above; the centre of pixel (i, j) of 12 x 8 is half a unit apart.
Scene blender_floor(const std::string& name) {
  Scene scene;
  scene.name = name;
  scene.width = 12;
  scene.height = 8;
  scene.camera = {Projection::Orthographic, {0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 0.7, 4};
  scene.materials.push_back({"floor", Color(0.5), Color(0.8, 0.6, 0.4), Color(0), 1});
  scene.objects.push_back({"floor", Plane{}, 0, true});
  return scene;
}
Point floor_point(double i, double j) { return {(i + 0.5) / 2 - 3, 2 - (j + 0.5) / 2, 0}; }

TEST_F(BlenderLive, RendersEachKindOfLightToItsClosedForm) {
  Scene scene = blender_floor("kinds");
  scene.ambient = {0.1, 0.2, 0.3};
  const Point at(0.3, -0.2, 2);
  scene.lights.push_back(
      {.name = "sun", .shape = DirectionalLight{{3, 0, -4}}, .diffuse = {1, 0.5, 0.25}});
  scene.lights.push_back({.name = "lamp", .shape = PointLight{at, {1.5, 0.5, 2}}, .intensity = 3});
  scene.lights.push_back({.name = "spot", .shape = SpotLight{{at, {}}, {0, 0, -2}, 1.2, 3}});
  AreaLight panel;
  panel.point.origin = at;
  panel.normal = Vector(0, 0, -1);
  panel.columns = 2;
  panel.width = 1;
  scene.lights.push_back({.name = "panel", .shape = panel});
  const ReferenceResult result = render({scene})["kinds"];
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.layers.size(), 5u);
  EXPECT_GT(result.seconds, 0);

  const auto cosine = [](const Point& lamp, const Point& p) {
    return lamp.z / std::hypot(lamp.x - p.x, lamp.y - p.y, lamp.z);
  };
  for (int j = 0; j < scene.height; ++j) {
    for (int i = 0; i < scene.width; ++i) {
      const Point p = floor_point(i, j);
      const double d = std::hypot(p.x - at.x, p.y - at.y, at.z);
      const double alpha = std::acos(at.z / d);
      const double expected[] = {
          0.5 * 0.1, 0.8 * 0.8,
          0.8 * 3 * cosine(at, p) * 1.5 / (1.5 + 0.5 * d) * 2.25 / (2.25 + 2 * d * d),
          alpha < 1.2 ? 0.8 * cosine(at, p) * (1 - std::pow(alpha / 1.2, 3)) : 0,
          0.8 / 2 * (cosine(at + Vector(0.25, 0, 0), p) + cosine(at - Vector(0.25, 0, 0), p))};
      for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(result.layers[k].picture.at(i, j).r, expected[k], kInterior)
            << result.layers[k].light << " at " << i << ", " << j;
      }
    }
  }
  EXPECT_NEAR(result.layers[0].picture.at(3, 3).b, 0.5 * 0.3, kInterior);
  EXPECT_NEAR(result.layers[1].picture.at(3, 3).g, 0.6 * 0.5 * 0.8, kInterior);
  EXPECT_EQ(result.layers[2].light_type, "point");
}

TEST_F(BlenderLive, AveragesSamplesOfAPixel) {
  Scene scene = blender_floor("fine");
  scene.samples = 2;
  scene.lights.push_back({.name = "lamp", .shape = PointLight{{0, 0, 1}, {}}});
  const ReferenceResult result = render({scene})["fine"];
  ASSERT_EQ(result.failure, "");
  double mean = 0;
  for (const double y : {-0.25, 0.25}) {
    for (const double x : {-0.25, 0.25}) {
      const Point p = floor_point(4 + x, 2 + y);
      mean += 0.8 / std::hypot(p.x, p.y, 1.0) / 4;
    }
  }
  EXPECT_NEAR(result.layers[1].picture.at(4, 2).r, mean, kInterior);
}

TEST_F(BlenderLive, RendersWhateverTheNamesAre) {
  Scene scene = blender_floor("\"\"\"; import os #\n/../x");
  scene.lights.push_back({.name = "sun", .shape = DirectionalLight{}});
  const std::string longest(100, 'n');
  scene.lights.push_back({.name = longest + "\n\"\x01\xff", .shape = PointLight{{0, 0, 1}, {}}});
  scene.lights.push_back({.name = longest + "\n\"\x01\xff", .shape = DirectionalLight{}});
  scene.objects[0].name = scene.materials[0].name = scene.about = scene.lights[1].name;
  const ReferenceResult result = render({scene})[scene.name];
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.layers.size(), 4u);
  EXPECT_NEAR(result.layers[3].picture.at(2, 2).r, 0.8, kInterior);
}

TEST_F(BlenderLive, AFailingSceneTakesNoOtherWithIt) {
  Scene broken = blender_floor("broken");
  broken.objects.push_back({"bad", Mesh{{{0, 0, 0}}, {}, {{0, 1, 2}}}, 0, true});
  Scene refused = blender_floor("refused");
  refused.shading = Shading::SampleCode;
  auto results = render({broken, refused, blender_floor("good")});
  ASSERT_EQ(results.size(), 3u);
  EXPECT_THAT(results["broken"].failure, HasSubstr("failed in Blender"));
  EXPECT_TRUE(results["broken"].layers.empty());
  EXPECT_THAT(tail(results["broken"].log, 4000), HasSubstr("IndexError"));
  EXPECT_THAT(results["refused"].failure, HasSubstr("shading"));
  EXPECT_EQ(results["good"].failure, "");
  EXPECT_EQ(results["good"].layers.size(), 1u);
}

TEST_F(BlenderLive, ATimeLimitIsAFailureOfTheSceneAtWork) {
  const Scene scene = blender_floor("slow");
  std::vector<ReferenceResult> results;
  blender_driver().render(*blender(), std::vector{scene},
                          {.work = folder, .time_limit = std::chrono::seconds(0)},
                          [&](ReferenceResult result) { results.push_back(std::move(result)); });
  ASSERT_EQ(results.size(), 1u);
  EXPECT_NE(results[0].failure, "");
}

TEST_F(BlenderLive, TheSavedFileRendersTheSamePixelsWithoutPython) {
  Scene scene = blender_floor("saved");
  scene.lights.push_back({.name = "lamp", .shape = PointLight{{0, 0, 2}, {}}});
  scene.lights.push_back({.name = "sun", .shape = DirectionalLight{{1, 0, -1}}});
  scene.objects.push_back({"ball", Sphere{{1, 0, 0.5}, 0.4}, 0, true});
  std::ostringstream script;
  write_blender(scene, script);
  write_text(folder / "saved.py", script.str());
  const std::string program = blender()->program.string();
  const ProcessResult made =
      run_process({.arguments = {program, "-b", "--factory-startup", "-Y", "--python-exit-code",
                                 "9", "-P", "saved.py", "--", "."},
                   .directory = folder,
                   .log = folder / "made.log"});
  ASSERT_TRUE(made.ok()) << made.explanation << tail(folder / "made.log");
  const ProcessResult again =
      run_process({.arguments = {program, "-b", "saved.blend", "-o", "//again_####", "-a"},
                   .directory = folder,
                   .log = folder / "again.log"});
  ASSERT_TRUE(again.ok()) << again.explanation << tail(folder / "again.log");
  for (const char* frame : {"0001", "0002", "0003"}) {
    const std::string end = std::string(frame) + ".exr";
    const Picture first = read_picture(folder / ("saved_" + end));
    EXPECT_TRUE(same(first, read_picture(folder / ("again_" + end)))) << end;
    EXPECT_EQ(first.width, 12);
  }
  EXPECT_FALSE(
      same(read_picture(folder / "saved_0002.exr"), read_picture(folder / "saved_0003.exr")));
}

TEST_F(BlenderLive, TheNativeExportRendersWithoutComplaint) {
  Scene scene = blender_floor("native");
  scene.materials[0].specular = Color(0.2);
  scene.lights.push_back({.name = "lamp", .shape = PointLight{{0, 0, 2}, {}}});
  scene.lights.push_back({.name = "spot", .shape = SpotLight{{{0, 0, 2}, {}}, {0, 0, -1}, 0.5, 3}});
  scene.lights.push_back({.name = "panel", .shape = AreaLight{{{0, 0, 2}, {}}, Vector(0, 0, -1)}});
  scene.lights.push_back({.name = "sun", .shape = DirectionalLight{{3, 0, -4}}});
  scene.objects.push_back({"ball", Sphere{{1, 0, 0.5}, 0.4}, 0, true});
  scene.objects.push_back({"crate", Box{{-2, 0, 0}, {-1, 1, 1}}, 0, true});
  scene.objects.push_back(
      {"net",
       Mesh{
           {{0, 0, 0.2}, {1, 0, 0.2}, {0, 1, 0.2}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2}}},
       0, true});
  std::ostringstream script;
  write_blender_native(scene, script);
  write_text(folder / "native.py", script.str());
  const ProcessResult made =
      run_process({.arguments = {blender()->program.string(), "-b", "--factory-startup", "-Y",
                                 "--python-exit-code", "9", "-P", "native.py", "--", "."},
                   .directory = folder,
                   .log = folder / "made.log"});
  ASSERT_TRUE(made.ok()) << made.explanation << tail(folder / "made.log");
  EXPECT_EQ(read_picture(folder / "native_0005.exr").width, 12);
}

/// A program in Blender's place. It prints what the batch script prints, and renders nothing.
struct BlenderStandIn : InFolder {
  std::vector<ReferenceResult> render(const std::string& per_scene, int scenes) {
    const std::filesystem::path program = folder / "stand-in";
    write_text(program,
               "#!/bin/sh\nwhile [ \"$1\" != -- ]; do shift; done; shift; first=$1\n"
               "for scene; do echo litmus begin $scene\n" +
                   per_scene + "\ndone\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    std::vector<Scene> list;
    for (int i = 0; i < scenes; ++i) list.push_back(blender_floor("s" + std::to_string(i)));
    std::vector<ReferenceResult> results;
    blender_driver().render({program, "0"}, list, {.work = folder / "work"},
                            [&](ReferenceResult result) { results.push_back(std::move(result)); });
    return results;
  }
};

TEST_F(BlenderStandIn, AnImageThatIsMissingIsAFailure) {
  const auto results = render("echo litmus end $scene ok", 2);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_THAT(results[0].failure, HasSubstr("s0_0001.exr"));
  EXPECT_THAT(results[1].failure, HasSubstr("s1_0001.exr"));
}

TEST_F(BlenderStandIn, ACrashIsBlamedOnASceneThatCrashesOnItsOwn) {
  // Scene 1 crashes behind another one only, scene 2 always.
  const auto results = render(
      "[ $scene = 2 ] && exit 7; [ $scene = 1 ] && [ $first != 1 ] && exit 7\n"
      "echo litmus end $scene failed",
      4);
  ASSERT_EQ(results.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(results[i].scene, "s" + std::to_string(i));
  EXPECT_THAT(results[1].failure, HasSubstr("failed in Blender"));
  EXPECT_THAT(results[2].failure, HasSubstr("exited with 7"));
  EXPECT_THAT(results[3].failure, HasSubstr("failed in Blender"));
}

TEST_F(BlenderStandIn, AProgramThatDoesNotStartFailsEveryScene) {
  std::vector<ReferenceResult> none;
  blender_driver().render({folder / "nothing", "0"},
                          std::vector{blender_floor("a"), blender_floor("b")}, {.work = folder},
                          [&](ReferenceResult result) { none.push_back(std::move(result)); });
  ASSERT_EQ(none.size(), 2u);
  EXPECT_NE(none[0].failure, "");
  EXPECT_NE(none[1].failure, "");
}

TEST(BlenderDriver, SourceDoesNotDependOnWordsForPeople) {
  Scene scene = sample_scene("one");
  const std::string source = blender_driver().source(scene);
  scene.name = "two";
  scene.about = "other words";
  EXPECT_EQ(blender_driver().source(scene), source);
  scene.lights[0].intensity = 1.5;
  EXPECT_NE(blender_driver().source(scene), source);
}

TEST(BlenderDriver, AddsUpTheSecondsOfOneScene) {
  const std::string log =
      "litmus begin 0\nTotal render time: 8\nlitmus end 0 ok\n"
      "litmus begin 1\nI1 session.cpp:464] Total render time: 0.25\nx\nTotal render time: 1e-05\n"
      "litmus end 1 ok\nlitmus begin 10\nTotal render time: 16\n";
  EXPECT_DOUBLE_EQ(blender_render_seconds(log, 1), 0.25001);
  EXPECT_DOUBLE_EQ(blender_render_seconds(log, 10), 16);
  EXPECT_EQ(blender_render_seconds(log, 2), 0);
}

}  // namespace
}  // namespace litmus

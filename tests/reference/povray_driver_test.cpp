// povray_driver_test.cpp: what POV-Ray renders against closed forms. Needs POV-Ray, else skips.
#include "reference/povray_driver.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>

#include "compare/image_io.h"
#include "exporters/povray.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

// POV-Ray's colours are single precision: a few 6e-8 per operation.
constexpr double kSingle = 3e-7;

const std::optional<Installation>& povray() {
  static const std::optional<Installation> found = povray_driver().find();
  return found;
}

ReferenceOptions in(const std::filesystem::path& folder) {
  ReferenceOptions options;
  options.work = folder;
  return options;
}

struct PovrayLive : InFolder {
  void SetUp() override {
    if (!povray()) GTEST_SKIP() << "povray is not installed";
    InFolder::SetUp();
  }
  std::map<std::string, ReferenceResult> render(const std::vector<Scene>& scenes) {
    std::map<std::string, ReferenceResult> results;
    povray_driver().render(*povray(), scenes, in(folder), [&](ReferenceResult result) {
      results[result.scene] = std::move(result);
    });
    return results;
  }
  ReferenceResult render(const Scene& scene) { return render(std::vector{scene}).at(scene.name); }
};

constexpr int kFloorWidth = 12, kFloorHeight = 8;
const Color kDiffuse(0.8, 0.6, 0.4);

/// A floor of 6 x 4 units from above; pixels are half a unit apart.
Scene povray_floor(const std::string& name) {
  Scene scene;
  scene.name = name;
  scene.width = kFloorWidth;
  scene.height = kFloorHeight;
  scene.camera = {Projection::Orthographic, {0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 0.7, 4};
  scene.materials.push_back({"floor", Color(0.5), kDiffuse, Color(0), 1});
  scene.objects.push_back({"floor", Plane{}, 0, true});
  return scene;
}

Light light(const std::string& name, decltype(Light::shape) shape, double intensity = 1) {
  Light result;
  result.name = name;
  result.shape = shape;
  result.intensity = intensity;
  return result;
}

Point floor_point(int i, int j) { return {(i + 0.5) / 2 - 3, 2 - (j + 0.5) / 2, 0}; }

/// Fails where a layer is not kd * expected(point on the floor).
template <class F>
void expect_floor(const Picture& picture, const F& expected) {
  ASSERT_EQ(picture.width, kFloorWidth);
  ASSERT_EQ(picture.height, kFloorHeight);
  for (int j = 0; j < kFloorHeight; ++j)
    for (int i = 0; i < kFloorWidth; ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(picture.at(i, j)[c], kDiffuse[c] * expected(floor_point(i, j)), kSingle)
            << i << ", " << j << ", channel " << c;
}

TEST_F(PovrayLive, RendersEachKindOfLightToItsClosedForm) {
  const Point at(0.3, -0.2, 2);
  const Vector travel(0.3, 0.4, -1.2);
  Scene scene = povray_floor("kinds");
  scene.ambient = {0.1, 0.2, 0.3};
  scene.lights.push_back(light("sun", DirectionalLight{travel}, 1.5));
  scene.lights.push_back(light("lamp", PointLight{at, {2, 0.5, 0.25}}));
  SpotLight spot{{at, {}}, {0, 0, -1}, 0.6, 2};
  scene.lights.push_back(light("spot", spot));
  AreaLight area;
  area.point.origin = at;
  area.normal = Vector(0, 0, -1);
  area.columns = 2;
  area.width = 1;
  scene.lights.push_back(light("panel", area));

  const ReferenceResult result = render(scene);
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.layers.size(), 5u);
  EXPECT_GT(result.seconds, -1e-9);
  for (const auto& pixel : result.layers[0].picture.pixels)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], 0.5 * scene.ambient[c], kSingle);
  expect_floor(result.layers[1].picture,
               [&](const Point&) { return 1.5 * -glm::normalize(travel).z; });
  expect_floor(result.layers[2].picture, [&](const Point& p) {
    const double d = glm::distance(p, at), x = d / 2;
    return at.z / d / (1 + 0.5 * x) / (1 + 0.25 * x * x);
  });
  expect_floor(result.layers[3].picture, [&](const Point& p) {
    const double d = glm::distance(p, at), angle = std::acos(at.z / d) / spot.cutoff;
    return angle > 1 ? 0 : at.z / d * (1 - angle * angle);
  });
  expect_floor(result.layers[4].picture, [&](const Point& p) {
    double sum = 0;
    for (const double x : {-0.25, 0.25}) sum += at.z / glm::distance(p, at + Vector(x, 0, 0)) / 2;
    return sum;
  });
}

TEST_F(PovrayLive, KeepsManyLightsInOrderWhereSeveralProcessesShareThem) {
  Scene scene = povray_floor("many");
  for (int i = 1; i <= 20; ++i)
    scene.lights.push_back(light(std::to_string(i), DirectionalLight{{0, 0, -1}}, double(i) / 20));
  const ReferenceResult result = render(scene);
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.layers.size(), 21u);
  for (int i = 1; i <= 20; ++i)
    expect_floor(result.layers[std::size_t(i)].picture,
                 [&](const Point&) { return double(i) / 20; });
  EXPECT_THAT(result.command, HasSubstr("+KFF21 +WT"));  // that renders all of them
}

TEST_F(PovrayLive, IsFinerThanSixteenBits) {
  Scene scene = povray_floor("fine");
  scene.lights.push_back(light("lamp", PointLight{{0.3, -0.2, 2}, {}}));
  const ReferenceResult result = render(scene);
  ASSERT_EQ(result.failure, "");
  // The first pass alone is what a step of 1/65535 leaves.
  const Picture coarse = read_picture(folder / "0000" / "scene2.png");
  double worst = 0;
  for (int j = 0; j < kFloorHeight; ++j)
    for (int i = 0; i < kFloorWidth; ++i) {
      const double exact = kDiffuse.r * 2 / glm::distance(floor_point(i, j), Point(0.3, -0.2, 2));
      worst = std::max(worst, std::abs(coarse.at(i, j).r - exact));
      ASSERT_NEAR(result.layers[1].picture.at(i, j).r, exact, kSingle);
    }
  EXPECT_GT(worst, 1e-6);
}

TEST_F(PovrayLive, KeepsDiffuseAndSpecularColoursApart) {
  // Under the eye of an orthographic camera, with light along the view, n.l = n.h = 1.
  Scene scene = povray_floor("colours");
  scene.materials[0].specular = {0.1, 0.3, 0.2};
  scene.lights.push_back(light("sun", DirectionalLight{{0, 0, -1}}));
  scene.lights[0].diffuse = {0, 0.5, 1};
  scene.lights[0].specular = {1, 0.5, 0};
  const ReferenceResult result = render(scene);
  ASSERT_EQ(result.failure, "");
  for (const auto& pixel : result.layers[1].picture.pixels)
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(pixel[c],
                  kDiffuse[c] * scene.lights[0].diffuse[c] +
                      scene.materials[0].specular[c] * scene.lights[0].specular[c],
                  kSingle);
}

TEST_F(PovrayLive, CastsShadowsOfHiddenObjectsUnlessTheyAreOff) {
  Scene scene = povray_floor("shadows");
  scene.objects.push_back({"roof", Box{{-9, -9, 1}, {9, 9, 2}}, 0, false});
  scene.lights.push_back(light("sun", DirectionalLight{{0, 0, -1}}));
  Scene off = scene;
  off.name = "off";
  off.shadows = false;
  const auto results = render({scene, off});
  ASSERT_EQ(results.at("shadows").failure + results.at("off").failure, "");
  expect_floor(results.at("shadows").layers[1].picture, [](const Point&) { return 0.0; });
  expect_floor(results.at("off").layers[1].picture, [](const Point&) { return 1.0; });
}

TEST_F(PovrayLive, AveragesTheSamplesOfAPixel) {
  Scene scene = povray_floor("samples");
  scene.samples = 2;
  scene.lights.push_back(light("lamp", PointLight{{0.3, -0.2, 1}, {}}));
  const ReferenceResult result = render(scene);
  ASSERT_EQ(result.failure, "");
  expect_floor(result.layers[1].picture, [](const Point& p) {
    double sum = 0;
    for (const double x : {-0.125, 0.125})
      for (const double y : {-0.125, 0.125})
        sum += 1 / glm::distance(p + Vector(x, y, 0), Point(0.3, -0.2, 1)) / 4;
    return sum;
  });
}

TEST_F(PovrayLive, RendersASceneWithoutLights) {
  Scene scene = povray_floor("dark");
  scene.ambient = Color(0.5);
  const ReferenceResult result = render(scene);
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.layers.size(), 1u);
  EXPECT_NEAR(result.layers[0].picture.at(3, 3).g, 0.25, kSingle);
}

TEST_F(PovrayLive, KeepsTheOtherScenesWhenOneFails) {
  Scene bad = povray_floor("bad");
  bad.shading = Shading::SampleCode;
  const auto results = render({povray_floor("one"), bad, povray_floor("two")});
  EXPECT_THAT(results.at("bad").failure, HasSubstr("sample-code"));
  EXPECT_TRUE(results.at("bad").layers.empty());
  EXPECT_EQ(results.at("one").failure, "");
  EXPECT_EQ(results.at("two").failure, "");
}

TEST_F(PovrayLive, ReportsAProgramThatFails) {
  ReferenceResult result;
  povray_driver().render({"/bin/false", "0"}, std::vector{povray_floor("floor")}, in(folder),
                         [&](ReferenceResult r) { result = std::move(r); });
  EXPECT_THAT(result.failure, HasSubstr("exited with 1"));
  EXPECT_TRUE(result.layers.empty());
}

/// POV-Ray, but for `failures` starts that end with a line; and how often it was started.
struct Reluctant {
  std::filesystem::path folder;
  Installation installation(const std::string& line, int failures) const {
    const std::filesystem::path program = folder / "reluctant";
    std::ofstream(program) << fmt::format(
        "#!/bin/sh\necho start >> {0}/starts\n"
        "[ $(wc -l < {0}/starts) -gt {1} ] && exec {2} \"$@\"\necho \"{3}\"; exit 1\n",
        folder.string(), failures, povray()->program.string(), line);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return {program, povray()->version};
  }
  int starts() const {
    std::ifstream in(folder / "starts");
    return int(std::count(std::istreambuf_iterator<char>(in), {}, '\n'));
  }
};

TEST_F(PovrayLive, IsStartedAnewWhereABusyMachineDidNotStartItsThreads) {
  const Reluctant reluctant{folder};
  const Installation busy =
      reluctant.installation("Timed out waiting for worker thread startup", 2);
  const std::vector<Scene> scenes{povray_floor("floor")};
  std::string failure = "none came";
  povray_driver().render(busy, scenes, in(folder / "work"),
                         [&](ReferenceResult result) { failure = result.failure; });
  EXPECT_EQ(failure, "");
  EXPECT_EQ(reluctant.starts(), 4) << "two in vain, then one for each pass";
}

TEST_F(PovrayLive, IsNotStartedAnewAfterAnyOtherFailure) {
  const Reluctant reluctant{folder};
  const Installation broken = reluctant.installation("Parse Error", 1);
  const std::vector<Scene> scenes{povray_floor("floor")};
  std::string failure;
  povray_driver().render(broken, scenes, in(folder / "work"),
                         [&](ReferenceResult result) { failure = result.failure; });
  EXPECT_THAT(failure, HasSubstr("exited with 1"));
  EXPECT_EQ(reluctant.starts(), 1);
}

TEST_F(PovrayLive, ReportsPicturesThatAreMissing) {
  ReferenceResult result;
  povray_driver().render({"/bin/true", "0"}, std::vector{povray_floor("floor")}, in(folder),
                         [&](ReferenceResult r) { result = std::move(r); });
  EXPECT_THAT(result.failure, HasSubstr("scene.png"));
}

TEST_F(PovrayLive, HasAVersionOfDigitsAndDots) {
  EXPECT_THAT(povray()->version, testing::MatchesRegex("[0-9.]+[0-9]"));
}

TEST(PovrayLog, AddsUpTheCpuSecondsOfTracing) {
  const std::string log =
      "  Parse Time: 0 hours (0.5 seconds)\n  using 1 thread(s) with 0.400 CPU-seconds total\n"
      "  Trace Time: 0 hours (0.2 seconds)\n  using 2 thread(s) with 0.250 CPU-seconds total\n"
      "  Trace Time: 0 hours (0.2 seconds)\n  using 2 thread(s) with 0.500 CPU-seconds total\n";
  EXPECT_DOUBLE_EQ(povray_trace_seconds(log), 0.75);
  EXPECT_EQ(povray_trace_seconds("Trace Time:"), 0);
}

TEST(PovraySource, IgnoresWordsForPeople) {
  const Driver driver = povray_driver();
  Scene scene = sample_scene("ball");
  const std::string source = driver.source(scene);
  scene.name = "other";
  scene.about = "Another sentence.";
  scene.file = "elsewhere.toml";
  EXPECT_EQ(driver.source(scene), source);
  scene.ambient = Color(0.7);
  EXPECT_NE(driver.source(scene), source);
}

}  // namespace
}  // namespace litmus

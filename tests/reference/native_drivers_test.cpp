// native_drivers_test.cpp: the renderers' own lights, rendered and brought back to the model's
// scale.
#include "reference/native_drivers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

/// A floor seen from above under a sun at 60 degrees and a lamp that does not fade.
Scene native_floor() {
  Scene scene;
  scene.name = "floor";
  scene.width = scene.height = 8;
  scene.samples = 2;
  scene.camera = {Projection::Orthographic, {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.7, 2};
  scene.ambient = Color(0.25);
  scene.materials.push_back({"matte", Color(1), Color(0.5), Color(0), 1});
  scene.objects.push_back({"floor", Plane{}, 0, true});
  scene.lights.push_back({.name = "sun", .shape = DirectionalLight{{0, std::sqrt(3.0), -1}}});
  return scene;
}

class NativeDriver : public InFolder, public testing::WithParamInterface<std::string> {
 protected:
  const Driver& driver() const {
    for (const Driver& each : native_drivers())
      if (each.name == GetParam()) return each;
    throw std::runtime_error("no driver " + GetParam());
  }
};

TEST_P(NativeDriver, GivesTheModelsLightOfASun) {
  const auto installed = driver().find();
  if (!installed) GTEST_SKIP() << driver().title << ": apt-get install " << driver().package;
  ReferenceOptions options;
  options.work = folder;
  std::vector<ReferenceResult> results;
  Scene scene = native_floor();
  scene.width = scene.height = 400;  // POV-Ray counts whole milliseconds
  driver().render(*installed, std::vector{scene}, options,
                  [&](ReferenceResult said) { results.push_back(std::move(said)); });
  ASSERT_EQ(results.size(), 1u);
  ASSERT_EQ(results[0].failure, "");
  ASSERT_EQ(results[0].layers.size(), 2u);
  for (const auto& pixel : results[0].layers[0].picture.pixels) EXPECT_NEAR(pixel.x, 0.25, 1e-4);
  for (const auto& pixel : results[0].layers[1].picture.pixels) EXPECT_NEAR(pixel.x, 0.25, 1e-4);
  EXPECT_GT(results[0].seconds, 0);
}

TEST_P(NativeDriver, RendersSomethingElseThanTheExactDriver) {
  const std::string exact = GetParam().substr(0, GetParam().find('-'));
  EXPECT_NE(driver().source(native_floor()), find_driver(exact)->source(native_floor()));
}

INSTANTIATE_TEST_SUITE_P(Reference, NativeDriver,
                         testing::Values("povray-native", "blender-native"), [](const auto& info) {
                           return info.param.substr(0, info.param.find('-'));
                         });

}  // namespace
}  // namespace litmus

// exporters_test.cpp: what holds for every exporter of the table.
#include "exporters/exporters.h"

#include <gtest/gtest.h>

#include <sstream>

namespace litmus {
namespace {

Scene small_scene() {
  Scene scene;
  scene.name = "small";
  scene.materials.push_back({"white", Color(1), Color(0.8), Color(0), 1});
  scene.objects.push_back({"ball", Sphere{}, 0, true});
  scene.camera.eye = {0, -5, 2};
  Light lamp;
  lamp.name = "lamp";
  lamp.shape = PointLight{{0, -3, 4}, {}};
  scene.lights.push_back(lamp);
  return scene;
}

TEST(Exporters, HavePovrayAndBlender) {
  EXPECT_NE(find_exporter("povray"), nullptr);
  EXPECT_NE(find_exporter("blender"), nullptr);
  EXPECT_EQ(find_exporter("no-such-renderer"), nullptr);
}

TEST(Exporters, WriteTheSameTextTwice) {
  for (const Exporter& exporter : exporters()) {
    EXPECT_EQ(exporter.extension.front(), '.');
    std::ostringstream first, second;
    exporter.write(small_scene(), first);
    exporter.write(small_scene(), second);
    EXPECT_FALSE(first.str().empty()) << exporter.name;
    EXPECT_EQ(first.str(), second.str()) << exporter.name;
  }
}

TEST(Exporters, WriteSomethingElseNatively) {
  for (const char* name : {"povray", "blender"}) {
    const Exporter& exporter = *find_exporter(name);
    std::ostringstream exact, native;
    exporter.write(small_scene(), exact);
    exporter.write_native(small_scene(), native);
    EXPECT_FALSE(native.str().empty()) << name;
    EXPECT_NE(exact.str(), native.str()) << name;
  }
}

TEST(Exporters, AreExactForAPointLight) {
  for (const Exporter& exporter : exporters())
    EXPECT_TRUE(exporter.caveats(small_scene()).empty()) << exporter.name;
}

}  // namespace
}  // namespace litmus

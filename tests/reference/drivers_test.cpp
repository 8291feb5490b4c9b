// drivers_test.cpp: what holds for every renderer of the table.
#include "reference/drivers.h"

#include <gtest/gtest.h>

#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

TEST(Drivers, ArePovRayThenBlender) {
  ASSERT_EQ(drivers().size(), 2u);
  EXPECT_EQ(drivers()[0].name, "povray");
  EXPECT_EQ(drivers()[1].name, "blender");
}

TEST(Drivers, AreFoundByName) {
  for (const auto& driver : drivers()) EXPECT_EQ(find_driver(driver.name), &driver);
  EXPECT_EQ(find_driver("no-such-renderer"), nullptr);
}

TEST(Drivers, AreComplete) {
  for (const auto& driver : drivers()) {
    EXPECT_FALSE(driver.title.empty());
    EXPECT_FALSE(driver.package.empty());
    EXPECT_GE(driver.revision, 1);
    EXPECT_TRUE(driver.find && driver.source && driver.render) << driver.name;
  }
}

TEST(Drivers, TellScenesApartBySource) {
  for (const auto& driver : drivers()) {
    const auto source = driver.source(sample_scene("ball", 0.1));
    EXPECT_EQ(driver.source(sample_scene("ball", 0.1)), source) << driver.name;
    auto brighter = sample_scene("ball", 0.1);
    brighter.lights[0].intensity = 1.5;
    EXPECT_NE(driver.source(brighter), source) << driver.name;
    auto larger = sample_scene("ball", 0.1);
    larger.width = 7;
    EXPECT_NE(driver.source(larger), source) << driver.name;
  }
}

}  // namespace
}  // namespace litmus

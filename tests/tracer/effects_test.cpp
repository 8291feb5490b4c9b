// effects_test.cpp: what a scene calls for.
#include "tracer/effects.h"

#include <gtest/gtest.h>

#include "tests/tracer/scenes.h"

namespace litmus {
namespace {

TEST(EffectsOf, AFloorUnderTheSunAreDiffuseAlone) {
  Scene scene = floor_from_above();
  scene.lights = {sun({0, 0, -1})};
  Effects diffuse;
  diffuse.diffuse = true;
  EXPECT_EQ(effects_of(scene), diffuse);
}

TEST(EffectsOf, NameWhatALightHas) {
  Scene scene = floor_from_above();
  scene.lights = {bulb({0, 0, 1}, {2, 0.5, 0})};
  EXPECT_TRUE(effects_of(scene).linear);
  EXPECT_FALSE(effects_of(scene).quadratic);
  scene.lights = {make_light(SpotLight{{{0, 0, 1}, {2, 0, 1}}, {0, 0, -1}, 0.5, 3})};
  EXPECT_TRUE(effects_of(scene).quadratic && effects_of(scene).cone);
  EXPECT_FALSE(effects_of(scene).area);
  AreaLight panel;
  panel.point.origin = {0, 0, 2};
  scene.lights = {make_light(panel)};
  EXPECT_FALSE(effects_of(scene).area);  // one sample
  panel.columns = 2;
  scene.lights = {make_light(panel)};
  EXPECT_TRUE(effects_of(scene).area);
}

TEST(EffectsOf, DoNotCountALightThatIsOff) {
  Scene scene = floor_from_above();
  scene.lights = {bulb({0, 0, 1}, {2, 0.5, 1})};
  scene.lights[0].intensity = 0;
  scene.lights[0].ambient = Color(1);
  EXPECT_EQ(effects_of(scene), Effects{});
}

TEST(EffectsOf, HaveShadowsWhereSomethingMayCastOne) {
  Scene scene = floor_from_above();
  scene.lights = {sun({0, 0, -1})};
  scene.objects.push_back({"ball", Sphere{{0, 0, 1}, 0.3}, 0, true});
  EXPECT_TRUE(effects_of(scene).shadows);
  scene.shadows = false;
  EXPECT_FALSE(effects_of(scene).shadows);
  scene.shadows = true;
  scene.objects.erase(scene.objects.begin());  // a sphere has an inside
  EXPECT_TRUE(effects_of(scene).shadows);
}

TEST(EffectsOf, OneLightLeaveOutWhatTheOthersHave) {
  Scene scene = floor_from_above();
  scene.lights = {bulb({0, 0, 1}, {2, 0.5, 0}), sun({0, 0, -1})};
  EXPECT_TRUE(effects_of(scene, scene.lights[0]).linear);
  EXPECT_FALSE(effects_of(scene, scene.lights[1]).linear);
  EXPECT_TRUE(effects_of(scene, scene.lights[1]).diffuse);
}

TEST(AllEffects, HoldEachOne) {
  for (const EffectName& effect : effect_names()) EXPECT_TRUE(all_effects().*effect.member);
  EXPECT_EQ(effect_names().size() + 1, sizeof(Effects));  // each member has a name but `everywhere`
}

}  // namespace
}  // namespace litmus

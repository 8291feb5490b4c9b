// kernel_test.cpp: every way to render a canonical scene gives the same bits.
#include "tracer/kernel.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/load.h"
#include "scene/mesh.h"
#include "test_paths.h"
#include "tests/tracer/scenes.h"

namespace litmus {
namespace {

/// All canonical scenes, with pictures whose rows end in the middle of a packet.
const std::vector<Scene>& canonical_scenes() {
  static const std::vector<Scene> scenes = [] {
    std::vector<Scene> all = load_canonical_scenes().scenes;
    for (Scene& scene : all) scene.width = 37, scene.height = 29;
    return all;
  }();
  return scenes;
}

void expect_same(const Rendering& ours, const Rendering& theirs, const std::string& what) {
  EXPECT_EQ(ours.whole.pixels, theirs.whole.pixels) << what;
  ASSERT_EQ(ours.layers.size(), theirs.layers.size());
  for (std::size_t i = 0; i < ours.layers.size(); ++i) {
    EXPECT_EQ(ours.layers[i].picture.pixels, theirs.layers[i].picture.pixels) << what;
    EXPECT_EQ(ours.signatures[i].values, theirs.signatures[i].values) << what;
    EXPECT_EQ(ours.flags[i], theirs.flags[i]) << what;
  }
}

void move(Object& object, const Vector& by) {
  if (auto* sphere = std::get_if<Sphere>(&object.shape)) sphere->center += by;
  if (auto* box = std::get_if<Box>(&object.shape)) box->min += by, box->max += by;
  if (auto* mesh = std::get_if<Mesh>(&object.shape)) {
    for (Point& vertex : mesh->vertices) vertex += by;
  }
}

RenderOptions scalar(Precision precision = Precision::Double) {
  RenderOptions options{precision};
  options.kernel = Kernel::Scalar;
  return options;
}

TEST(Kernel, OfPacketsHasTheBitsOfTheScalarOne) {
  if (packet_kernels().empty()) GTEST_SKIP() << "this processor has no AVX2";
  for (const Scene& scene : canonical_scenes()) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      const Rendering expected = render(scene, scalar(precision));
      for (const PacketKernel& kernel : packet_kernels()) {
        RenderOptions options{precision};
        options.kernel = Kernel::Packet, options.target = kernel.target;
        const Rendering packets = render(scene, options);
        EXPECT_EQ(packets.target, kernel.target);
        expect_same(packets, expected, scene.name + " " + std::string(kernel.target));
      }
    }
  }
}

TEST(Kernel, GivesTheBitsOfEveryEffectWithThoseThatTheSceneNeeds) {
  for (const Scene& scene : canonical_scenes()) {
    RenderOptions all;
    all.effects = all_effects();
    expect_same(render(scene), render(scene, all), scene.name);
  }
}

TEST(Kernel, GivesTheSameBitsWithoutLayersAndEdges) {
  for (const Scene& scene : canonical_scenes()) {
    RenderOptions bare;
    bare.layers = bare.edges = false;
    const Rendering picture = render(scene, bare);
    EXPECT_EQ(picture.whole.pixels, render(scene).whole.pixels) << scene.name;
    EXPECT_TRUE(picture.layers.empty() && picture.signatures.empty() && picture.flags.empty());
  }
}

TEST(Kernel, GivesTheSameBitsWhereALampIsAtThePointSeen) {  // no direction, and no distance
  Scene scene = floor_from_above(5);
  scene.materials[0].specular = Color(0.5);
  scene.lights = {bulb({0, 0, 0}), bulb({0, 0, 10})};  // the second straight behind the eye
  RenderOptions bare;
  bare.layers = bare.edges = false;
  EXPECT_EQ(render(scene, bare).whole.pixels, render(scene).whole.pixels);
  EXPECT_EQ(render(scene, bare).whole.pixels, render(scene, scalar()).whole.pixels);
}

TEST(Kernel, GivesTheSameBitsOnOneThreadAndOnSeveral) {
  for (const Scene& scene : canonical_scenes()) {
    RenderOptions one, three;
    one.threads = 1, three.threads = 3;
    expect_same(render(scene, one), render(scene, three), scene.name);
  }
}

TEST(Kernel, GivesTheSameBitsWhereAreaLightsAreNotCulled) {
  // Four spheres, a box and a mesh around a panel, some in its way and some behind it.
  Scene scene = floor_from_above(45);
  scene.objects.push_back({"near", Sphere{{0.4, 0.3, 0.6}, 0.3}, 0, true});
  scene.objects.push_back({"far", Sphere{{-1.5, 1, 1.1}, 0.4}, 0, true});
  scene.objects.push_back({"above", Sphere{{0, 0, 4}, 0.5}, 0, false});
  scene.objects.push_back({"beside", Sphere{{2, -2, 2.9}, 0.2}, 0, false});
  scene.objects.push_back({"block", Box{{-1, -1.5, 0}, {-0.4, -1, 1.4}}, 0, true});
  scene.objects.push_back(
      {"ring", torus({1.2, -0.6, 0.7}, {0, 0.3, 1}, 0.4, 0.1, 12, 8, true), 0, true});
  AreaLight panel;
  panel.point.origin = {0.2, 0.1, 3}, panel.normal = Vector{0, 0.1, -1};
  panel.width = 1.5, panel.height = 0.7, panel.columns = 4, panel.rows = 3;
  scene.lights = {make_light(panel)};
  RenderOptions all;
  all.effects = all_effects();  // culls nothing
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    for (const double away : {0.0, 1e4}) {  // far from the origin the margins count
      Scene moved = scene;
      const Vector by(away, -away, 0);
      moved.camera.eye += by, moved.camera.target += by;
      for (Object& object : moved.objects) move(object, by);
      std::get<AreaLight>(moved.lights[0].shape).point.origin += by;
      RenderOptions culled{precision};
      all.precision = precision;
      expect_same(render(moved, culled), render(moved, all), std::to_string(away));
    }
  }
}

bool differs_without(const Scene& scene, bool Effects::*effect) {
  RenderOptions options;
  options.effects = effects_of(scene);
  (*options.effects).*effect = false;
  return render(scene, options).whole.pixels != render(scene).whole.pixels;
}

TEST(Kernel, GivesOtherBitsWhereANeededEffectIsLeftOut) {  // the control
  for (const EffectName& effect : effect_names()) {
    EXPECT_TRUE(std::ranges::any_of(canonical_scenes(), [&](const Scene& scene) {
      return effects_of(scene).*effect.member && differs_without(scene, effect.member);
    })) << effect.name;
  }
}

Rendering counted(const Scene& scene, RenderOptions options = {}) {
  options.counts = true, options.edges = false;
  return render(scene, options);
}

TEST(Counts, AreTheSameForPacketsAndScalars) {
  for (const Scene& scene : canonical_scenes()) {
    const Counts packets = counted(scene).counts, scalars = counted(scene, scalar()).counts;
    for (const CountName& count : count_names()) {
      EXPECT_EQ(packets.*count.member, scalars.*count.member) << scene.name << " " << count.name;
    }
    EXPECT_EQ(scalars.camera_rays, 37u * 29u * unsigned(scene.samples * scene.samples));
  }
}

TEST(Counts, AreZeroForWhatTheSceneDoesNotCallFor) {
  for (const Scene& scene : canonical_scenes()) {
    const Counts counts = counted(scene).counts;
    const Effects effects = effects_of(scene);
    EXPECT_TRUE(effects.shadows || counts.shadow_rays == 0) << scene.name;
    EXPECT_TRUE(effects.linear || counts.linear == 0) << scene.name;
    EXPECT_TRUE(effects.quadratic || counts.quadratic == 0) << scene.name;
    EXPECT_TRUE(effects.cone || counts.cones == 0) << scene.name;
    EXPECT_TRUE(effects.specular || counts.powers == 0) << scene.name;
  }
}

TEST(Counts, HaveOneShadowRayForEachPointThatFacesTheLamp) {
  Scene scene = floor_from_above(40);
  scene.objects.push_back({"lid", Sphere{{0, 0, 40}, 1}, 0, false});
  scene.lights = {sun({0, 0, -1})};
  EXPECT_EQ(counted(scene).counts.shadow_rays, 1600u);
  scene.lights = {sun({0, 0, 1})};  // from below
  EXPECT_EQ(counted(scene).counts.shadow_rays, 0u);
}

TEST(Counts, HaveOneConeForEachPointThatMayBeInIt) {
  Scene scene = floor_from_above(40);
  scene.lights = {make_light(SpotLight{{{0, 0, 2}, {}}, {0, 0, -1}, std::atan(0.5), 1}, "spot")};
  const double inside = 3.14159265 * 1600 / 36;  // a circle of radius 1 on a square of side 6
  EXPECT_NEAR(double(counted(scene).counts.cones), inside, 20);
}

}  // namespace
}  // namespace litmus

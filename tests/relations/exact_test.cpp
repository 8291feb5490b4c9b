// exact_test.cpp: relations between pictures of every canonical scene that hold bit by bit.
#include <gtest/gtest.h>

#include <map>

#include "tests/relations/moved_scene.h"
#include "tracer/render.h"

namespace litmus {
namespace {

constexpr int kSide = 24;

const std::vector<Scene>& exact_scenes() {
  static const std::vector<Scene> all = small_canonical_scenes(kSide);
  return all;
}

Picture picture(const Scene& scene) { return render(scene).whole; }

/// How many pixels differ in any bit (or both being NaN, in nothing).
int differing(const Picture& a, const Picture& b) {
  int count = std::abs(int(a.pixels.size()) - int(b.pixels.size()));
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
    count += a.pixels[i] != b.pixels[i];
  return count;
}

/// The picture times 2^k, exactly.
Picture times(Picture picture, double factor) {
  for (glm::dvec3& pixel : picture.pixels) pixel *= factor;
  return picture;
}

TEST(Relations, CoverEveryCanonicalScene) { EXPECT_GE(exact_scenes().size(), 33u); }

TEST(Relations, NoticeAPictureThatIsOffByOneBit) {
  Picture a = picture(exact_scenes()[0]), b = a;
  EXPECT_EQ(differing(a, b), 0);
  b.pixels[5].y = std::nextafter(b.pixels[5].y, 2);
  EXPECT_EQ(differing(a, b), 1);
}

//
TEST(Relations, ScalingAllLengthsByAPowerOfTwoChangesNoBit) {
  for (const Scene& scene : exact_scenes()) {
    const Picture expected = picture(scene);
    for (int k = -40; k <= 40; ++k)
      EXPECT_EQ(differing(picture(moved(scene, scaling(k))), expected), 0)
          << scene.name << " 2^" << k;
  }
}

//
TEST(Relations, MirroringTheSceneMirrorsThePictureBitByBit) {
  for (const Scene& scene : exact_scenes()) {
    const Picture straight = picture(scene);
    Picture mirrored = picture(moved(scene, mirroring()));
    for (int y = 0; y < mirrored.height; ++y)
      std::reverse(&mirrored.at(0, y), &mirrored.at(0, y) + mirrored.width);
    EXPECT_EQ(differing(mirrored, straight), 0) << scene.name;
  }
}

//
TEST(Relations, IntensitiesTimesAPowerOfTwoMultiplyThePictureExactly) {
  for (const Scene& scene : exact_scenes()) {
    const Picture expected = picture(scene);
    for (int k = -40; k <= 40; k += 8) {
      Scene brighter = scene;
      const double factor = std::ldexp(1.0, k);
      for (Light& light : brighter.lights) light.intensity *= factor;
      brighter.ambient *= factor;
      EXPECT_EQ(differing(picture(brighter), times(expected, factor)), 0)
          << scene.name << " 2^" << k;
    }
  }
}

//
TEST(Relations, ALightInTwoHalvesIsTheLight) {
  for (const Scene& scene : exact_scenes()) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      Scene one = scene, two = scene;
      one.lights = {scene.lights[i]};
      Light half = scene.lights[i];
      half.intensity /= 2, half.ambient = Color(0);
      one.lights[0].ambient = Color(0);
      two.lights = {half, half};
      if (scene.shading == Shading::SampleCode) one.ambient = two.ambient = Color(0);
      const Picture whole = render(one).layers[1].picture;
      const Layers halves = render(two).layers;
      Picture sum = halves[1].picture;
      for (std::size_t p = 0; p < sum.pixels.size(); ++p)
        sum.pixels[p] += halves[2].picture.pixels[p];
      EXPECT_EQ(differing(sum, whole), 0) << scene.name << ", " << scene.lights[i].name;
    }
  }
}

TEST(Relations, PermutingTheChannelsPermutesThePicture) {
  const auto turn = [](Color& c) { c = Color(c.z, c.x, c.y); };
  for (const Scene& scene : exact_scenes()) {
    Scene turned = scene;
    turn(turned.ambient);
    for (Material& m : turned.materials) turn(m.ambient), turn(m.diffuse), turn(m.specular);
    for (Light& light : turned.lights)
      turn(light.diffuse), turn(light.specular), turn(light.ambient);
    Picture expected = picture(scene);
    for (glm::dvec3& pixel : expected.pixels) turn(pixel);
    EXPECT_EQ(differing(picture(turned), expected), 0) << scene.name;
  }
}

//
TEST(Relations, TheOrderOfObjectsDoesNotMatter) {
  for (const Scene& scene : exact_scenes()) {
    Scene reversed = scene;
    std::reverse(reversed.objects.begin(), reversed.objects.end());
    EXPECT_EQ(differing(picture(reversed), picture(scene)), 0) << scene.name;
  }
}

//
TEST(Relations, ALightOfIntensityZeroChangesNothing) {
  for (const Scene& scene : exact_scenes()) {
    Scene more = scene;
    for (Light light : scene.lights) {
      light.intensity = 0, light.name += " off";
      more.lights.insert(more.lights.begin(), light);
    }
    EXPECT_EQ(differing(picture(more), picture(scene)), 0) << scene.name;
  }
}

//
TEST(Relations, AnObjectBehindTheEyeAndBelowEveryShadowChangesNothing) {
  for (const Scene& scene : exact_scenes()) {
    Scene more = scene;
    // Below the floor that all of them have, or far away where there is none.
    more.objects.push_back({"far", Sphere{{0, 0, -1e6}, 1}, 0, false});
    bool open_below = false;
    for (const Light& light : scene.lights) {
      const auto* sun = std::get_if<DirectionalLight>(&light.shape);
      open_below = open_below || (sun && sun->direction.z > 0);
    }
    if (open_below) continue;
    EXPECT_EQ(differing(picture(more), picture(scene)), 0) << scene.name;
  }
}

//
TEST(Relations, APointLightIsAnAreaLightOfOneSample) {
  int changed = 0;
  for (const Scene& scene : exact_scenes()) {
    Scene areas = scene;
    for (Light& light : areas.lights) {
      const auto* point = std::get_if<PointLight>(&light.shape);
      if (!point) continue;
      AreaLight area;
      area.point = *point, area.normal = Vector(0.3, -0.2, -1), area.width = 3, area.height = 2;
      light.shape = area;
      ++changed;
    }
    EXPECT_EQ(differing(picture(areas), picture(scene)), 0) << scene.name;
  }
  EXPECT_GT(changed, 5);
}

// X-10, L-23
TEST(Relations, AHugeRangeIsNoAttenuation) {
  for (const Scene& scene : exact_scenes()) {
    Scene far = scene, none = scene;
    for (Scene* one : {&far, &none}) {
      for (Light& light : one->lights) {
        Attenuation* attenuation = nullptr;
        if (auto* point = std::get_if<PointLight>(&light.shape)) attenuation = &point->attenuation;
        if (auto* spot = std::get_if<SpotLight>(&light.shape))
          attenuation = &spot->point.attenuation;
        if (auto* area = std::get_if<AreaLight>(&light.shape))
          attenuation = &area->point.attenuation;
        if (!attenuation) continue;
        *attenuation = one == &far ? Attenuation{1e300, 1, 1} : Attenuation{};
      }
    }
    EXPECT_EQ(differing(picture(far), picture(none)), 0) << scene.name;
  }
}

//
TEST(Relations, TheNumberOfThreadsDoesNotMatter) {
  for (const Scene& scene : exact_scenes()) {
    RenderOptions one, four;
    one.threads = 1, four.threads = 4;
    EXPECT_EQ(differing(render(scene, one).whole, render(scene, four).whole), 0) << scene.name;
  }
}

/// The middle of the picture, half as wide and high, as a scene of its own; the scene's field of
/// view is changed by a few units in the last place so that the halved one is exact.
std::pair<Scene, Scene> whole_and_middle(Scene scene) {
  scene.width = scene.height = kSide;
  Scene middle = scene;
  middle.width = middle.height = kSide / 2;
  if (scene.camera.projection == Projection::Orthographic) {
    middle.camera.height /= 2;
    return {scene, middle};
  }
  for (int i = 0; i < 1000; ++i) {
    const double half = std::tan(scene.camera.fov / 2) / 2;
    double fov = 2 * std::atan(half);
    for (int j = 0; j < 4; ++j) fov = std::nextafter(fov, 0);
    for (int j = 0; j < 8; ++j, fov = std::nextafter(fov, 7)) {
      middle.camera.fov = fov;
      if (std::tan(fov / 2) == half) return {scene, middle};
    }
    scene.camera.fov = std::nextafter(scene.camera.fov, 7);
  }
  ADD_FAILURE() << scene.name << ": no field of view can be halved";
  return {scene, middle};
}

//
TEST(Relations, TheMiddleOfAPictureIsThePictureOfTheMiddle) {
  for (const Scene& scene : exact_scenes()) {
    const auto [whole, middle] = whole_and_middle(scene);
    const Picture all = picture(whole);
    Picture cut(kSide / 2, kSide / 2);
    for (int y = 0; y < cut.height; ++y)
      for (int x = 0; x < cut.width; ++x) cut.at(x, y) = all.at(x + kSide / 4, y + kSide / 4);
    EXPECT_EQ(differing(picture(middle), cut), 0) << scene.name;
  }
}

//
TEST(Relations, TurningAnAreaLightAroundChangesNothing) {
  int changed = 0;
  for (const Scene& scene : exact_scenes()) {
    Scene straight = scene, turned = scene;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      const auto* area = std::get_if<AreaLight>(&scene.lights[i].shape);
      if (!area) continue;
      const Vector n = area->normal ? *area->normal : -area->point.origin;
      const Vector right = n.x == 0 && n.y == 0 ? Vector(1, 0, 0) : Vector(-n.y, n.x, 0);
      std::get<AreaLight>(straight.lights[i].shape).right = right;
      std::get<AreaLight>(turned.lights[i].shape).right = -right;
      ++changed;
    }
    EXPECT_EQ(differing(picture(turned), picture(straight)), 0) << scene.name;
  }
  EXPECT_GT(changed, 3);
}

}  // namespace
}  // namespace litmus

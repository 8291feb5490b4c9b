// sample_scene.h: a small scene, a picture and a folder for the tests of reference/.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

/// A scene with a point light and a sun; `ambient` makes it another scene.
inline Scene sample_scene(const std::string& name, double ambient = 0.1) {
  Scene scene;
  scene.name = name;
  scene.width = 6;
  scene.height = 4;
  scene.camera.up = {0, 1, 0};
  scene.ambient = Color(ambient);
  scene.materials.push_back({});
  scene.objects.push_back({"ball", Sphere{}, 0, true});
  scene.lights.push_back({.name = "key", .shape = PointLight{Point(0, 0, 4), {}}});
  scene.lights.push_back({.name = "sun", .shape = DirectionalLight{}});
  return scene;
}

/// A white light of intensity 1, named "light".
inline Light light_of(decltype(Light::shape) shape) {
  Light light;
  light.name = "light";
  light.shape = std::move(shape);
  return light;
}

/// A picture whose every value follows from `seed` and is a 32-bit float exactly.
inline Picture sample_picture(int width, int height, double seed) {
  const double base = std::round(seed * 64) / 64;
  Picture picture(width, height);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = glm::dvec3(base + double(i) / 256, -base, base + 0.5);
  return picture;
}

/// The layers of a scene, each from its own seed.
inline Layers sample_layers(const Scene& scene, double seed) {
  Layers layers{{"ambient", "ambient", sample_picture(scene.width, scene.height, seed)}};
  for (const auto& light : scene.lights)
    layers.push_back({light.name, std::string(light_type(light)),
                      sample_picture(scene.width, scene.height, ++seed)});
  return layers;
}

inline bool same(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return (std::stringstream() << in.rdbuf()).str();
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// A test with a folder of its own, which goes afterwards.
struct InFolder : testing::Test {
  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) /
      ("litmus-" + std::to_string(::getpid()) + "-" +
       testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() + "-" +
       testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
};

}  // namespace litmus

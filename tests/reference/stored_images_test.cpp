// stored_images_test.cpp: shipped images are used for exactly the scene they were made from.
#include "reference/stored_images.h"

#include <gmock/gmock.h>

#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct StoredImages : InFolder {
  Scene scene = sample_scene("ball");
  StoredReference images{sample_layers(scene, 1), "3.7.0.10", "povray +Iball.pov", 0.5};

  void expect_refused(const Scene& now, const std::string& reason) const {
    const auto found = load_stored(now, "povray", folder);
    EXPECT_FALSE(found.images);
    EXPECT_THAT(found.reason, HasSubstr(reason));
    EXPECT_THAT(found.reason, HasSubstr("litmus run --refresh"));
  }
};

TEST_F(StoredImages, AreReadAsTheyWereSaved) {
  save_stored(scene, "povray", images, folder);
  const auto found = load_stored(scene, "povray", folder);
  ASSERT_TRUE(found.images) << found.reason;
  ASSERT_EQ(found.images->layers.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(found.images->layers[i].light, images.layers[i].light);
    EXPECT_EQ(found.images->layers[i].light_type, images.layers[i].light_type);
    EXPECT_TRUE(same(found.images->layers[i].picture, images.layers[i].picture));
  }
  EXPECT_EQ(found.images->version, "3.7.0.10");
  EXPECT_EQ(found.images->command, "povray +Iball.pov");
  EXPECT_EQ(found.images->seconds, 0.5);
}

TEST_F(StoredImages, OfOneRendererNeverStandInForAnother) {
  save_stored(scene, "povray", images, folder);
  const auto found = load_stored(scene, "blender", folder);
  EXPECT_FALSE(found.images);
  EXPECT_EQ(found.reason, "no stored blender image of ball");
}

TEST_F(StoredImages, OfAnotherVersionOfTheSceneAreRefused) {
  save_stored(scene, "povray", images, folder);
  expect_refused(sample_scene("ball", 0.2), "made from another version of this scene");
}

TEST_F(StoredImages, WithAnotherChecksumAreRefused) {
  save_stored(scene, "povray", images, folder);
  const auto image = folder / "ball" / "povray.exr";
  auto bytes = text_of(image);
  bytes.back() ^= 1;
  write_text(image, bytes);
  expect_refused(scene, "checksum");
}

TEST_F(StoredImages, WithoutDescriptionAreRefused) {
  save_stored(scene, "povray", images, folder);
  fs::remove(folder / "ball" / "povray.json");
  expect_refused(scene, "povray.json is missing");
}

TEST_F(StoredImages, MayBeRefreshed) {
  save_stored(scene, "povray", images, folder);
  scene = sample_scene("ball", 0.2);
  images.layers = sample_layers(scene, 7);
  save_stored(scene, "povray", images, folder);
  const auto found = load_stored(scene, "povray", folder);
  ASSERT_TRUE(found.images);
  EXPECT_TRUE(same(found.images->layers[2].picture, images.layers[2].picture));
}

TEST_F(StoredImages, MustBeTheLayersOfTheScene) {
  EXPECT_EQ(misfit(scene, images.layers), "");
  auto layers = images.layers;
  layers.pop_back();
  EXPECT_EQ(misfit(scene, layers), "2 layers where the scene has 3");
  layers = images.layers;
  std::swap(layers[1], layers[2]);
  EXPECT_EQ(misfit(scene, layers), "layer 1 is sun (directional) where the scene has key (point)");
  layers = images.layers;
  layers[1].picture = sample_picture(5, 4, 1);
  EXPECT_EQ(misfit(scene, layers), "layer key is 5 x 4 pixels where the scene has 6 x 4");
  images.layers = layers;
  EXPECT_THROW(save_stored(scene, "povray", images, folder), Refusal);
}

}  // namespace
}  // namespace litmus

// alignment_test.cpp: small shifts of real scenes, and lamps that only look like one.
#include "reports/alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/regions.h"
#include "scene/load.h"

namespace litmus {
namespace {
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Our side of a study: the outlines, and the whole.
Case case_of(const Scene& scene, const RenderOptions& options) {
  Rendering rendering = render(scene, options);
  std::vector<std::uint8_t> any(rendering.whole.pixels.size());
  for (const Signature& signature : rendering.signatures) {
    const std::vector<std::uint8_t> edge = edge_mask(signature);
    for (std::size_t i = 0; i < edge.size(); ++i) any[i] |= edge[i];
  }
  Case entry;
  entry.layers = {{"ambient", "ambient", {}, edge_mask(rendering.signatures[0]), {}},
                  {"all", "all", rendering.whole, any, {}}};
  return entry;
}

Registration against_the_right_one(const Scene& ours, const RenderOptions& options,
                                   const Scene& right) {
  return align(ours, options, case_of(ours, options), render(right).whole);
}

class Shifted : public testing::TestWithParam<const char*> {};

TEST_P(Shifted, ByThreeHundredthsIsCalledUnregistered) {
  const Scene scene = load_scene(find_scene(GetParam()));
  RenderOptions options;
  options.shift_x = 0.024, options.shift_y = -0.018;
  const Registration found = against_the_right_one(scene, options, scene);
  EXPECT_NEAR(found.dx, -0.024, 0.001);
  EXPECT_NEAR(found.dy, 0.018, 0.001);
  EXPECT_THAT(unregistered(found), StartsWith("unregistered: shifted by (-0.024, 0.018) px"));
}

TEST_P(Shifted, ByOneHundredthIsNot) {
  const Scene scene = load_scene(find_scene(GetParam()));
  RenderOptions options;
  options.shift_x = 0.006, options.shift_y = 0.008;
  const Registration found = against_the_right_one(scene, options, scene);
  EXPECT_TRUE(found.determined);
  EXPECT_NEAR(found.dx, -0.006, 0.001);
  EXPECT_EQ(unregistered(found), "");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Shifted,
                         testing::Values("c2", "d2", "d3", "d4", "n1", "s10", "v5", "x1", "x2",
                                         "x3", "x4", "x5"));

TEST(Align, DoesNotTakeAMovedLampForAShiftWhereNoOutlineTells) {
  const Scene right = load_scene(find_scene("p1"));
  Scene moved = right;
  std::get<PointLight>(moved.lights[0].shape).origin.x += 0.01;
  const Registration found = against_the_right_one(moved, {}, right);
  EXPECT_FALSE(found.determined);
  EXPECT_THAT(found.why, HasSubstr("(0.16, "));
  EXPECT_THAT(found.why, HasSubstr("no outline"));
  EXPECT_EQ(found.dx, 0);
}

TEST(Align, CannotTellWhereFlatFacetsAreAllThereIs) {
  const Scene scene = load_scene(find_scene("d9"));
  RenderOptions options;
  options.shift_x = 0.5;
  const Registration found = against_the_right_one(scene, options, scene);
  EXPECT_FALSE(found.determined);
  EXPECT_THAT(found.why, HasSubstr("creases between flat pieces"));
}

TEST(Align, DoesNotTakeAMovedLampForAShiftWhereOutlinesStay) {
  const Scene right = load_scene(find_scene("v5"));
  Scene moved = right;
  for (Light& light : moved.lights)
    if (auto* point = std::get_if<PointLight>(&light.shape)) point->origin.x += 0.01;
  const Registration found = against_the_right_one(moved, {}, right);
  EXPECT_TRUE(found.determined);
  EXPECT_GT(std::hypot(found.dx, found.dy), 0.1);  // so it looks, inside
  EXPECT_LT(found.explained, 0.1);
  EXPECT_EQ(unregistered(found), "");
}

Registration half_a_pixel() {
  Registration found;
  found.determined = true, found.dx = -0.5, found.explained = 0.999;
  return found;
}

Comparison row(const std::string& light, const std::string& region, const std::string& verdict) {
  Comparison result;
  result.light = light, result.region = region, result.verdict = verdict;
  result.reason = verdict == "fail" ? "the largest difference" : "";
  result.hint = verdict == "fail" ? "ours is 2 times theirs" : "";
  return result;
}

TEST(BlameTheCamera, ReplacesTheReasonOfRowsThatFail) {
  std::vector<Comparison> rows{row("sun", "interior", "fail"), row("sun", "edge", "pass"),
                               row("sun", "all", "fail"), row("all", "all", "fail")};
  blame_the_camera(rows, half_a_pixel());
  for (const std::size_t i : {0u, 2u, 3u}) {
    EXPECT_THAT(rows[i].reason, StartsWith("unregistered: shifted by (-0.5, 0) px"));
    EXPECT_EQ(rows[i].hint, "");
    EXPECT_EQ(rows[i].verdict, "fail");
  }
  EXPECT_EQ(rows[1].verdict, "pass");
}

TEST(BlameTheCamera, FailsTheWholePictureEvenWithinTolerance) {
  std::vector<Comparison> rows{row("all", "all", "pass")};
  blame_the_camera(rows, half_a_pixel());
  EXPECT_EQ(rows[0].verdict, "fail");
}

TEST(BlameTheCamera, LeavesRowsOfNaNAloneAndAllRowsOfARegisteredScene) {
  std::vector<Comparison> rows{row("sun", "interior", "fail")};
  rows[0].nonfinite = 1;
  blame_the_camera(rows, half_a_pixel());
  EXPECT_EQ(rows[0].reason, "the largest difference");
  rows[0].nonfinite = 0;
  blame_the_camera(rows, {});
  EXPECT_EQ(rows[0].reason, "the largest difference");
}

}  // namespace
}  // namespace litmus

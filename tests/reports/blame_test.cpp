// blame_test.cpp: quad precision says whose error a difference is.
#include "reports/blame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/regions.h"
#include "tests/tracer/scenes.h"
#include "tracer/render.h"

namespace litmus {
namespace {
using testing::HasSubstr;

Scene lit_floor() {
  Scene scene = floor_from_above(16);
  scene.name = "floor";
  scene.objects.push_back({"ball", Sphere{{0.3, 0.1, 1.2}, 0.8}, 0, false});
  scene.lights = {sun({-0.3, -0.2, -1})};
  return scene;
}

/// A study of one failing row: the light of the scene, our picture and theirs spoiled as told.
Study study_of(const Scene& scene, void (*spoil_ours)(Picture&), void (*spoil_theirs)(Picture&),
               const std::string& region) {
  const Rendering rendering = render(scene);
  CaseLayer layer;
  layer.light = "sun", layer.light_type = "directional";
  layer.ours = rendering.layers[1].picture;
  layer.edge = edge_mask(rendering.signatures[1]);
  layer.theirs = {{"povray", "live", layer.ours}};
  spoil_ours(layer.ours), spoil_theirs(layer.theirs[0].picture);
  CaseLayer ambient;
  ambient.light = ambient.light_type = "ambient";
  ambient.ours = rendering.layers[0].picture;
  Case one;
  one.scene = scene.name;
  one.layers = {ambient, layer};
  Comparison row;
  row.scene = scene.name, row.reference = "povray", row.light = "sun", row.region = region;
  row.verdict = "fail", row.tolerance = 1e-6, row.over_tolerance = 1;
  Study study;
  study.cases = {one}, study.comparisons = {row};
  add_blame(study, std::span(&scene, 1));
  return study;
}

void leave(Picture&) {}
void brighten(Picture& picture) {
  for (glm::dvec3& pixel : picture.pixels) pixel *= 1.01;
}
void black_out(Picture& picture) { picture = Picture(picture.width, picture.height); }

TEST(Blame, IsOursWhereTheReferenceIsNearerToTheTruth) {
  const Study study = study_of(lit_floor(), brighten, leave, "interior");
  ASSERT_TRUE(study.comparisons[0].blame);
  const Blame& blame = *study.comparisons[0].blame;
  EXPECT_EQ(blame.verdict, "ours");
  EXPECT_EQ(blame.ours, blame.pixels);
  EXPECT_GT(blame.our_error, 1e-3);
  EXPECT_LT(blame.their_error, 1e-14);
  EXPECT_THAT(blame_sentence(blame, "POV-Ray"), HasSubstr("ours: in 6 of 6 pixels"));
}

TEST(Blame, IsTheReferencesWhereWeAreNearer) {
  const Study study = study_of(lit_floor(), leave, brighten, "interior");
  ASSERT_TRUE(study.comparisons[0].blame);
  EXPECT_EQ(study.comparisons[0].blame->verdict, "the reference's");
  EXPECT_THAT(blame_sentence(*study.comparisons[0].blame, "POV-Ray"),
              HasSubstr("POV-Ray's: in 6 of 6"));
}

TEST(Blame, IsOursForAPlantedMistakeInOurScene) {
  // The truth is the scene as the references got it.
  const Scene scene = lit_floor();
  Study study = study_of(scene, leave, leave, "interior");
  Scene mistaken = scene;
  mistaken.lights[0].intensity = 1.01;
  study.cases[0].layers[1].ours = render(mistaken).layers[1].picture;
  add_blame(study, std::span(&scene, 1));
  ASSERT_TRUE(study.comparisons[0].blame);
  EXPECT_EQ(study.comparisons[0].blame->verdict, "ours");
}

TEST(Blame, IsIllConditionedOnABoundary) {
  // An edge of the box's shadow passes through the centre of a column of pixels.
  Scene scene = floor_from_above(16);
  scene.name = "floor";
  const double column = floor_point(scene, 8, 0).x;
  scene.objects.push_back({"wall", Box{{column, -9, 1}, {9, 9, 2}}, 0, false});
  scene.lights = {sun({0, 0, -1})};
  const Study study = study_of(
      scene, leave,
      [](Picture& theirs) {
        for (int y = 0; y < theirs.height; ++y)
          theirs.at(8, y) = theirs.at(8, y).x > 0 ? Color(0) : Color(0.8);
      },
      "all");
  ASSERT_TRUE(study.comparisons[0].blame);
  EXPECT_EQ(study.comparisons[0].blame->verdict, "ill-conditioned");
  EXPECT_EQ(study.comparisons[0].blame->ill_conditioned, 6);
}

TEST(Blame, IsNotSoughtWhereNothingFails) {
  const Scene scene = lit_floor();
  Study study = study_of(scene, leave, black_out, "interior");
  study.comparisons[0].verdict = "pass";
  study.comparisons[0].blame.reset();
  add_blame(study, std::span(&scene, 1));
  EXPECT_FALSE(study.comparisons[0].blame);
}

TEST(Blame, IsNotSoughtAgainstClosedForms) {
  const Scene scene = lit_floor();
  Study study = study_of(scene, leave, black_out, "interior");
  study.comparisons[0].blame.reset();
  study.comparisons[0].reference = study.cases[0].layers[1].theirs[0].reference = "closed-form";
  add_blame(study, std::span(&scene, 1));
  EXPECT_FALSE(study.comparisons[0].blame);
}

TEST(Blame, IsNotSoughtInSpectralScenes) {
  Scene scene = lit_floor();
  scene.spectra.emplace();
  Study study = study_of(lit_floor(), leave, black_out, "interior");
  ASSERT_TRUE(study.comparisons[0].blame);
  study.comparisons[0].blame.reset();
  add_blame(study, std::span(&scene, 1));
  EXPECT_FALSE(study.comparisons[0].blame);
}

TEST(Blame, CountsAValueThatIsNoNumberAgainstItsOwner) {
  const Witness theirs{{1, 1, 1}, {NAN, 1, 1}, {1, 1, 1}, false};
  EXPECT_EQ(judge_witnesses(std::span(&theirs, 1)).verdict, "the reference's");
  const Witness ours{{1, NAN, 1}, {1, 1, 1}, {1, 1, 1}, false};
  EXPECT_EQ(judge_witnesses(std::span(&ours, 1)).verdict, "ours");
}

}  // namespace
}  // namespace litmus

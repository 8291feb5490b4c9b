// peer_renderers_test.cpp: the stage as POV-Ray's lights.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/peer_entrants.h"
#include "reports/stage.h"

namespace litmus {
namespace {

using testing::HasSubstr;

int lights(const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find("light_source"); at != std::string::npos;
       at = text.find("light_source", at + 1))
    ++count;
  return count;
}

TEST(PovrayLamps, AreOneForEachSample) {
  EXPECT_THAT(povray_lamps(point_stage(8)), HasSubstr("light_source { <4, -4, 6>, rgb 1/1 "));
  EXPECT_EQ(lights(povray_lamps(area_stage(8, 8))), 64);
  EXPECT_THAT(povray_lamps(area_stage(8, 8)), HasSubstr("rgb 1/64 "));
}

TEST(PovrayAreaLight, IsOneLightWithAGrid) {
  const std::string text = povray_area_light(area_stage(8, 8));
  EXPECT_EQ(lights(text), 1);
  EXPECT_THAT(text, HasSubstr(", 8, 8 }"));
}

TEST(PovrayStage, HasTheSolidsAndTheFinishOfTheScene) {
  const std::string text = povray_stage(stage(8));
  EXPECT_THAT(text, HasSubstr("sphere { <0.2, -1.5, 0.5>, 0.5 }"));
  EXPECT_THAT(text, HasSubstr("box { <2, -1, 0>, <2.8, 0, 1.2> }"));
  EXPECT_THAT(text, HasSubstr("plane { <0, 0, 1>, 0 }"));
  EXPECT_THAT(text, HasSubstr("diffuse 0.7 specular 0.3 roughness 0.025 "));
}

}  // namespace
}  // namespace litmus

// effects_study_test.cpp: needed effects beside all of them.
#include "reports/effects_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/html_effects.h"
#include "reports/stage.h"

namespace litmus {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MeasureEffects, CountsWhatIsLeftOutAndFindsTheSameBits) {
  const Scene scenes[] = {diffuse_stage(24), point_stage(24)};
  const std::vector<EffectUse> uses = measure_effects(scenes, {.quick = true});
  ASSERT_EQ(uses.size(), 2u);
  EXPECT_TRUE(uses[0].identical);
  EXPECT_TRUE(uses[1].identical);
  EXPECT_EQ(uses[0].needed.shadow_rays, 0u);
  EXPECT_GT(uses[0].all.shadow_rays, 0u);
  EXPECT_GT(uses[1].needed.powers, 0u);
  EXPECT_GT(uses[0].all_time.least, 0);
}

TEST(SameBits, SeesAnEffectThatIsMissing) {
  const Scene scene = point_stage(24);
  Effects matte = effects_of(scene);
  matte.specular = false;
  EXPECT_TRUE(same_bits(render(scene), render(scene)));
  EXPECT_FALSE(same_bits(render(scene), render(scene, {.effects = matte})));
}

TEST(SameBits, SeesTheSignOfZeroInALayer) {
  Rendering plus;
  plus.layers = {{"lamp", "point", Picture(1, 1)}};
  Rendering minus = plus;
  minus.layers[0].picture.pixels[0].x = -0.0;
  EXPECT_FALSE(same_bits(plus, minus));
}

EffectUse use(const std::string& scene, double needed, double all) {
  EffectUse use{.scene = scene};
  use.called_for.diffuse = use.called_for.specular = true;
  use.needed.powers = 25, use.all.powers = 100, use.all.shadow_rays = 1200;
  use.needed_time.least = needed, use.all_time.least = all;
  use.identical = true;
  return use;
}

TEST(EffectsSentence, NamesTheMedianAndAPictureThatDiffers) {
  std::vector<EffectUse> uses{use("a", 1, 2), use("b", 1, 3), use("c", 1, 9)};
  EXPECT_THAT(effects_sentence(uses), HasSubstr("takes 3 times as long"));
  EXPECT_THAT(effects_sentence(uses), HasSubstr("(2 to 9; median of 3 scenes); all pictures are"));
  uses[0].identical = false;
  EXPECT_THAT(effects_sentence(uses), HasSubstr("only 2 pictures are"));
}

TEST(EffectsSection, HasAShareForWhatIsCalledForAndCountsForTheRest) {
  CostStudy study;
  EXPECT_EQ(effects_section(study), "");
  study.effects = {use("plain", 1, 2), use("<b>", 1, 4)};
  study.effects_left_out = {"w1 needs colord-data"};
  const std::string html = effects_section(study);
  EXPECT_THAT(html, HasSubstr("<td title=\"25 of 100\">25 %</td>"));
  EXPECT_THAT(html, HasSubstr("<td title=\"0 of 1,200\" class=\"dim\">\u2013</td>"));
  EXPECT_THAT(html, HasSubstr("Left out: w1 needs colord-data"));
  EXPECT_LT(html.find("&lt;b&gt;"), html.find("plain")) << "the largest saving first";
  EXPECT_THAT(html, Not(HasSubstr("differs")));
  study.effects[0].identical = false;
  EXPECT_THAT(effects_section(study), HasSubstr("<td class=\"word bad\">differs</td>"));
}

}  // namespace
}  // namespace litmus

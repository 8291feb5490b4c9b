// write_cost_test.cpp: a quick study of a small scene, as JSON against its schema and as a page.
#include "reports/write_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>


#include "reports/cost_study.h"
#include "reports/effects_study.h"
#include "scene/load.h"
#include "tests/json_schema.h"

namespace litmus {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const CostStudy& small_study() {
  static const CostStudy study = [] {
    Scene scene = load_scene(find_scene("r3"));
    scene.about = "</script> & \"<b>\"";
    CostStudy measured = measure_cost(scene, {.quick = true, .width = 20});
    measured.effects = measure_effects({&scene, 1}, {.quick = true});
    return measured;
  }();
  return study;
}

const CostSeries& series(const CostStudy& study, std::string_view name) {
  for (const CostTopic& topic : study.topics)
    for (const CostSeries& one : topic.series)
      if (one.name == name) return one;
  throw std::out_of_range(std::string(name));
}

TEST(MeasureCost, FindsTheCertifiedSamplerMoreExactAtEachNumberOfSamples) {
  const CostSeries &grid = series(small_study(), "grid"),
                   &certified = series(small_study(), "certified");
  const auto error = [](const CostPoint& p) { return p.errors.at(CostRegion::All)[0]; };
  EXPECT_GT(error(grid.points[0]), 0.1) << "one sample is far off";
  for (const CostPoint& point : certified.points) {
    EXPECT_GT(point.time.least, 0);
    for (const CostPoint& other : grid.points)
      EXPECT_TRUE(other.knob != point.knob || error(point) < error(other)) << point.words;
  }
}

TEST(MeasureCost, GetsTheOrderOfTheGridRight) {
  for (const CostFit& fit : series(small_study(), "grid").fits) {
    if (fit.metric != ErrorMetric::Rms) continue;
    if (fit.region == CostRegion::Lit) {
      EXPECT_NEAR(fit.order, -2, 0.1);
    } else if (fit.region == CostRegion::Penumbra) {
      EXPECT_NEAR(fit.order, -1.5, 0.35);
    }
  }
}

TEST(MeasureCost, KnowsItsTruthBetterThanWhatItMeasures) {
  const CostTopic& area = small_study().topics[0];
  EXPECT_EQ(area.name, "area");
  EXPECT_GT(area.truth_error.at(CostRegion::All)[0], 0);
  EXPECT_LT(area.truth_error.at(CostRegion::All)[0], 1e-3);
}

std::vector<std::string> mismatches(const json& cost) {
  return schema_mismatches("reports/cost.schema.json", cost);
}

TEST(CostJson, FollowsItsSchema) {
  const json cost = json::parse(cost_json(small_study()));
  EXPECT_THAT(mismatches(cost), testing::IsEmpty());
  json negative = cost, extra = cost;
  negative["topics"][0]["series"][0]["points"][0]["seconds"]["least"] = -1;
  extra["extra"] = 1;
  EXPECT_THAT(mismatches(negative), Not(testing::IsEmpty())) << "a control";
  EXPECT_THAT(mismatches(extra), Not(testing::IsEmpty())) << "a control";
  json unknown = cost;
  unknown["effects"][0]["identical"] = "yes";
  EXPECT_THAT(mismatches(unknown), Not(testing::IsEmpty())) << "a control";
}

TEST(CostHtml, IsOnePageWithoutTheNetworkThatEscapesTheScene) {
  const std::string page = cost_html(small_study());
  EXPECT_THAT(page, Not(HasSubstr("</script> & ")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, HasSubstr("new Chart("));
  EXPECT_THAT(page, HasSubstr("largest error you accept"));
  EXPECT_THAT(page, HasSubstr("Effects: only what a scene calls for"));
  EXPECT_THAT(page, HasSubstr("--quick: not for quoting"));
}

TEST(CostSentences, NameThePriceOfAnError) {
  EXPECT_THAT(small_study().sentences, testing::Contains(HasSubstr("Max error 0.02: ")));
  EXPECT_THAT(small_study().sentences[0], HasSubstr("certified n = "));
}

}  // namespace
}  // namespace litmus

// misreadings_test.cpp: every misreading of the slides is caught by closed forms alone, without a
// renderer or a stored image.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reference/closed_form.h"
#include "reports/controls.h"
#include "reports/study.h"
#include "scene/load.h"

namespace litmus {
namespace {

Study closed_forms_of(const std::string& scene, const std::string& control) {
  StudyOptions options;
  options.references = {kClosedForm};
  options.control = control;
  const std::vector<Scene> scenes{load_scene(find_scene(scene))};
  return run_study(scenes, options);
}

struct Misreading {
  const char *control, *scene;
};

class ClosedFormsAlone : public testing::TestWithParam<Misreading> {};

TEST_P(ClosedFormsAlone, CatchTheMisreading) {
  EXPECT_EQ(overall_verdict(closed_forms_of(GetParam().scene, "")), "pass");
  const Study wrong = closed_forms_of(GetParam().scene, GetParam().control);
  EXPECT_EQ(overall_verdict(wrong), "fail");
  for (const Comparison& row : wrong.comparisons) EXPECT_EQ(row.reference, kClosedForm);
}

INSTANTIATE_TEST_SUITE_P(
    Misreadings, ClosedFormsAlone,
    testing::Values(Misreading{"placement", "r2"}, Misreading{"placement", "r4"},
                    Misreading{"full-angle", "s1"}, Misreading{"full-angle", "s5"},
                    Misreading{"ambient-per-light", "a2"}, Misreading{"attenuation", "p2"},
                    Misreading{"attenuation", "p3"}, Misreading{"mirrored-ray", "d3"},
                    Misreading{"mirrored-ray", "p13"}, Misreading{"colors", "c2"},
                    Misreading{"behind-the-light", "p8"}),
    [](const auto& info) {
      std::string name = std::string(info.param.control) + "_in_" + info.param.scene;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

/// The rows of one layer that fail, by region.
std::set<std::string> failing_regions(const Study& study) {
  std::set<std::string> regions;
  for (const Comparison& row : study.comparisons)
    if (row.verdict == "fail" && row.light != "all") regions.insert(row.region);
  return regions;
}

TEST(ClosedFormsAlone, CatchTheShadowOfWhatIsBehindByItsCurveToo) {
  EXPECT_TRUE(failing_regions(closed_forms_of("p8", "behind-the-light")).contains("shadow-curves"));
}

TEST(ClosedFormsAlone, CatchTheFullAngleByItsConeToo) {
  EXPECT_TRUE(failing_regions(closed_forms_of("s5", "full-angle")).contains("cone-curve"));
}

TEST(ClosedFormsAlone, CatchAmbientLightPerLightByItsLevelsToo) {
  EXPECT_TRUE(failing_regions(closed_forms_of("a2", "ambient-per-light")).contains("ambient"));
}

}  // namespace
}  // namespace litmus

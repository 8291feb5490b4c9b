// study_test.cpp: the agreement itself, on the stored references, and every negative control.
#include "reports/study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compare/difference.h"
#include "compare/regions.h"
#include "compare/verdict.h"
#include "reference/closed_form.h"
#include "reports/controls.h"
#include "reports/suspects.h"
#include "scene/expect.h"
#include "scene/observer.h"
#include "scene/refusal.h"
#include "tests/reports/stored_study.h"
#include "tracer/render.h"

namespace litmus {
namespace {

/// Whether our side of a scene is another one with the control.
bool changes(const Control& control, const Scene& scene) {
  Scene mistaken = scene;
  RenderOptions options;
  control.apply(mistaken, options);
  return control.alter || options.shift_x != 0 || fingerprint(mistaken) != fingerprint(scene);
}

/// The scenes that a control changes: of the others there is nothing to learn.
std::vector<Scene> changed_by(const Control& control) {
  std::vector<Scene> changed;
  for (const Scene& scene : canonical())
    if (changes(control, scene)) changed.push_back(scene);
  return changed;
}

Study make_study(const std::string& control) {
  StudyOptions options;
  options.obtain.sources = Sources::Stored;
  options.control = control;
  return run_study(changed_by(*find_control(control)), options);
}

/// Each control's study is made once.
const Study& study_of(const std::string& control) {
  static std::map<std::string, Study> studies;
  const auto [at, is_new] = studies.try_emplace(control);
  if (is_new) at->second = make_study(control);
  return at->second;
}

/// A row's name without the region: scene, reference, light.
using Name = std::array<std::string, 3>;

std::set<Name> failing(const Study& study) {
  std::set<Name> names;
  for (const Comparison& row : study.comparisons) {
    if (row.verdict == "fail") names.insert({row.scene, row.reference, row.light});
  }
  return names;
}

const bool kTables = !colord_file("ref/CIE-TCS.sp").empty();

/// Without the CIE's tables a stored image made with them is of another light, and the row says so.
bool needs_tables(const Comparison& row) {
  return !kTables && row.verdict == "skipped" &&
         row.reason.find(kColordPackage) != std::string::npos;
}

TEST(Agreement, HoldsForEveryLightOfEverySceneAndBothReferences) {
  const Study& study = canonical_study();
  for (const Comparison& row : study.comparisons) {
    if (needs_tables(row)) continue;
    EXPECT_EQ(row.verdict, "pass") << row.scene << ", " << row.reference << ", " << row.light
                                   << ", " << row.region << ": " << row.reason;
    EXPECT_EQ(row.source, row.reference == kClosedForm ? "computed" : "stored");
    EXPECT_EQ(row.nonfinite, 0);
  }
  EXPECT_EQ(overall_verdict(study), kTables ? "pass" : "incomplete");
}

TEST(Agreement, CoversEverySceneLightTypeReferenceAndRegion) {
  const Study& study = canonical_study();
  std::set<std::string> types, scenes;
  for (const Comparison& row : study.comparisons) {
    if (row.reference == kClosedForm) continue;
    types.insert(row.light_type + " " + row.reference + " " + row.region);
    scenes.insert(row.scene + " " + row.reference);
  }
  // Interior, edge and all of six types; what is lit, in the umbra and shiny of four types of
  // light; and the penumbra of area lights.
  EXPECT_EQ(types.size(), 6u * 2 * 3 + 4 * 2 * 3 + 2);
  for (const char* reference : {"povray ", "blender "})
    EXPECT_TRUE(types.contains(std::string("area ") + reference + "penumbra"));
  EXPECT_EQ(scenes.size(), canonical().size() * 2);
}

TEST(Agreement, HoldsForEveryClosedFormThatASceneExpects) {
  std::set<std::string> seen, expected;
  for (const Comparison& row : canonical_study().comparisons)
    if (row.reference == kClosedForm) seen.insert(row.scene + " " + row.region);
  for (const Scene& scene : canonical())
    for (const Oracle oracle : scene.expect) {
      const bool picture = oracle == Oracle::Floor || oracle == Oracle::Spheres ||
                           oracle == Oracle::Boxes || oracle == Oracle::Shell ||
                           oracle == Oracle::Dark;
      EXPECT_TRUE(
          seen.contains(scene.name + " " + std::string(picture ? "interior" : name_of(oracle))))
          << scene.name << ", " << name_of(oracle);
      expected.insert(std::string(name_of(oracle)));
    }
  EXPECT_GE(expected.size(), 7u);
}

TEST(Agreement, IsBetweenAnyTwoOfLitmusTheReferencesAndTheClosedForms) {
  const Study& study = canonical_study();
  for (const Comparison& row : study.pairs)
    EXPECT_EQ(row.verdict, "pass") << row.scene << ", " << row.light << ": " << row.reference
                                   << " against " << row.against << ": " << row.reason;
  EXPECT_EQ(pair_lines(study).size(), 6u);
  for (const Comparison& row : study.comparisons) EXPECT_EQ(row.suspect, "");
}

TEST(NegativeControl, MakesLitmusTheSuspectWhereTheOthersAgree) {
  int named = 0, failed = 0;
  for (const Comparison& row : study_of("attenuation").comparisons) {
    if (row.verdict != "fail") continue;
    ++failed;
    named += row.suspect == "litmus";
    EXPECT_TRUE(row.suspect == "litmus" || row.suspect.empty()) << row.scene << ", " << row.suspect;
  }
  EXPECT_GT(named, failed * 9 / 10);
}

TEST(Agreement, OfTheReferencesLayersAddsUpToTheirWhole) {
  for (const Case& entry : canonical_study().cases) {
    for (std::size_t r = 0; r < entry.references.size(); ++r) {
      if (!kTables && entry.layers.back().theirs[r].picture.pixels.empty()) continue;
      Picture total(entry.width, entry.height);
      for (std::size_t k = 0; k + 1 < entry.layers.size(); ++k) {
        const Picture& part = entry.layers[k].theirs[r].picture;
        for (std::size_t i = 0; i < total.pixels.size(); ++i) total.pixels[i] += part.pixels[i];
      }
      const Difference d =
          difference(total, entry.layers.back().theirs[r].picture, {}, Region::All, 0);
      EXPECT_LE(d.max_abs, 1e-13) << entry.scene;
    }
  }
}

TEST(Agreement, OfOurLayersAddsUpToOurWhole) {
  for (const Scene& scene : canonical()) {
    const Rendering rendering = render(scene);
    const Difference d = difference(sum(rendering.layers), rendering.whole, {}, Region::All, 0);
    EXPECT_LE(d.max_abs, 1e-13) << scene.name;
  }
}

TEST(Agreement, IsOfCamerasToo) {
  int determined = 0;
  for (const Case& entry : canonical_study().cases) {
    for (const CaseReference& reference : entry.references) {
      const Registration& found = reference.registration;
      if (!found.determined) continue;
      ++determined;
      // A renderer's rounding shows as a shift on a floor that is lit evenly.
      const double unsure = 5 * found.uncertainty;
      EXPECT_LT(std::hypot(found.dx, found.dy), std::max(5e-4, unsure))
          << entry.scene << ", " << reference.reference;
      EXPECT_NEAR(found.scale, 1, std::max(1e-5, unsure / (entry.width / 4)))
          << entry.scene << ", " << reference.reference;
    }
  }
  EXPECT_GE(determined, 50);
}

TEST(Agreement, RestsOnNoToleranceThatIsTooWide) {
  EXPECT_TRUE(canonical_study().warnings.empty());
}

/// What a control changes in our own pictures, which decides the rows that must fail. Rows that
/// change by about a tolerance may do either.
struct Touched {
  std::set<Name> surely, perhaps;
};

Touched touched_by(const Control& control) {
  Touched touched;
  for (const Scene& scene : changed_by(control)) {
    Scene same = scene, mistaken = scene;
    RenderOptions plain, options;
    Rendering right = render_with(nullptr, same, plain).rendering,
              wrong = render_with(&control, mistaken, options).rendering;
    right.layers.push_back({"all", "all", right.whole});
    wrong.layers.push_back({"all", "all", wrong.whole});
    for (std::size_t k = 0; k < right.layers.size(); ++k) {
      const double change =
          difference(wrong.layers[k].picture, right.layers[k].picture, {}, Region::All, 0).max_abs;
      for (const char* reference : {"povray", "blender", kClosedForm}) {
        const Name name{scene.name, reference, right.layers[k].light};
        if (change > 0) touched.perhaps.insert(name);
        // Closed forms are silent about some pixels: their own test says what they must see.
        if (change > 3e-3 && reference != std::string_view(kClosedForm))
          touched.surely.insert(name);
      }
    }
  }
  return touched;
}

class NegativeControl : public testing::TestWithParam<Control> {};

TEST_P(NegativeControl, FailsOnTheRowsThatItTouchesAndOnNoOther) {
  const Study& study = study_of(std::string(GetParam().name));
  const std::set<Name> failed = failing(study);
  const Touched touched = touched_by(GetParam());
  EXPECT_EQ(overall_verdict(study), "fail");
  ASSERT_FALSE(touched.surely.empty());
  std::set<Name> left_out;
  for (const Comparison& row : study.comparisons)
    if (needs_tables(row)) left_out.insert({row.scene, row.reference, row.light});
  for (const Name& name : touched.surely) {
    if (left_out.contains(name)) continue;
    EXPECT_TRUE(failed.contains(name))
        << name[0] << ", " << name[1] << ", " << name[2] << " passes";
  }
  for (const Name& name : failed) {
    EXPECT_TRUE(touched.perhaps.contains(name))
        << name[0] << ", " << name[1] << ", " << name[2] << " fails";
  }
}

INSTANTIATE_TEST_SUITE_P(Study, NegativeControl,
                         testing::ValuesIn(controls().begin(), controls().end()),
                         [](const auto& info) {
                           std::string name(info.param.name);
                           std::erase(name, '-');
                           return name;
                         });

std::set<std::string> failing_types(const std::string& control) {
  std::set<std::string> types;
  for (const Comparison& row : study_of(control).comparisons) {
    if (row.verdict == "fail") types.insert(row.light_type);
  }
  types.erase("all");
  return types;
}

TEST_P(NegativeControl, IsCalledUnregisteredWhereItMovesTheCameraAndNowhereElse) {
  const bool moves_the_camera = GetParam().name == "half-pixel";
  for (const Comparison& row : study_of(std::string(GetParam().name)).comparisons) {
    if (row.reason.find("unregistered") == std::string::npos) continue;
    EXPECT_TRUE(moves_the_camera) << row.scene << ", " << row.light << ": " << row.reason;
  }
}

TEST(NegativeControl, OfHalfAPixelIsUnregisteredWhereverTheSceneTells) {
  const Study& study = study_of("half-pixel");
  std::set<std::string> called;
  for (const Case& entry : study.cases) {
    for (const CaseReference& reference : entry.references) {
      const Registration& found = reference.registration;
      if (!found.determined) continue;
      called.insert(entry.scene + " " + reference.reference);
      EXPECT_NEAR(found.dx, -0.5, 0.01) << entry.scene;
      EXPECT_NEAR(found.dy, 0, 0.01) << entry.scene;
      EXPECT_NE(unregistered(found), "") << entry.scene << ", explained " << found.explained;
    }
  }
  EXPECT_GE(called.size(), 28u);
  for (const Comparison& row : study.comparisons) {
    if (row.verdict != "fail") continue;
    EXPECT_EQ(row.reason.starts_with("unregistered: shifted by ("),
              called.contains(row.scene + " " + row.reference))
        << row.scene << ", " << row.light << ": " << row.reason;
  }
}

TEST(NegativeControl, OfTheIntensityIsNamedByTheHint) {
  for (const Comparison& row : study_of("intensity").comparisons) {
    if (row.verdict != "fail" || row.light_type == "all" || row.light_type == "ambient") continue;
    if (row.region == name_of(Oracle::RectangleLimit)) continue;  // a number, not a picture
    EXPECT_EQ(row.hint, "ours is 1.01 times theirs") << row.scene << ", " << row.light;
  }
}

TEST(NegativeControl, OfTheCutoffFailsSpotsOnly) {
  EXPECT_EQ(failing_types("cutoff"), std::set<std::string>{"spot"});
}

TEST(NegativeControl, OfThePlacementFailsAreasOnly) {
  EXPECT_EQ(failing_types("placement"), std::set<std::string>{"area"});
}

TEST(NegativeControl, OfTheLightsPlaceSparesTheSunAndTheAmbientLight) {
  EXPECT_EQ(failing_types("light-moved"), (std::set<std::string>{"point", "spot", "area"}));
}

TEST(NegativeControl, OfTheIntensitySparesAmbientLightThatNoLampAdds) {
  for (const Comparison& row : study_of("intensity").comparisons) {
    if (row.verdict != "fail" || row.light_type != "ambient") continue;
    const auto scene = std::find_if(canonical().begin(), canonical().end(),
                                    [&](const Scene& each) { return each.name == row.scene; });
    EXPECT_TRUE(std::any_of(scene->lights.begin(), scene->lights.end(), [](const Light& light) {
      return light.ambient != Color(0);
    })) << row.scene;
  }
}

TEST(Study, RefusesAControlOrReferenceThatDoesNotExist) {
  StudyOptions options;
  options.control = "cut-off";
  EXPECT_THROW(run_study(canonical(), options), Refusal);
  options.control.clear();
  options.references = {"mitsuba"};
  EXPECT_THROW(run_study(canonical(), options), Refusal);
}

TEST(OverallVerdict, IsBrokenByARendererThatFailed) {
  Study study;
  study.comparisons.push_back({});
  study.comparisons.back().verdict = "pass";
  EXPECT_EQ(overall_verdict(study), "pass");
  study.cases.push_back({});
  study.cases[0].references.push_back({});
  study.cases[0].references[0].failure = "povray exited with 1";
  EXPECT_EQ(overall_verdict(study), "broken");
}

TEST(OverallVerdict, OfNothingComparedIsIncomplete) {
  EXPECT_EQ(overall_verdict({}), "incomplete");
}

}  // namespace
}  // namespace litmus

// candidates_test.cpp: candidates in a study: what is judged, what is only measured.
#include "reports/candidates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/image_io.h"
#include "reports/write_json.h"
#include "reports/write_markdown.h"
#include "scene/load.h"
#include "tests/json_schema.h"
#include "tracer/render.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// Studies of d2 with a folder of images that are our own, times a factor.
class CandidateStudy : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(images / "d2-sun-sphere"); }
  void TearDown() override { fs::remove_all(images); }

  Candidate candidate(double factor) const {
    for (Layer layer : render(scene).layers) {
      for (auto& pixel : layer.picture.pixels) pixel *= factor;
      write_picture(images / "d2-sun-sphere" / (layer.light + ".exr"), layer.picture);
    }
    return {.name = "mine", .images = images};
  }
  /// The same as 8-bit sRGB.
  Candidate candidate_in_png(double factor) const {
    for (Layer layer : render(scene).layers) {
      for (auto& pixel : layer.picture.pixels) pixel *= factor;
      std::ofstream(images / "d2-sun-sphere" / (layer.light + ".png"), std::ios::binary)
          << encode_png(layer.picture);
    }
    return {.name = "mine", .images = images, .encoding = {8, true}};
  }
  Study study(const Candidate& candidate) const {
    StudyOptions options;
    options.obtain.sources = Sources::Stored;
    options.candidates = {candidate};
    return run_study(std::vector{scene}, options);
  }

  const Scene scene = load_scene(find_scene("d2"));
  const fs::path images =
      fs::path(testing::TempDir()) / ("litmus-candidate-" + std::to_string(::getpid()));
};

int failures(const std::vector<Comparison>& rows) {
  return int(std::count_if(rows.begin(), rows.end(),
                           [](const Comparison& row) { return row.verdict == "fail"; }));
}

TEST_F(CandidateStudy, JudgesACandidateBesideTheReferences) {
  const Study good = study(candidate(1));
  EXPECT_EQ(overall_verdict(good), "pass");
  EXPECT_TRUE(std::any_of(good.comparisons.begin(), good.comparisons.end(),
                          [](const Comparison& row) { return row.reference == "mine"; }));
  const Study bad = study(candidate(1.001));
  EXPECT_EQ(overall_verdict(bad), "fail");
  for (const Comparison& row : bad.comparisons)
    if (row.verdict == "fail") {
      EXPECT_EQ(row.reference, "mine");
    }
}

TEST_F(CandidateStudy, MeasuresACandidateAgainstBothReferences) {
  const Study made = study(candidate(1.001));
  for (const char* reference : {"povray", "blender"})
    EXPECT_TRUE(std::any_of(made.informative.begin(), made.informative.end(),
                            [&](const Comparison& row) {
                              return row.reference == "mine" && row.against == reference &&
                                     row.max_abs > 5e-4;
                            }))
        << reference;
  const auto lines = informative_lines(made);
  ASSERT_FALSE(lines.empty());
  for (const InformativeLine& line : lines)
    for (const auto& largest : line.largest) EXPECT_TRUE(largest.has_value());
}

TEST_F(CandidateStudy, DoesNotJudgeACandidateThatIsExpectedToDiffer) {
  Candidate different = candidate(1.5);
  different.expected_to_differ = true;
  const Study made = study(different);
  EXPECT_EQ(overall_verdict(made), "pass");
  EXPECT_GT(failures(made.informative), 0);
  for (const CaseLayer& layer : made.cases[0].layers) {
    EXPECT_EQ(layer.theirs.size(), 2u);
    EXPECT_EQ(layer.aside.size(), 1u);
  }
}

TEST_F(CandidateStudy, PassesEightBitsOfTheRightPictureAndSaysWhatTheyHide) {
  const Study made = study(candidate_in_png(1));
  EXPECT_EQ(overall_verdict(made), "pass");
  for (const Comparison& row : made.comparisons)
    if (row.reference == "mine") {
      EXPECT_THAT(row.reason, HasSubstr("png8-srgb can round away"));
    }
  ASSERT_EQ(made.candidates.size(), 1u);
  EXPECT_THAT(made.candidates[0].note, HasSubstr("mid-grey"));
}

TEST_F(CandidateStudy, FailsEightBitsThatAreFurtherOffThanTheirRounding) {
  EXPECT_EQ(overall_verdict(study(candidate_in_png(0.98))), "fail");
}

TEST_F(CandidateStudy, IsWrittenAccordingToTheSchema) {
  Candidate different = candidate(1.5);
  different.expected_to_differ = true;
  const Study made = study(different);
  const auto results = nlohmann::json::parse(results_json(made));
  ASSERT_FALSE(results["informative"].empty());
  EXPECT_THAT(schema_mismatches("reports/results.schema.json", results), IsEmpty());
  EXPECT_THAT(markdown(made), HasSubstr("For information, not judged"));
}

}  // namespace
}  // namespace litmus

// envelope_study_test.cpp: where renderers leave their envelope, and those that show nothing.
#include "reports/envelope_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

namespace litmus {
namespace {
using testing::ElementsAre;
using testing::IsEmpty;

/// A renderer whose pictures are white, but for the scenes that `fails` names.
Driver renderer(const std::string& title, bool (*fails)(const std::string& scene)) {
  Driver driver;
  driver.name = driver.title = title;
  driver.find = [] { return Installation{}; };
  driver.render = [fails](const Installation&, std::span<const Scene> scenes,
                          const ReferenceOptions&, const ResultSink& sink) {
    for (const Scene& scene : scenes) {
      ReferenceResult result;
      result.scene = scene.name;
      if (fails(scene.name)) {
        result.failure = "it gave up";
      } else {
        Picture white(scene.width, scene.height);
        std::ranges::fill(white.pixels, Color(1));
        result.layers.push_back({"all", "all", white});
      }
      sink(result);
    }
  };
  return driver;
}

std::vector<EnvelopePoint> points_of(const Driver& driver) {
  ReferenceOptions options;
  options.work =
      std::filesystem::path(testing::TempDir()) / ("litmus-envelope-" + std::to_string(::getpid()));
  std::vector<EnvelopePoint> points = run_envelope_study(options, std::span(&driver, 1));
  std::filesystem::remove_all(options.work);
  std::erase_if(points, [&](const auto& point) { return point.renderer != driver.title; });
  return points;
}

TEST(EnvelopeStudy, LitmusItselfChangesNoPixelInDoublePrecisionUpToAnOffsetOfAMillion) {
  for (const EnvelopePoint& point : run_envelope_study({}, {})) {
    if (point.renderer != "litmus double" || (point.axis == "offset" && point.value > 1e6))
      continue;
    EXPECT_EQ(point.differing, 0) << point.axis << " " << point.value;
  }
}

TEST(EnvelopeStudy, CountsNothingForARendererThatAlwaysShowsTheSame) {
  for (const EnvelopePoint& point :
       points_of(renderer("steady", [](const std::string&) { return false; }))) {
    EXPECT_EQ(point.differing, 0);
    EXPECT_EQ(point.failure, "");
  }
}

TEST(EnvelopeStudy, NamesThePlaceWhereARendererFails) {
  const auto points = points_of(renderer("frail", [](const std::string& scene) {
    return scene == "scale-1e-06-offset-0" || scene == "scale-1e+06-offset-0";
  }));
  EXPECT_THAT(envelope_failures(points),
              ElementsAre("frail, scale 1e-06, scale 1e+06: it gave up"));
}

TEST(EnvelopeStudy, ComparesNothingWithoutAPictureAtScaleOne) {
  const auto points = points_of(
      renderer("odd", [](const std::string& scene) { return scene == "scale-1-offset-0"; }));
  EXPECT_EQ(envelope_failures(points).size(), 2u);
  for (const EnvelopePoint& point : points) EXPECT_NE(point.failure, "");
}

TEST(EnvelopeStudy, SaysOfAMissingRendererThatItIsNotInstalled) {
  Driver missing = renderer("missing", [](const std::string&) { return false; });
  missing.find = [] { return std::nullopt; };
  EXPECT_THAT(envelope_failures(points_of(missing)), ElementsAre("missing: not installed"));
}

TEST(EnvelopeStudy, HasNoFailuresToNameWhereThereAreNone) {
  EXPECT_THAT(envelope_failures({{"scale", 1, "POV-Ray", 0, ""}}), IsEmpty());
}

}  // namespace
}  // namespace litmus

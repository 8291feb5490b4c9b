// gallery_test.cpp: the gallery has the seminar's figures, small, and only in full runs.
#include "reports/gallery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/load.h"
#include "scene/observer.h"

namespace litmus {
namespace {
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Gallery, HasTheSlidesInOrderAndStaysSmall) {
  if (colord_file("ref/CIE-TCS.sp").empty())
    GTEST_SKIP() << kColordPackage << " is not installed: slides 2-5 have no test colours";
  std::vector<std::string> slides;
  std::size_t bytes = 0;
  const std::vector<GalleryFigure> figures = gallery(2);
  for (const GalleryFigure& figure : figures) {
    slides.push_back(figure.slides);
    for (const GalleryPanel& panel : figure.panels) bytes += panel.uri.size() + panel.svg.size();
  }
  EXPECT_THAT(slides, ElementsAre("slides 2-5", "slide 7", "slide 9", "slide 12", "slide 13",
                                  "slide 14", "slide 17", "slide 18", "slide 20"));
  EXPECT_LT(bytes, 600'000u);
  EXPECT_NE(figures[4].panels[0].uri, figures[4].panels[1].uri) << "linear is not quadratic";
  EXPECT_NE(figures[6].panels[0].uri, figures[6].panels[1].uri) << "3 is not 30";
  EXPECT_NE(figures[0].panels[3].uri, figures[0].panels[4].uri) << "the product is not the bands";
  EXPECT_NE(figures[0].panels[0].uri, figures[0].panels[3].uri) << "A is not D65";
  // Slide 12 at the range (x = 1, a quarter of the way): half is left of a) and of b).
  EXPECT_THAT(figures[3].panels[0].svg, HasSubstr("104.5,90.0"));
}

TEST(Gallery, IsOnlyForAStudyOfAllCanonicalScenes) {
  Study study;
  EXPECT_FALSE(is_full_run(study));
  for (const std::filesystem::path& file : canonical_scenes()) {
    EXPECT_FALSE(is_full_run(study));
    study.cases.emplace_back().scene = file.stem().string();
  }
  EXPECT_TRUE(is_full_run(study));
}

}  // namespace
}  // namespace litmus

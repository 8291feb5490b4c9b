// sample_code_test.cpp: the report shows where slide 5's code is not its equation.
#include "reports/sample_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reports/panels.h"
#include "scene/load.h"

namespace litmus {
namespace {

using testing::HasSubstr;

TEST(SampleCodeFigures, ShowBothReadingsOfEveryTypeOfLight) {
  const std::vector<GalleryFigure> figures = sample_code_figures(2);
  std::string titles;
  std::size_t bytes = 0;
  for (const GalleryFigure& figure : figures) {
    titles += figure.title + "\n";
    ASSERT_EQ(figure.panels.size(), 3u) << figure.title;
    EXPECT_NE(figure.panels[0].uri, figure.panels[1].uri) << figure.title << ": no difference";
    EXPECT_THAT(figure.caption, HasSubstr("largest difference is")) << figure.title;
    for (const GalleryPanel& panel : figure.panels) bytes += panel.uri.size();
  }
  for (const char* type : {"directional", "point", "spot", "area", "Ambient", "a3-", "c2-"})
    EXPECT_THAT(titles, HasSubstr(type));
  EXPECT_LT(bytes, 900'000u);
}

Picture in(Shading shading, Scene scene) {
  scene.shading = shading;
  return render(scene).whole;
}

// What the captions say.
TEST(SampleCodeReading, HasNoAmbientLightInFullShadow) {
  const Scene scene = load_scene(find_scene("a3"));
  const Picture equation = in(Shading::Equation, scene), code = in(Shading::SampleCode, scene);
  int dark = 0;
  for (std::size_t i = 0; i < code.pixels.size(); ++i)
    if (code.pixels[i] == glm::dvec3(0) && equation.pixels[i] != glm::dvec3(0)) ++dark;
  EXPECT_GT(dark, 100);
}

TEST(SampleCodeReading, ColoursHighlightsByTheDiffuseColour) {
  const Scene scene = load_scene(find_scene("c2"));  // diffuse red, specular blue
  const Picture equation = in(Shading::Equation, scene), code = in(Shading::SampleCode, scene);
  std::size_t peak = 0;
  for (std::size_t i = 0; i < equation.pixels.size(); ++i)
    if (equation.pixels[i].b > equation.pixels[peak].b) peak = i;
  EXPECT_GT(equation.pixels[peak].b, 0.3);
  EXPECT_EQ(code.pixels[peak].b, 0);
  EXPECT_GT(code.pixels[peak].r, equation.pixels[peak].r);
}

TEST(SampleCodeReading, AddsAmbientLightForEachLampInView) {
  Scene scene = load_scene(find_scene("r1"));
  scene.ambient = Color(0.25);
  scene.shadows = false;
  AreaLight& area = std::get<AreaLight>(scene.lights[0].shape);
  area.columns = 3, area.rows = 2;
  const Picture equation = in(Shading::Equation, scene), code = in(Shading::SampleCode, scene);
  const double ka = scene.materials[std::size_t(scene.objects[0].material)].ambient.r;
  EXPECT_NEAR(code.at(2, 2).r - equation.at(2, 2).r, 5 * 0.25 * ka, 1e-12);
}

}  // namespace
}  // namespace litmus

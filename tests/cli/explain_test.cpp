// explain_test.cpp: litmus explain and litmus render --terms as a person uses them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/image_io.h"
#include "scene/load.h"
#include "tests/cli/program_test.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Without a renderer in sight.
class ExplainCommand : public ProgramTest {
 protected:
  Ended litmus(const std::string& arguments) const {
    return ProgramTest::litmus(arguments, "PATH=/nonexistent");
  }

  nlohmann::json json(const std::string& arguments) const {
    const Ended ended = litmus(arguments + " --json");
    EXPECT_EQ(ended.code, 0) << ended.text;
    return nlohmann::json::parse(ended.text);
  }

  /// A canonical scene with one piece of its text replaced.
  void write_changed(const std::string& name, const std::string& from, const std::string& to,
                     const std::string& file) const {
    std::stringstream text;
    text << std::ifstream(find_scene(name)).rdbuf();
    std::string changed = text.str();
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos);
    std::ofstream(folder / file) << changed.replace(at, from.size(), to);
  }
};

TEST_F(ExplainCommand, WritesTheEquationWithNumbersLightByLight) {
  const Ended ended = litmus("explain x5 120 90 --reference none");
  EXPECT_EQ(ended.code, 0);
  for (const char* part :
       {"x5-all-lights, pixel (120, 90): object \"ball\", material \"white\"",
        "I = ka Ia + sum over the lights of  vis att [ kd Id (l.n) + ks Is (h.n)^ns ]",
        "\nambient\n", "\nsun (directional)\n", "\nlamp (point)\n", "\nspot (spot)\n",
        "\npanel (area)\n", "l = 1 / (1 + L x)", "q = 1 / (1 + Q x^2)",
        "decay = 1 - ratio^exponent", "power = (h.n)^ns", "D = vis att (l.n)",
        "the light is behind the surface", "\"ball\" is in between", "\nsum\n", "\n  = I "}) {
    EXPECT_THAT(ended.text, HasSubstr(part));
  }
}

TEST_F(ExplainCommand, ShowsOneLightWithoutASum) {
  const Ended ended = litmus("explain x5 120 90 --reference none --light spot");
  EXPECT_THAT(ended.text, HasSubstr("\nspot (spot)\n"));
  EXPECT_THAT(ended.text, Not(HasSubstr("\nsun (directional)\n")));
  EXPECT_THAT(ended.text, Not(HasSubstr("\nsum\n")));
}

TEST_F(ExplainCommand, ListsTheSamplesOfAnAreaLightAndWhatHidesEach) {
  const Ended ended = litmus("explain x5 60 120 --reference none --light panel");
  EXPECT_THAT(ended.text, HasSubstr("6 point lights, each of 1/6 of the intensity"));
  EXPECT_THAT(ended.text, testing::ContainsRegex("\n +3 [^\n]*\"ball\"\n"));
  EXPECT_THAT(ended.text, testing::ContainsRegex("\n +mean "));
}

TEST_F(ExplainCommand, ShowsTheStoredReferencesAndTheirResiduals) {
  const Ended ended = litmus("explain x5 120 90 --references stored");
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.text, HasSubstr("POV-Ray"));
  EXPECT_THAT(ended.text, HasSubstr("Blender"));
  EXPECT_THAT(ended.text, HasSubstr("ours - theirs"));
  const auto pixel = json("explain x5 120 90 --references stored --reference povray");
  ASSERT_EQ(pixel["references"].size(), 1u);
  const auto& layers = pixel["references"][0]["layers"];
  ASSERT_EQ(layers.size(), 5u);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double ours = pixel["layers"][k]["value"][c], theirs = layers[k]["value"][c];
      EXPECT_EQ(layers[k]["residual"][c], ours - theirs);
      EXPECT_NEAR(ours, theirs, 1e-6);  // the interior's tolerance of POV-Ray
    }
  }
}

TEST_F(ExplainCommand, SaysWhyTheStoredImagesOfAnotherSceneAreNotShown) {
  write_changed("x5", "exponent = 8", "exponent = 9", "own.toml");
  const Ended ended = litmus("explain own.toml 120 90 --references stored");
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.text, HasSubstr("POV-Ray: no image: "));
  EXPECT_THAT(ended.text, Not(HasSubstr("ours - theirs")));
}

TEST_F(ExplainCommand, SaysThatALiveReferenceNeedsTheRenderer) {
  const Ended ended = litmus("explain d2 48 48 --references live --reference povray");
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.text, HasSubstr("apt-get install povray"));
  EXPECT_THAT(ended.text, HasSubstr("\n  = I "));
}

TEST_F(ExplainCommand, AddsUpInItsJson) {
  const auto pixel = json("explain x5 120 90 --reference none");
  for (std::size_t c = 0; c < 3; ++c) {
    double total = pixel["ambient"]["color"][c];
    for (const auto& light : pixel["lights"]) total += double(light["color"][c]);
    EXPECT_NEAR(total, pixel["picture"][c], 1e-15);
  }
  const auto& spot = pixel["lights"][2]["lamps"][0];
  EXPECT_EQ(spot["reason"], "the light arrives");
  EXPECT_NEAR(double(spot["q"]) * double(spot["decay"]), spot["intensity"], 1e-15);
  EXPECT_FALSE(pixel["lights"][0]["lamps"][0].contains("d"));  // the sun has no distance
  EXPECT_EQ(pixel["lights"][1]["lamps"][0]["blocked_by"], "ball");
}

TEST_F(ExplainCommand, SaysThatAPixelOfSeveralSamplesIsExplainedAtItsCentre) {
  const Ended ended = litmus("explain m1 60 50 --reference none");
  EXPECT_THAT(ended.text, HasSubstr("mean of 2 x 2 samples; explained is the pixel's centre"));
  EXPECT_THAT(ended.text, HasSubstr("\n    picture"));
}

TEST_F(ExplainCommand, WritesTheSampleCodesEquation) {
  write_changed("x5", "schema = 1", "schema = 1\nshading = \"sample-code\"", "code.toml");
  const Ended ended = litmus("explain code.toml 120 90 --reference none");
  EXPECT_EQ(ended.code, 0) << ended.text;
  EXPECT_THAT(ended.text, HasSubstr("slide 5, sample code"));
  EXPECT_THAT(ended.text, HasSubstr("ka Ia for each lamp in view"));
  EXPECT_THAT(ended.text, HasSubstr("D = vis att max(l.n, 0)"));
}

TEST_F(ExplainCommand, SaysThatABackgroundPixelSeesNothing) {
  const Ended ended = litmus("explain d2 0 0 --references stored");
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.text, HasSubstr("nothing is seen"));
}

TEST_F(ExplainCommand, RefusesAPixelOutsideAndALightThatIsNotThere) {
  const Ended outside = litmus("explain x5 240 0 --reference none");
  EXPECT_EQ(outside.code, 2);
  EXPECT_THAT(outside.text, HasSubstr("x from 0 to 239 and y from 0 to 179"));
  EXPECT_EQ(litmus("explain x5 -1 0 --reference none").code, 2);
  const Ended light = litmus("explain x5 0 0 --light moon --reference none");
  EXPECT_EQ(light.code, 2);
  EXPECT_THAT(light.text, HasSubstr("all, ambient, sun, lamp, spot, panel"));
  EXPECT_EQ(litmus("explain x5 0 0 --reference mitsuba").code, 2);
  EXPECT_EQ(litmus("explain x5 0").code, 2);
}

TEST_F(ExplainCommand, HasHelpWithAnExample) {
  EXPECT_THAT(litmus("explain --help").text, HasSubstr("Example: litmus explain"));
}

// ---- render --terms --------------------------------------------------------------------------

glm::dvec3 color_of(const Metadata& metadata, const std::string& key) {
  glm::dvec3 color{std::nan("")};
  std::istringstream(metadata.at(key)) >> color.x >> color.y >> color.z;
  return color;
}

double largest(const glm::dvec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

TEST_F(ExplainCommand, RendersTermsThatRecombineToThePicture) {
  ASSERT_EQ(litmus("render x5 -o terms.exr --terms").code, 0);
  ASSERT_EQ(litmus("render x5 -o whole.exr").code, 0);
  const Picture whole = read_picture(folder / "whole.exr");
  const Metadata metadata = read_metadata(folder / "terms.exr");
  std::map<std::string, Picture> layers;
  for (const Layer& layer : read_layers(folder / "terms.exr")) layers[layer.light] = layer.picture;
  EXPECT_TRUE(layers.contains("spot.alpha"));
  EXPECT_FALSE(layers.contains("lamp.alpha"));
  EXPECT_FALSE(layers.contains("sun.d"));

  Picture again(whole.width, whole.height);
  const auto add = [&](const char* k, const std::string& color, const Picture* term) {
    const glm::dvec3 light = color_of(metadata, color);
    for (std::size_t i = 0; i < again.pixels.size(); ++i)
      again.pixels[i] += layers.at(k).pixels[i] * light * (term ? term->pixels[i] : glm::dvec3(1));
  };
  add("ka", "Ia", nullptr);
  for (const std::string light : {"sun", "lamp", "spot", "panel"}) {
    add("kd", light + ".Id", &layers.at(light + ".diffuse"));
    add("ks", light + ".Is", &layers.at(light + ".specular"));
  }
  double worst = 0;
  for (std::size_t i = 0; i < whole.pixels.size(); ++i)
    worst = std::max(worst, largest(again.pixels[i] - whole.pixels[i]));
  EXPECT_LE(worst, 1e-6);  // twenty numbers up to 1, all rounded to floats
  EXPECT_THAT(metadata.at("picture"), HasSubstr("kd Id diffuse"));
}

TEST_F(ExplainCommand, RefusesTermsOfOneLightAndTermsAsPng) {
  EXPECT_EQ(litmus("render x5 -o terms.exr --terms --light spot").code, 2);
  EXPECT_EQ(litmus("render x5 -o terms.png --terms").code, 2);
  EXPECT_FALSE(fs::exists(folder / "terms.exr"));
}

}  // namespace
}  // namespace litmus

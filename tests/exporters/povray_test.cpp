// povray_test.cpp: the text of the POV-Ray exports. Whether POV-Ray agrees is tested in reference/.
#include "exporters/povray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "exporters/exporters.h"
#include "scene/load.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Writer = void (*)(const Scene&, std::ostream&);
constexpr Writer kWriters[] = {write_povray, write_povray_native};

std::string as_povray(const Scene& scene, Writer write = write_povray) {
  std::ostringstream out;
  write(scene, out);
  return out.str();
}

Scene plain_scene() {
  Scene scene;
  scene.name = "plain";
  scene.about = "A ball on a floor.";
  scene.camera.eye = {0, -8, 4};
  scene.materials.push_back({"white", Color(1), Color(0.8), Color(0.1), 20});
  scene.objects.push_back({"floor", Plane{}, 0, true});
  scene.objects.push_back({"ball", Sphere{{0, 0, 1}, 1}, 0, true});
  return scene;
}

Light light(const std::string& name, decltype(Light::shape) shape) {
  Light result;
  result.name = name;
  result.shape = shape;
  return result;
}

Light point(double linear, double quadratic) {
  return light("lamp", PointLight{{1, 2, 4}, {3, linear, quadratic}});
}

Light spot() {
  SpotLight shape;
  shape.point.origin = {1, 2, 4};
  shape.cutoff = 0.5;
  return light("spot", shape);
}

Scene lit_by(std::initializer_list<Light> lights) {
  Scene scene = plain_scene();
  scene.lights = lights;
  return scene;
}

// The code without comments, and whether every bracket closes in it.
std::string code_of(const std::string& text) {
  std::istringstream in(text);
  std::string code;
  for (std::string line; std::getline(in, line);) code += line.substr(0, line.find("//")) + '\n';
  return code;
}

bool balanced(const std::string& code) {
  std::string open;
  bool quoted = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '"' && (i == 0 || code[i - 1] != '\\')) quoted = !quoted;
    if (quoted) continue;
    if (c == '{' || c == '(' || c == '[') open += c;
    if (c == '}' || c == ')' || c == ']') {
      const char wanted = c == '}' ? '{' : c == ')' ? '(' : '[';
      if (open.empty() || open.back() != wanted) return false;
      open.pop_back();
    }
  }
  return open.empty() && !quoted;
}

TEST(Povray, ExportsEveryCanonicalScene) {
  for (const Scene& scene : load_canonical_scenes().scenes) {
    for (const Writer write : kWriters) {
      const std::string code = code_of(as_povray(scene, write));
      EXPECT_TRUE(balanced(code)) << scene.name;
      EXPECT_NE(code.find("#version 3.7;"), std::string::npos) << scene.name;
      for (const char* broken : {" nan", "<nan", "-nan", " inf", "<inf", "-inf"})
        EXPECT_EQ(code.find(broken), std::string::npos) << scene.name << broken;
    }
  }
}

TEST(Povray, NamesTheCommandThatRendersIt) {
  Scene scene = lit_by({point(0, 0)});
  scene.width = 64;
  scene.height = 48;
  scene.samples = 3;
  for (const Writer write : kWriters)
    EXPECT_THAT(as_povray(scene, write),
                HasSubstr("//   povray +Iplain.pov +Oplain.png +W192 +H144 +FN16 File_Gamma=1.0 -A "
                          "-D +KFI1 +KFF2\n"));
}

TEST(Povray, SaysWhatEachFrameIs) {
  const std::string text = as_povray(lit_by({point(0, 0), spot()}));
  EXPECT_THAT(text, HasSubstr("frame 1: ambient"));
  EXPECT_THAT(text, HasSubstr("frame 2: \"lamp\", point"));
  EXPECT_THAT(text, HasSubstr("frame 3: \"spot\", spot"));
}

TEST(Povray, PutsAFilterOnlyWhereThereIsAConeOrBothAttenuations) {
  const std::string plain = as_povray(lit_by({point(0, 0), light("sun", DirectionalLight{})}));
  EXPECT_THAT(plain, Not(HasSubstr("Radius")));
  EXPECT_THAT(plain, Not(HasSubstr("fade")));
  for (const Light& one : {point(1, 0), point(0, 1)}) {
    EXPECT_THAT(as_povray(lit_by({one})), Not(HasSubstr("Radius")));
    EXPECT_THAT(as_povray(lit_by({one})), HasSubstr("fade_power"));
  }
  EXPECT_THAT(as_povray(lit_by({point(1, 1)})), HasSubstr("Medium(3, 1)"));
  EXPECT_THAT(as_povray(lit_by({point(1, 1)})), Not(HasSubstr("Cone(")));
  EXPECT_THAT(as_povray(lit_by({spot()})), HasSubstr("Cone("));
  EXPECT_THAT(as_povray(lit_by({spot()})), Not(HasSubstr("Medium(")));
}

TEST(Povray, LightsNothingWithSpotExponentZero) {
  Scene scene = lit_by({spot()});
  EXPECT_THAT(as_povray(scene), HasSubstr("light_source"));
  std::get<SpotLight>(scene.lights[0].shape).exponent = 0;
  EXPECT_THAT(as_povray(scene), Not(HasSubstr("light_source")));
}

TEST(Povray, OffersTheWholePictureOnlyWhereItIsOne) {
  const std::string together = "(frame 0) all lights shine at once";
  EXPECT_THAT(as_povray(lit_by({point(0, 1), spot()})), HasSubstr(together));
  EXPECT_THAT(as_povray(lit_by({point(1, 1)})), HasSubstr(together));

  const std::string media = as_povray(lit_by({point(1, 1), spot()}));
  EXPECT_THAT(media, Not(HasSubstr(together)));
  EXPECT_THAT(media, HasSubstr("cannot shine at once"));

  Scene two_ratios = lit_by({point(0, 0), spot()});
  two_ratios.lights[0].specular = {1, 0.5, 1};
  EXPECT_THAT(as_povray(two_ratios), Not(HasSubstr(together)));
  two_ratios.lights[1].specular = {1, 0.5, 1};
  EXPECT_THAT(as_povray(two_ratios), HasSubstr(together));

  Scene dark_diffuse = lit_by({point(0, 0)});
  dark_diffuse.lights[0].diffuse = {0, 1, 1};
  EXPECT_THAT(as_povray(dark_diffuse), Not(HasSubstr(together)));
}

TEST(Povray, HidesObjectsFromTheCameraAndLeavesOutShadows) {
  Scene scene = lit_by({spot()});
  EXPECT_THAT(as_povray(lit_by({point(0, 0)})), Not(HasSubstr("no_image")));
  scene.lights = {point(0, 0)};
  scene.objects[1].camera_visible = false;
  EXPECT_THAT(as_povray(scene), HasSubstr("no_image"));
  EXPECT_THAT(as_povray(scene), Not(HasSubstr("no_shadow")));
  scene.shadows = false;
  EXPECT_THAT(as_povray(scene), HasSubstr("no_shadow"));
}

TEST(Povray, WritesTheNumbersOfTheAuthor) {
  Scene scene = lit_by({point(0, 0)});
  scene.objects[1].shape = Sphere{{0.1, 0.2, 1.3}, 0.7};
  EXPECT_THAT(as_povray(scene), HasSubstr("sphere { <0.1, 0.2, 1.3>, 0.7 "));
}

TEST(Povray, KeepsHostileNamesInsideComments) {
  const std::string evil = "x\n#error \"evil\" */ \\\r} union { \xff";
  Scene scene = lit_by({point(0, 0)});
  scene.name = scene.about = scene.materials[0].name = evil;
  scene.objects[0].name = scene.lights[0].name = evil;
  for (const Writer write : kWriters) {
    const std::string text = as_povray(scene, write);
    EXPECT_THAT(text, HasSubstr("evil")) << "the name is somewhere";
    EXPECT_THAT(code_of(text), Not(HasSubstr("evil")));
    EXPECT_TRUE(balanced(code_of(text)));
    EXPECT_THAT(text, HasSubstr("povray +IFILE.pov")) << "nothing for a shell to trip over";
  }
}

TEST(Povray, IsTheSameInALocaleWithCommas) {
  struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  Scene scene = lit_by({point(0.5, 0.25), spot()});
  scene.width = 1600;
  for (const Writer write : kWriters) {
    const std::string before = as_povray(scene, write);
    const std::locale old = std::locale::global(std::locale(std::locale(), new Commas));
    const std::string after = as_povray(scene, write);
    std::ostringstream control;
    control << 1234.5;
    std::locale::global(old);
    EXPECT_EQ(control.str(), "1.234,5") << "the locale has no effect here";
    EXPECT_EQ(after, before);
  }
}

TEST(Povray, RefusesTheSampleCode) {
  Scene scene = lit_by({point(0, 0)});
  scene.shading = Shading::SampleCode;
  for (const Writer write : kWriters) {
    try {
      as_povray(scene, write);
      ADD_FAILURE() << "not refused";
    } catch (const Refusal& refusal) {
      EXPECT_THAT(refusal.what(), HasSubstr("shading: \"sample-code\""));
    }
  }
}

TEST(PovrayGain, FillsSixteenBitsWithoutClipping) {
  for (const double intensity : {1e-30, 0.3, 1.0, 1.9, 1e20}) {
    Scene scene = lit_by({point(0, 0)});
    scene.lights[0].intensity = intensity;
    const double gain = povray_gain(scene, 1);
    const double brightest = gain * intensity * (0.8 + 0.1);  // kd + ks
    EXPECT_LE(brightest, 1) << intensity;
    EXPECT_GT(brightest, 0.5) << intensity;
    int exponent = 0;
    EXPECT_EQ(std::frexp(gain, &exponent), 0.5) << "a power of two changes no digit";
  }
}

TEST(PovrayGain, IsOneWhereNothingShines) { EXPECT_EQ(povray_gain(plain_scene(), 0), 1); }

TEST(PovrayNative, UsesPovraysOwnLights) {
  AreaLight area;
  area.point.origin = {0, 0, 5};
  area.columns = 4;
  const std::string text =
      as_povray(lit_by({spot(), light("panel", area), point(1, 1)}), write_povray_native);
  EXPECT_THAT(text, HasSubstr("spotlight"));
  EXPECT_THAT(text, HasSubstr("area_light"));
  EXPECT_THAT(text, HasSubstr("fade_distance"));
  EXPECT_THAT(code_of(text), Not(HasSubstr("Medium")));
}

TEST(PovrayNative, SaysWhatItCannotExpress) {
  const std::string text = as_povray(lit_by({spot(), point(1, 1)}), write_povray_native);
  EXPECT_THAT(text, HasSubstr("What differs from the model:"));
  EXPECT_THAT(text, HasSubstr("// \"spot\":"));
  EXPECT_THAT(text, HasSubstr("// \"lamp\":"));
  EXPECT_THAT(as_povray(lit_by({point(0, 1)}), write_povray_native),
              HasSubstr("Nothing in this scene differs"));
}

TEST(PovrayCaveats, AreNoneForAnOrdinaryScene) {
  EXPECT_THAT(povray_caveats(lit_by({point(1, 1), spot()})), IsEmpty());
}

TEST(PovrayCaveats, NameTheLampThatTouchesASurface) {
  Scene scene = lit_by({point(1, 1)});
  std::get<PointLight>(scene.lights[0].shape).origin = {3, 0, 1e-6};
  ASSERT_EQ(povray_caveats(scene).size(), 1u);
  EXPECT_THAT(povray_caveats(scene)[0], HasSubstr("\"lamp\""));
  EXPECT_THAT(povray_caveats(scene)[0], HasSubstr("\"floor\""));
}

TEST(PovrayCaveats, NameALampBeyondReach) {
  Scene scene = lit_by({point(0, 0)});
  std::get<PointLight>(scene.lights[0].shape).origin = {0, 0, 1e9};
  EXPECT_EQ(povray_caveats(scene).size(), 1u);
}

}  // namespace
}  // namespace litmus

// load_test.cpp: what the loader reads, and every refusal with its place and field.
#include "scene/load.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <locale>
#include <numbers>

#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Scene load_text(const std::string& text) {
  const ScratchFolder folder;
  return load_scene(folder.write("scene.toml", text));
}

// ---- What is read ----------------------------------------------------------------------------

TEST(LoadScene, ReadsEveryTable) {
  const Scene scene = load_text(kScratchScene);
  EXPECT_EQ(scene.name, "scene");
  EXPECT_EQ(scene.about, "A scene to spoil.");
  EXPECT_EQ(scene.tags, std::vector<std::string>{"test"});
  EXPECT_EQ(scene.ambient, Color(0.1));
  EXPECT_EQ(scene.width, 8);
  EXPECT_EQ(scene.height, 6);
  EXPECT_EQ(scene.camera.eye, Point(4, -6, 3));
  EXPECT_DOUBLE_EQ(scene.camera.fov, 40 * std::numbers::pi / 180);
  EXPECT_EQ(scene.materials.at(0).shininess, 10);
  EXPECT_EQ(scene.materials.at(0).diffuse, Color(0.8));
  ASSERT_EQ(scene.objects.size(), 5u);
  EXPECT_FALSE(scene.objects[1].camera_visible);
  EXPECT_EQ(std::get<Sphere>(scene.objects[1].shape).radius, 0.5);
  EXPECT_EQ(std::get<Mesh>(scene.objects[4].shape).triangles.size(), 80u);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(LoadScene, ReadsEveryTypeOfLight) {
  const Scene scene = load_text(kScratchScene);
  ASSERT_EQ(scene.lights.size(), 4u);
  EXPECT_EQ(std::get<DirectionalLight>(scene.lights[0].shape).direction, Vector(-1, 0.5, -2));
  EXPECT_EQ(scene.lights[0].intensity, 0.75);
  EXPECT_EQ(scene.lights[0].specular, Color(1, 0.9, 0.8));
  EXPECT_EQ(std::get<PointLight>(scene.lights[1].shape).attenuation.quadratic, 0.25);
  EXPECT_DOUBLE_EQ(std::get<SpotLight>(scene.lights[2].shape).cutoff, 25 * std::numbers::pi / 180);
  const auto& area = std::get<AreaLight>(scene.lights[3].shape);
  EXPECT_EQ(area.columns, 3);
  EXPECT_EQ(area.rows, 2);
  EXPECT_EQ(area.right, Vector(1, 0, 0));
}

TEST(LoadScene, NamesWhatHasNoName) {
  std::string text = replaced(kScratchScene, "name = \"ball\"\n", "");
  text = replaced(text, "name = \"lamp\"\n", "");
  const Scene scene = load_text(text);
  EXPECT_EQ(scene.objects[1].name, "sphere-1");
  EXPECT_EQ(scene.lights[1].name, "point-1");
}

TEST(LoadScene, AcceptsASceneWithoutObjectsOrLights) {
  const std::size_t materials = kScratchScene.find("[[material]]");
  const Scene scene = load_text(kScratchScene.substr(0, materials));
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_TRUE(scene.lights.empty());
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(LoadScene, ReadsTheSameNumbersInALocaleWithADecimalComma) {
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  const Scene scene = load_text(kScratchScene);
  std::locale::global(before);
  EXPECT_EQ(scene.lights[0].intensity, 0.75);
}

TEST(LoadScene, DropsATriangleWithoutAreaAndSaysSo) {
  const Scene scene = load_text(replaced(kScratchScene, "c = [0, 1, 3]", "c = [2, 0, 3]"));
  EXPECT_EQ(scene.objects.size(), 4u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_THAT(scene.warnings[0],
              HasSubstr(":40:1: object \"sail\": dropped 1 triangle without area"));
}

// ---- What is refused -------------------------------------------------------------------------

struct Spoiled {
  const char* name;
  const char* find;   ///< occurs once in kScratchScene
  const char* with;   ///< '@' marks the place that the refusal must name
  const char* field;  ///< and this is the field
  const char* says;   ///< and this must be part of it
};

void PrintTo(const Spoiled& spoiled, std::ostream* out) { *out << spoiled.with; }

class Refuses : public testing::TestWithParam<Spoiled> {};

TEST_P(Refuses, WithPlaceAndField) {
  const Spoiled& spoiled = GetParam();
  std::string text = replaced(kScratchScene, spoiled.find, spoiled.with);
  const std::string place = take_mark(text);
  const ScratchFolder folder;
  const std::filesystem::path file = folder.write("scene.toml", text);
  const std::string refusal = refusal_of(file);
  EXPECT_THAT(refusal, StartsWith(file.string() + ":" + place + ": " + spoiled.field + ": "));
  EXPECT_THAT(refusal, HasSubstr(spoiled.says));
}

TEST(Refuses, NothingInTheSceneThatTheOthersSpoil) { EXPECT_NO_THROW(load_text(kScratchScene)); }

const Spoiled kSpoiled[] = {
    // The file as a whole
    {"BrokenToml", "width = 8", "width = @= 8", "TOML", "value"},
    {"AKeyGivenTwice", "width = 8", "width = 8\nwidth = @9", "TOML", "width"},
    {"NoSchema", "schema = 1\n", "@", "schema", "must be 1"},
    {"AnotherSchema", "schema = 1", "schema = @2", "schema", "must be 1, not 2"},
    {"AnUnknownKey", "shadows = true", "@shadow = true", "shadow", "did you mean \"shadows\"?"},
    {"AKeyOfAnotherShape", "radius = 0.5", "radius = 0.5\n@level = 3", "level", "unknown key"},
    {"AKeyOfAnotherLight", "range = 4", "range = 4\n@exponent = 3", "exponent", "unknown key"},
    {"ATextWhereATableBelongs", "[image]\nwidth = 8\nheight = 6\nsamples = 1", "image = @\"big\"",
     "[image]", "must be a table"},
    {"ATableWhereAListBelongs", "[[material]]", "@[material]", "material", "list of tables"},
    // Numbers
    {"ANanNumber", "radius = 0.5", "radius = @nan", "radius", "not nan"},
    {"AnInfiniteNumber", "intensity = 0.75", "intensity = @inf", "intensity", "not inf"},
    {"ANanComponent", "direction = [-1, 0.5, -2]", "direction = [-1, @nan, -2]", "direction",
     "finite number, not nan"},
    {"AnInfinitePoint", "origin = [1, 2, 3]", "origin = [1, @-inf, 3]", "origin", "not -inf"},
    {"ATextForANumber", "range = 4", "range = @\"far\"", "range", "not \"far\""},
    {"AFractionForAWholeNumber", "width = 8", "width = @8.5", "width", "whole number"},
    {"TwoComponents", "eye = [4, -6, 3]", "eye = @[4, -6]", "eye", "three finite numbers"},
    {"ADateForANumber", "range = 4", "range = @2020-01-01", "range", "date"},
    // Image and camera
    {"AnImageWithoutPixels", "width = 8", "width = @0", "width", "1..16384"},
    {"AnImageOver16384", "height = 6", "height = @16385", "height", "1..16384, not 16385"},
    {"TooManySamples", "samples = 1", "samples = @65", "samples", "1..64"},
    {"AnUnknownProjection", "\"perspective\"", "@\"perspectiv\"", "projection", "did you mean"},
    {"AnEyeAtTheTarget", "target = [0, 0, 0.5]", "target = @[4, -6, 3]", "target", "away from eye"},
    {"AnUpAlongTheView", "up = [0, 0, 1]", "up = @[-8, 12, -5]", "up", "parallel"},
    {"AnUpOfNoLength", "up = [0, 0, 1]", "up = @[0, 0, 0]", "up", "zero length"},
    {"AFovOf180", "fov_degrees = 40", "fov_degrees = @180", "fov_degrees", "0..180"},
    {"AnOrthographicHeightOfZero",
     "projection = \"perspective\"\neye = [4, -6, 3]\ntarget = [0, 0, 0.5]\nup = [0, 0, 1]\n"
     "fov_degrees = 40",
     "projection = \"orthographic\"\neye = [4, -6, 3]\ntarget = [0, 0, 0]\nheight = @0", "height",
     "> 0"},
    // Materials and colours
    {"ANegativeColour", "diffuse = 0.8", "diffuse = @-0.1", "diffuse", ">= 0"},
    {"ANegativeComponent", "color = [1, 0.9, 0.8]", "color = [1, 0.9, @-0.8]", "color", ">= 0"},
    {"AnUnknownSpectrum", "ambient = 0.1", "ambient = @\"D66\"", "ambient", "did you mean \"D65\""},
    {"ANegativeShininess", "shininess = 10", "shininess = @-10", "shininess", ">= 0"},
    {"AMaterialWithoutName", "[[material]]\nname = \"matte\"", "@[[material]]", "name", "missing"},
    {"AMaterialNamedTwice", "[[material]]\nname = \"matte\"",
     "[[material]]\nname = \"matte\"\n[[material]]\nname = @\"matte\"", "name", "already"},
    {"AnUnknownMaterial", "radius = 0.5\nmaterial = \"matte\"",
     "radius = 0.5\nmaterial = @\"mate\"", "material", "did you mean \"matte\"?"},
    // Shapes
    {"AnUnknownShape", "\"plane\"", "@\"plain\"", "shape", "did you mean \"plane\"?"},
    {"ANormalOfNoLength", "point = [0, 0, 0]\nnormal = [0, 0, 1]",
     "point = [0, 0, 0]\nnormal = @[0, 0, 0]", "normal", "zero length"},
    {"ANegativeRadius", "radius = 0.5", "radius = @-0.5", "radius", "> 0"},
    {"AMissingRadius",
     "[[object]]\nname = \"ball\"\nshape = \"sphere\"\ncenter = [0, 0, 1]\nradius = 0.5",
     "@[[object]]\nname = \"ball\"\nshape = \"sphere\"\ncenter = [0, 0, 1]", "radius", "missing"},
    {"AFlatBox", "max = [2, 2, 1]", "max = @[2, 1, 1]", "max", "greater than min"},
    {"AnObjectNamedTwice", "name = \"ball\"", "name = @\"floor\"", "name", "line 22"},
    {"TooFineAnIcosphere", "level = 1", "level = @8", "level", "0..7"},
    {"AGeneratorAndAFile", "level = 1", "level = 1\nfile = @\"x.obj\"", "file", "not both"},
    {"AMeshFileThatIsMissing",
     "generator = \"icosphere\"\ncenter = [3, 0, 1]\nradius = 0.25\nlevel = 1",
     "file = @\"no.obj\"", "file", "no.obj: no such file"},
    {"AMeshOfTooManyTriangles",
     "generator = \"icosphere\"\ncenter = [3, 0, 1]\nradius = 0.25\nlevel = 1",
     "generator = \"grid\"\norigin = [0, 0, 0]\nu = [1, 0, 0]\nv = [0, 1, 0]\ncolumns = "
     "@1000\nrows = 1000",
     "columns", "1000000 primitives"},
    // Lights
    {"AnUnknownLight", "\"directional\"", "@\"sun\"", "type", "\"directional\""},
    {"ADirectionOfNoLength", "direction = [-1, 0.5, -2]", "direction = @[0, 0, 0]", "direction",
     "zero length"},
    {"ADirectionThatCannotBeNormalised", "direction = [-1, 0.5, -2]", "direction = @[0, 0, 1e-200]",
     "direction", "1e-100"},
    {"ARangeOfZero", "range = 4", "range = @0", "range", "> 0"},
    {"ANegativeLinear", "linear = 0.5", "linear = @-0.5", "linear", ">= 0"},
    {"ANegativeQuadratic", "quadratic = 0.25", "quadratic = @-1", "quadratic", ">= 0"},
    {"ANegativeIntensity", "intensity = 0.75", "intensity = @-1", "intensity", ">= 0"},
    {"ANegativeExponent", "exponent = 3", "exponent = @-3", "exponent", ">= 0"},
    {"ACutoffOfZero", "cutoff_degrees = 25", "cutoff_degrees = @0", "cutoff_degrees", "(0, 180]"},
    {"ACutoffOver180", "cutoff_degrees = 25", "cutoff_degrees = @180.5", "cutoff_degrees", "180.5"},
    {"NoCutoff",
     "[[light]]\nname = \"spot\"\ntype = \"spot\"\norigin = [-1, 2, 3]\n"
     "direction = [0, 0, -1]\ncutoff_degrees = 25",
     "@[[light]]\nname = \"spot\"\ntype = \"spot\"\norigin = [-1, 2, 3]\ndirection = [0, 0, -1]",
     "cutoff_degrees", "missing"},
    {"AGridWithoutColumns", "columns = 3", "columns = @0", "columns", "1..4096"},
    {"AGridOverTheLimit", "columns = 3\nrows = 2", "columns = 64\nrows = @65", "rows",
     "at most 4096, not 64 * 65 = 4160"},
    {"ANegativeWidth", "width = 1\n", "width = @-1\n", "width", ">= 0"},
    {"ARightAlongTheNormal", "right = [1, 0, 0]", "right = @[0, 0, 3]", "right", "parallel"},
    {"AnUnknownPlacement", "\"centres\"", "@\"centers\"", "placement", "did you mean \"centres\"?"},
    {"AnAreaAtTheOriginWithoutNormal",
     "[[light]]\nname = \"panel\"\ntype = \"area\"\norigin = [0, -2, 4]\nnormal = [0, 0, -1]",
     "@[[light]]\nname = \"panel\"\ntype = \"area\"\norigin = [0, 0, 0]", "normal", "origin"},
    {"AColorBesideADiffuse", "color = [1, 0.9, 0.8]", "color = @1\ndiffuse = 1", "color",
     "not both"},
    {"ALightNamedTwice", "name = \"lamp\"", "name = @\"sun\"", "name", "already"},
    {"AReservedName", "name = \"lamp\"", "name = @\"ambient\"", "name", "reserved"},
    {"AnotherReservedName", "name = \"lamp\"", "name = @\"all\"", "name", "reserved"},
};

INSTANTIATE_TEST_SUITE_P(LoadScene, Refuses, testing::ValuesIn(kSpoiled),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(LoadScene, RefusesAnEmptyFile) {
  const ScratchFolder folder;
  const auto file = folder.write("scene.toml", "");
  EXPECT_THAT(refusal_of(file), StartsWith(file.string() + ":1:1: schema: missing"));
}

TEST(LoadScene, RefusesASceneWithoutCameraOrImage) {
  const ScratchFolder folder;
  const std::string image = "[image]\nwidth = 1\nheight = 1\n";
  const auto file = folder.write("scene.toml", "schema = 1\n" + image);
  EXPECT_THAT(refusal_of(file), StartsWith(file.string() + ":1:1: camera: missing"));
  folder.write("scene.toml", "schema = 1\n");
  EXPECT_THAT(refusal_of(file), StartsWith(file.string() + ":1:1: image: missing"));
}

TEST(LoadScene, RefusesAFileThatIsMissing) {
  const ScratchFolder folder;
  const auto file = folder.path() / "none.toml";
  EXPECT_THAT(refusal_of(file), StartsWith(file.string() + ":1:1: file: no such file"));
}

TEST(LoadScene, RefusesAFolder) {
  const ScratchFolder folder;
  EXPECT_THAT(refusal_of(folder.path()), HasSubstr(":1:1: file: not a regular file"));
}

TEST(LoadScene, RefusesAFileOver16MiBButNotOneOfThatSize) {
  const ScratchFolder folder;
  const std::string filling((16u << 20) - kScratchScene.size() - 1, '#');
  EXPECT_EQ(refusal_of(folder.write("scene.toml", kScratchScene + filling + '\n')), "");
  EXPECT_THAT(refusal_of(folder.write("scene.toml", kScratchScene + filling + "#\n")),
              HasSubstr(":1:1: file: 16777217 bytes, over the limit of 16 MiB"));
}

TEST(LoadScene, RefusesBytesThatAreNotText) {
  const ScratchFolder folder;
  EXPECT_THAT(refusal_of(folder.write("scene.toml", "schema = 1\nabout = \"\xff\xfe\"\n")),
              HasSubstr("scene.toml:2:9: TOML: "));
}

TEST(LoadScene, RefusesDeepNestingWithoutACrash) {
  const ScratchFolder folder;
  const std::string nested = "schema = " + std::string(100000, '[') + std::string(100000, ']');
  EXPECT_THAT(refusal_of(folder.write("scene.toml", nested)), HasSubstr("scene.toml:1:"));
}

}  // namespace
}  // namespace litmus

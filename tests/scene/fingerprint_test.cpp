// fingerprint_test.cpp: what changes a scene's fingerprint and what does not.
#include <gtest/gtest.h>

#include <regex>

#include "scene/load.h"
#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

std::string fingerprint_of(const std::string& text) {
  const ScratchFolder folder;
  return fingerprint(load_scene(folder.write("scene.toml", text)));
}

struct Change {
  const char* name;
  const char *find, *with;
};

void PrintTo(const Change& change, std::ostream* out) { *out << change.with; }

class Fingerprint : public testing::TestWithParam<Change> {};
class FingerprintKeeps : public testing::TestWithParam<Change> {};

TEST_P(Fingerprint, Changes) {
  EXPECT_NE(fingerprint_of(replaced(kScratchScene, GetParam().find, GetParam().with)),
            fingerprint_of(kScratchScene));
}

TEST_P(FingerprintKeeps, TheSame) {
  EXPECT_EQ(fingerprint_of(replaced(kScratchScene, GetParam().find, GetParam().with)),
            fingerprint_of(kScratchScene));
}

TEST(Fingerprint, IsThirtyTwoHexadecimalDigits) {
  EXPECT_TRUE(std::regex_match(fingerprint_of(kScratchScene), std::regex("[0-9a-f]{32}")));
}

const Change kChanges[] = {
    {"SceneAmbient", "ambient = 0.1", "ambient = [0.1, 0.1, 0.10000000000000002]"},
    {"Shadows", "shadows = true", "shadows = false"},
    {"Shading", "\"equation\"", "\"sample-code\""},
    {"Width", "width = 8", "width = 9"},
    {"Height", "height = 6", "height = 7"},
    {"Samples", "samples = 1", "samples = 2"},
    {"Projection",
     "projection = \"perspective\"\neye = [4, -6, 3]\ntarget = [0, 0, 0.5]\nup = [0, 0, "
     "1]\nfov_degrees = 40",
     "projection = \"orthographic\"\neye = [4, -6, 3]\ntarget = [0, 0, 0.5]\nheight = 4"},
    {"Eye", "eye = [4, -6, 3]", "eye = [4, -6, 3.5]"},
    {"Target", "target = [0, 0, 0.5]", "target = [0, 0, 1]"},
    {"Up", "up = [0, 0, 1]", "up = [0, 1, 1]"},
    {"Fov", "fov_degrees = 40", "fov_degrees = 41"},
    {"MaterialAmbient", "shininess = 10", "shininess = 10\nambient = 0.5"},
    {"MaterialDiffuse", "diffuse = 0.8", "diffuse = 0.7"},
    {"MaterialSpecular", "shininess = 10", "shininess = 10\nspecular = 0.5"},
    {"Shininess", "shininess = 10", "shininess = 11"},
    {"PlaneNormal", "normal = [0, 0, 1]", "normal = [0, 0.1, 1]"},
    {"SphereCenter", "center = [0, 0, 1]", "center = [0, 0, 2]"},
    {"SphereRadius", "radius = 0.5", "radius = 0.6"},
    {"CameraVisible", "camera_visible = false", "camera_visible = true"},
    {"BoxMax", "max = [2, 2, 1]", "max = [2, 3, 1]"},
    {"TriangleCorner", "c = [0, 1, 3]", "c = [0, 2, 3]"},
    {"MeshLevel", "level = 1", "level = 2"},
    {"MeshNormals", "smooth = false", "smooth = true"},
    {"LightName", "name = \"lamp\"", "name = \"bulb\""},
    {"Direction", "direction = [-1, 0.5, -2]", "direction = [-1, 0.5, -3]"},
    {"Intensity", "intensity = 0.75", "intensity = 0.76"},
    {"LightColour", "color = [1, 0.9, 0.8]", "color = [1, 0.9, 0.7]"},
    {"LightSpecular", "color = [1, 0.9, 0.8]", "diffuse = [1, 0.9, 0.8]"},
    {"LightAmbient", "range = 4", "range = 4\nambient = 0.1"},
    {"Origin", "origin = [1, 2, 3]", "origin = [1, 2, 4]"},
    {"Range", "range = 4", "range = 5"},
    {"Linear", "linear = 0.5", "linear = 0.6"},
    {"Quadratic", "quadratic = 0.25", "quadratic = 0.5"},
    {"Cutoff", "cutoff_degrees = 25", "cutoff_degrees = 26"},
    {"Exponent", "exponent = 3", "exponent = 4"},
    {"AreaNormal", "normal = [0, 0, -1]", "normal = [0, 0.1, -1]"},
    {"AreaRight", "right = [1, 0, 0]\n", ""},
    {"AreaWidth", "width = 1\n", "width = 2\n"},
    {"AreaHeight", "height = 0.5", "height = 0.6"},
    {"Columns", "columns = 3", "columns = 4"},
    {"Rows", "rows = 2", "rows = 3"},
    {"Placement", "\"centres\"", "\"corners\""},
};
INSTANTIATE_TEST_SUITE_P(With, Fingerprint, testing::ValuesIn(kChanges),
                         [](const auto& info) { return std::string(info.param.name); });

const Change kTrifles[] = {
    {"About", "about = \"A scene to spoil.\"", "about = \"Another sentence.\""},
    {"Tags", "tags = [\"test\"]", "tags = []"},
    {"AComment", "shadows = true", "shadows = true  # a comment"},
    {"AnotherSpelling", "diffuse = 0.8", "diffuse = [0.80, 8e-1, 0.8]"},
    {"ADefaultWrittenOut", "range = 4", "range = 4\nintensity = 1"},
    {"AnObjectsName", "name = \"ball\"", "name = \"bowl\""},
    {"AnUnusedMaterial", "[[material]]", "[[material]]\nname = \"unused\"\n[[material]]"},
};
INSTANTIATE_TEST_SUITE_P(Despite, FingerprintKeeps, testing::ValuesIn(kTrifles),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace litmus

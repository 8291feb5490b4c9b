// load_spectra_test.cpp: spectra in scene files, and what is refused about them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "scene/observer.h"
#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

const std::string kTable = R"([spectra]
paint = { samples = [[400, 0.2], [700, 0.8]] }
warm = { blackbody_kelvin = 2700, scale = 0.5 }
day = { illuminant = "D65" }
tile = { file = "tile.sp", sample = "right" }
plain = { file = "plain.txt" }
)";

/// kScratchScene with spectra in two of its colours.
std::string painted_text(const std::string& table = kTable) {
  std::string text =
      replaced(kScratchScene, "diffuse = 0.8", "diffuse = \"paint\"\nspecular = 0.5");
  text = replaced(text, "color = [1, 0.9, 0.8]", "color = \"warm\"");
  return replaced(text, "[image]", "bands = 8\n" + table + "[image]");
}

void write_files(const ScratchFolder& folder) {
  folder.write(
      "tile.sp",
      "SPECTRAL_START_NM 400\nSPECTRAL_END_NM 700\nSPECTRAL_BANDS 2\nBEGIN_DATA\nleft 0 1\n"
      "right 0.5 0.25\nEND_DATA\n");
  folder.write("plain.txt", "400 0.1\n700 0.2\n");
}

Scene load(const std::string& text) {
  const ScratchFolder folder;
  write_files(folder);
  return load_scene(folder.write("scene.toml", text));
}

TEST(SpectralScene, HasABandOfEachColour) {
  const Scene scene = load(painted_text());
  ASSERT_TRUE(scene.spectra.has_value());
  EXPECT_EQ(scene.spectra->bands, 8);
  EXPECT_EQ(scene.spectra->materials[0].diffuse, band_means({{400, 700}, {.2, .8}}, 8));
  EXPECT_EQ(scene.spectra->materials[0].specular, std::vector<double>(8, 0.5));
  EXPECT_EQ(scene.spectra->materials[0].ambient, std::vector<double>(8, 1));
  Spectrum warm = blackbody(2700);
  for (double& value : warm.values) value *= 0.5;
  EXPECT_EQ(scene.spectra->lights[0].diffuse, band_means(warm, 8));
  EXPECT_EQ(scene.spectra->lights[0].specular, scene.spectra->lights[0].diffuse);
  EXPECT_EQ(scene.spectra->lights[0].ambient, std::vector<double>(8, 0));
  EXPECT_EQ(scene.spectra->ambient, std::vector<double>(8, 0.1));
}

TEST(SpectralScene, TakesAMeasuredFileForAColour) {
  for (const auto& [name, at_400] : {std::pair{"tile", 0.5}, {"plain", 0.1}}) {
    const Scene scene = load(replaced(painted_text(), "\"paint\"", '"' + std::string(name) + '"'));
    EXPECT_NEAR(scene.spectra->materials[0].diffuse[0], at_400, 0.01) << name;
  }
}

TEST(SpectralScene, KeepsRgbColoursThatStandIn) {
  const Scene scene = load(painted_text());
  EXPECT_EQ(scene.materials[0].specular, Color(0.5));
  const Color warm = scene.lights[0].diffuse;
  EXPECT_GT(warm.r, warm.g);
  EXPECT_GT(warm.g, warm.b);
}

TEST(RgbScene, HasNoSpectra) { EXPECT_FALSE(load(kScratchScene).spectra.has_value()); }

TEST(SpectralScene, HasAFingerprintOfItsBands) {
  const std::string text = painted_text();
  const auto print = [](const std::string& t) { return fingerprint(load(t)); };
  EXPECT_EQ(print(text), print(text));
  EXPECT_NE(print(text), print(replaced(text, "0.2], [700", "0.21], [700")));
  EXPECT_NE(print(text), print(replaced(text, "bands = 8", "bands = 9")));
  EXPECT_NE(print(text), print(replaced(text, "scale = 0.5", "scale = 0.6")));
  EXPECT_EQ(print(text), print(replaced(text, "day = { illuminant = \"D65\" }", "")));  // unused
}

TEST(SpectralScene, SaysWhatStandsInWithoutColord) {
  setenv("XDG_DATA_DIRS", "/nonexistent", 1);
  const Scene scene = load(replaced(painted_text(), "\"warm\"", "\"day\""));
  unsetenv("XDG_DATA_DIRS");
  EXPECT_THAT(scene.warnings, testing::UnorderedElementsAre(HasSubstr("blackbody of 6504 K"),
                                                            HasSubstr("fit by Gaussians")));
}

struct Mistake {
  const char *name, *find, *with, *field, *remedy;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.with; }

class SpectraRefused : public testing::TestWithParam<Mistake> {};

/// The '@' in `with` is where the message must point.
TEST_P(SpectraRefused, WithPlaceFieldAndRemedy) {
  std::string text = replaced(painted_text(), GetParam().find, GetParam().with);
  const std::string place = take_mark(text);
  const ScratchFolder folder;
  write_files(folder);
  const std::string said = refusal_of(folder.write("scene.toml", text));
  EXPECT_THAT(said, HasSubstr("scene.toml:" + place + ": " + GetParam().field + ": "));
  EXPECT_THAT(said, HasSubstr(GetParam().remedy));
}

const Mistake kMistakes[] = {
    {"AnUnknownName", "\"paint\"", "@\"pain\"", "diffuse", "did you mean \"paint\""},
    {"AnUnknownKey", "scale = 0.5", "@scael = 0.5", "scael", "did you mean \"scale\""},
    {"NoSource", "{ illuminant = \"D65\" }", "@{ scale = 2 }", "spectrum", "one of samples"},
    {"TwoSources", "illuminant = \"D65\"", "illuminant = \"A\", file = @\"x\"", "file",
     "leave out"},
    {"AnUnknownIlluminant", "\"D65\"", "@\"D66\"", "illuminant", "did you mean \"D65\""},
    {"AColdBody", "2700", "@100", "blackbody_kelvin", "500..100000"},
    {"FallingWavelengths", "[700, 0.8]", "@[300, 0.8]", "samples", "rising"},
    {"ANegativeValue", "[700, 0.8]", "@[700, -0.8]", "samples", ">= 0"},
    {"NoPair", "[700, 0.8]", "@[700]", "samples", "pairs"},
    {"NoSamples", "[[400, 0.2], [700, 0.8]]", "@[]", "samples", "pairs"},
    {"ANegativeScale", "scale = 0.5", "scale = @-1", "scale", ">= 0"},
    {"NoSuchFile", "\"plain.txt\"", "@\"none.txt\"", "file", "no such file"},
    {"NoSuchSample", "\"right\"", "@\"up\"", "sample", "\"left\" or \"right\""},
    {"AFileOfSeveral", "file = \"tile.sp\", sample = \"right\"", "file = @\"tile.sp\"", "file",
     "choose one by sample"},
    {"ASampleOfNoFile", "illuminant = \"D65\"", "illuminant = \"D65\", sample = @\"x\"", "sample",
     "leave it out"},
    {"ATableThatIsNotThere", "{ file = \"plain.txt\" }", "{ colord = @\"ref/none.sp\" }", "colord",
     "apt-get install colord-data"},
    {"AReservedName", "day =", "E = @{ illuminant = \"A\" }\nday =", "E", "illuminant's name"},
    {"TooManyBands", "bands = 8", "bands = @401", "bands", "1..400"},
    {"NoBands", "bands = 8", "bands = @0", "bands", "1..400"},
    {"ATripleAmongSpectra", "ambient = 0.1", "ambient = @[0.1, 0.2, 0.3]", "ambient",
     "no spectrum"},
};

INSTANTIATE_TEST_SUITE_P(, SpectraRefused, testing::ValuesIn(kMistakes),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SpectraRefusedToo, WhereNoColourNamesOne) {
  const ScratchFolder folder;
  std::string text = replaced(kScratchScene, "[image]", "bands = 8\n[image]");
  EXPECT_THAT(refusal_of(folder.write("a.toml", text)),
              HasSubstr("bands: no colour of this scene"));
  text = replaced(kScratchScene, "[image]", "[spectra]\nx = { samples = [[400, 1]] }\n[image]");
  EXPECT_THAT(refusal_of(folder.write("b.toml", text)),
              HasSubstr("spectra: no colour of this scene"));
}

}  // namespace
}  // namespace litmus

// spectrum_file_test.cpp: measured files are read whole, and what is wrong in one is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/spectrum.h"
#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kCgats = R"(SPECT
DESCRIPTOR "two tiles"
SPECTRAL_START_NM "400.0"
SPECTRAL_END_NM 700
SPECTRAL_BANDS 4
SPECTRAL_NORM 100
BEGIN_DATA_FORMAT
SAMPLE_ID SPEC_400 SPEC_500 SPEC_600 SPEC_700
END_DATA_FORMAT
BEGIN_DATA
left 10 20 30 40
right 5 5 5	50
END_DATA
)";

std::vector<NamedSpectrum> read(const std::string& text) {
  const ScratchFolder folder;
  return read_spectra_file(folder.write("tile.sp", text));
}

std::string file_complaint(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(SpectraFile, ReadsCgatsWithNamesAndNorm) {
  const std::vector<NamedSpectrum> tiles = read(kCgats);
  ASSERT_EQ(tiles.size(), 2u);
  EXPECT_EQ(tiles[0].name, "left");
  EXPECT_THAT(tiles[0].spectrum.nm, ElementsAre(400, 500, 600, 700));
  EXPECT_THAT(tiles[0].spectrum.values, ElementsAre(.1, .2, .3, .4));
  EXPECT_EQ(tiles[1].name, "right");
  EXPECT_THAT(tiles[1].spectrum.values, ElementsAre(.05, .05, .05, .5));
}

TEST(SpectraFile, ReadsTwoColumnsWithCommentsAndCommas) {
  const std::vector<NamedSpectrum> one = read("# nm value\n400 0.1\n450.5,\t0.2 # ramp\r\n\n700 1");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].name, "");
  EXPECT_THAT(one[0].spectrum.nm, ElementsAre(400, 450.5, 700));
  EXPECT_THAT(one[0].spectrum.values, ElementsAre(.1, .2, 1));
}

TEST(SpectraFile, NamesTheLineThatIsWrong) {
  EXPECT_THAT(file_complaint("400 0.1\n500 x\n"), HasSubstr("line 2: must be a wavelength"));
  EXPECT_THAT(file_complaint("400 0.1\n400 0.2\n"), HasSubstr("line 2: wavelengths must"));
  EXPECT_THAT(file_complaint("400 nan\n"), HasSubstr("line 1"));
  EXPECT_THAT(file_complaint("400 0.1 7\n"), HasSubstr("line 1"));
  EXPECT_THAT(file_complaint("# nothing\n"), HasSubstr("has no samples"));
  EXPECT_THAT(file_complaint(replaced(kCgats, "left 10", "left")), HasSubstr("line 11: "));
  EXPECT_THAT(file_complaint(replaced(kCgats, "5 5 5\t", "5 5 five ")),
              HasSubstr("\"five\" is no"));
  EXPECT_THAT(file_complaint(replaced(kCgats, "SPECTRAL_BANDS 4\n", "")),
              HasSubstr("SPECTRAL_BANDS"));
  EXPECT_THAT(file_complaint(replaced(kCgats, "SPECTRAL_BANDS 4", "SPECTRAL_BANDS 1e9")),
              HasSubstr("2..10000"));
  EXPECT_THAT(file_complaint(replaced(kCgats, "SPECTRAL_NORM 100", "SPECTRAL_NORM 0")),
              HasSubstr("SPECTRAL_NORM"));
  EXPECT_THAT(file_complaint("BEGIN_DATA\n"), HasSubstr("SPECTRAL_START_NM"));
}

TEST(SpectraFile, SaysThatThereIsNone) {
  EXPECT_THROW(read_spectra_file("/no/such.sp"), std::runtime_error);
}

}  // namespace
}  // namespace litmus

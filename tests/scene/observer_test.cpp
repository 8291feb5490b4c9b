// observer_test.cpp: the observer, the white points and the test colours against published values.
#include "scene/observer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>

#include "scene/refusal.h"
#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

/// Without the CIE's tables there is nothing to hold up to published values: say so.
#define NEEDS_COLORD()                                 \
  if (colord_file("cmf/CIE1931-2deg-XYZ.cmf").empty()) \
  GTEST_SKIP() << kColordPackage << " is not installed: the CIE's tables are not checked"

/// Looks for colord where there is none, until it goes out of scope.
class NoColord {
 public:
  NoColord() { setenv("XDG_DATA_DIRS", "/nonexistent", 1); }
  ~NoColord() {
    was_ ? (void)setenv("XDG_DATA_DIRS", kept_.c_str(), 1) : (void)unsetenv("XDG_DATA_DIRS");
  }

 private:
  const bool was_ = getenv("XDG_DATA_DIRS");
  const std::string kept_ = was_ ? getenv("XDG_DATA_DIRS") : "";
};

/// The sum over 380, 385, ... 780 nm, as tables of colorimetry are made: no bands.
glm::dvec3 xyz_at_5_nm(const Observer& observer, const Spectrum& light,
                       const Spectrum& reflectance = constant_spectrum(1)) {
  glm::dvec3 sum(0);
  for (int nm = 380; nm <= 780; nm += 5)
    sum += value_at(light, nm) * value_at(reflectance, nm) *
           glm::dvec3(value_at(observer.x, nm), value_at(observer.y, nm), value_at(observer.z, nm));
  return sum;
}

glm::dvec2 xy(const glm::dvec3& xyz) { return glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z); }

std::string five_digits(const glm::dvec2& v) {
  char text[32];
  snprintf(text, sizeof text, "%.5f %.5f", v.x, v.y);
  return text;
}

TEST(WhitePoint, OfAD65AndEIsThePublishedOneToFiveDigits) {
  NEEDS_COLORD();
  const Observer observer = cie_1931_observer();
  const auto white = [&](const char* name) {
    return five_digits(xy(xyz_at_5_nm(observer, illuminant(name).spectrum)));
  };
  EXPECT_EQ(white("A"), "0.44758 0.40745");
  EXPECT_EQ(white("D65"), "0.31272 0.32903");
  EXPECT_EQ(white("E"), "0.33333 0.33333");
}

/// The same from the 40 bands that scenes are rendered in.
TEST(WhitePoint, OfFortyBandsIsWithinTwoTenThousandths) {
  NEEDS_COLORD();
  const std::vector<glm::dvec3> bands =
      band_xyz(cie_1931_observer(), illuminant("D65").spectrum, kDefaultBands);
  for (const auto& [name, published] : {std::pair{"A", glm::dvec2(.44758, .40745)},
                                        {"D65", glm::dvec2(.31272, .32903)},
                                        {"E", glm::dvec2(1. / 3, 1. / 3)}}) {
    const std::vector<double> power = band_means(illuminant(name).spectrum, kDefaultBands);
    glm::dvec3 sum(0);
    for (std::size_t b = 0; b < bands.size(); ++b) sum += power[b] * bands[b];
    const glm::dvec2 apart = glm::abs(xy(sum) - published);
    EXPECT_LT(std::max(apart.x, apart.y), 2e-4) << name;
  }
}

TEST(IlluminantA, IsTheTableByItsFormula) {
  NEEDS_COLORD();
  const Spectrum table = read_spectra_file(colord_file("illuminant/CIE-A.sp")).front().spectrum;
  for (int nm = 380; nm <= 780; ++nm)
    EXPECT_NEAR(value_at(illuminant_a(), nm), value_at(table, nm), 5e-6) << nm;
}

/// Linear sRGB of a test colour by `count` bands.
glm::dvec3 by_bands(const Observer& observer, const Spectrum& light, const Spectrum& reflectance,
                    int count) {
  const std::vector<glm::dvec3> xyz = band_xyz(observer, illuminant("D65").spectrum, count);
  const std::vector<double> power = band_means(light, count), r = band_means(reflectance, count);
  glm::dvec3 sum(0);
  for (std::size_t b = 0; b < xyz.size(); ++b) sum += power[b] * r[b] * xyz[b];
  return linear_srgb(sum);
}

/// 40 bands of 10 nm against 80 of 5 nm and 400 of 1 nm.
TEST(TestColours, AtTenNanometresAreWithin15TenThousandthsOfFiveAndOfOne) {
  NEEDS_COLORD();
  const Observer observer = cie_1931_observer();
  const std::vector<NamedSpectrum> tiles = read_spectra_file(colord_file("ref/CIE-TCS.sp"));
  for (const std::string& name : illuminant_names()) {
    const Spectrum light = illuminant(name).spectrum;
    double from_five = 0, from_one = 0;
    for (std::size_t tile = 0; tile < 8; ++tile) {
      const Spectrum& reflectance = tiles[tile].spectrum;
      const glm::dvec3 ten = by_bands(observer, light, reflectance, 40);
      const glm::dvec3 five = glm::abs(ten - by_bands(observer, light, reflectance, 80));
      const glm::dvec3 one = glm::abs(ten - by_bands(observer, light, reflectance, 400));
      from_five = std::max({from_five, five.x, five.y, five.z});
      from_one = std::max({from_one, one.x, one.y, one.z});
    }
    EXPECT_LT(from_five, 1.5e-3) << name;
    EXPECT_LT(from_one, 1.5e-3) << name;
    EXPECT_GT(from_one, from_five) << name << ": finer bands are nearer";
    RecordProperty("from_5_nm_" + name, std::to_string(from_five));
    RecordProperty("from_1_nm_" + name, std::to_string(from_one));
  }
}

// ---- The colour rendering index (CIE 13.3-1995): published for the CIE's fluorescent lamps
// --------

struct Uv {
  double u, v;
};

Uv uv_of(const glm::dvec3& xyz) {
  const double sum = xyz.x + 15 * xyz.y + 3 * xyz.z;
  return {4 * xyz.x / sum, 6 * xyz.y / sum};
}

/// The mean of the indices of TCS01 to TCS08, each 100 - 4.6 times the difference in W*U*V*.
double rendering_index(const Observer& observer, const Spectrum& lamp, const Spectrum& reference,
                       const std::vector<NamedSpectrum>& tiles) {
  const glm::dvec3 lamp_white = xyz_at_5_nm(observer, lamp);
  const glm::dvec3 reference_white = xyz_at_5_nm(observer, reference);
  const Uv k = uv_of(lamp_white), r = uv_of(reference_white);
  const auto c = [](const Uv& p) { return (4 - p.u - 10 * p.v) / p.v; };
  const auto d = [](const Uv& p) { return (1.708 * p.v + .404 - 1.481 * p.u) / p.v; };
  const auto wuv = [&](double luminance, const Uv& p) {
    const double w = 25 * std::cbrt(luminance) - 17;
    return glm::dvec3(w, 13 * w * (p.u - r.u), 13 * w * (p.v - r.v));
  };
  double sum = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 seen = xyz_at_5_nm(observer, lamp, tiles[i].spectrum);
    const glm::dvec3 wanted = xyz_at_5_nm(observer, reference, tiles[i].spectrum);
    const double cc = c(r) / c(k) * c(uv_of(seen)), dd = d(r) / d(k) * d(uv_of(seen));
    const double below = 16.518 + 1.481 * cc - dd;
    const Uv adapted{(10.872 + .404 * cc - 4 * dd) / below, 5.520 / below};
    const double apart = glm::distance(wuv(100 * seen.y / lamp_white.y, adapted),
                                       wuv(100 * wanted.y / reference_white.y, uv_of(wanted)));
    sum += 100 - 4.6 * apart;
  }
  return sum / 8;
}

/// Correlated colour temperatures and indices as CIE 15:2004, table T.7, prints them.
TEST(TestColours, GiveThePublishedRenderingIndicesOfF2F4AndF11) {
  NEEDS_COLORD();
  const Observer observer = cie_1931_observer();
  const std::vector<NamedSpectrum> tiles = read_spectra_file(colord_file("ref/CIE-TCS.sp"));
  for (const auto& [name, kelvin, published] :
       {std::tuple{"F2", 4230, 64}, {"F4", 2940, 51}, {"F11", 4000, 83}}) {
    const std::string file = "illuminant/CIE-" + std::string(name) + ".sp";
    const Spectrum lamp = read_spectra_file(colord_file(file)).front().spectrum;
    EXPECT_NEAR(rendering_index(observer, lamp, blackbody(kelvin), tiles), published, 0.5) << name;
  }
}

/// CIE 13.3 chose them of Munsell value 6: 30 % of the light of illuminant C.
TEST(TestColours, ReflectAboutThirtyPercent) {
  NEEDS_COLORD();
  const Observer observer = cie_1931_observer();
  const Spectrum c = read_spectra_file(colord_file("illuminant/CIE-C.sp")).front().spectrum;
  const std::vector<NamedSpectrum> tiles = read_spectra_file(colord_file("ref/CIE-TCS.sp"));
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(xyz_at_5_nm(observer, c, tiles[i].spectrum).y / xyz_at_5_nm(observer, c).y, .30,
                .015)
        << tiles[i].name;
}

TEST(GaussianObserver, IsAsNearToTheTableAsItsPaperSays) {
  NEEDS_COLORD();
  const Observer table = cie_1931_observer(), fit = gaussian_observer();
  glm::dvec3 worst(0);
  for (int nm = 380; nm <= 780; nm += 5)
    worst = glm::max(worst, glm::abs(glm::dvec3(value_at(fit.x, nm) - value_at(table.x, nm),
                                                value_at(fit.y, nm) - value_at(table.y, nm),
                                                value_at(fit.z, nm) - value_at(table.z, nm))));
  EXPECT_NEAR(worst.x, .0138, 5e-5);
  EXPECT_NEAR(worst.y, .0073, 5e-5);
  EXPECT_NEAR(worst.z, .0221, 5e-5);
  EXPECT_TRUE(table.note.empty());
}

TEST(WithoutColord, StandInsSayWhatTheyAre) {
  const NoColord nowhere;
  EXPECT_TRUE(colord_file("cmf/CIE1931-2deg-XYZ.cmf").empty());
  EXPECT_THAT(cie_1931_observer().note, HasSubstr("apt-get install colord-data"));
  EXPECT_THAT(illuminant("D65").note, HasSubstr("blackbody of 6504 K"));
  EXPECT_TRUE(illuminant("A").note.empty());
  EXPECT_TRUE(illuminant("E").note.empty());
  const glm::dvec2 white = xy(xyz_at_5_nm(cie_1931_observer(), illuminant("D65").spectrum));
  EXPECT_NEAR(white.x, .3127, 2e-3);  // a blackbody is a little less green than daylight
  EXPECT_NEAR(white.y, .3290, 7e-3);
}

TEST(DamagedColord, IsRefusedWithTheRemedy) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "colord/illuminant");
  folder.write("colord/illuminant/CIE-D65.sp", "400 1\n500\n");
  setenv("XDG_DATA_DIRS", folder.path().c_str(), 1);
  std::string message;
  try {
    illuminant("D65");
  } catch (const Refusal& refusal) {
    message = refusal.what();
  }
  unsetenv("XDG_DATA_DIRS");
  EXPECT_THAT(message, HasSubstr("CIE-D65.sp: line 2"));
  EXPECT_THAT(message, HasSubstr("reinstall colord-data"));
}

TEST(LinearSrgb, HasWhiteForItsWhitePointAndRedForItsRed) {
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::all(glm::lessThan(glm::abs(a - b), glm::dvec3(1e-12)));
  };
  const double x = .3127, y = .3290;
  EXPECT_TRUE(near(linear_srgb(glm::dvec3(x / y, 1, (1 - x - y) / y)), {1, 1, 1}));
  const glm::dvec3 red = linear_srgb(glm::dvec3(.64, .33, .03));
  EXPECT_TRUE(near(red / red.x, {1, 0, 0}));
}

/// IEC 61966-2-1 prints the matrix with four digits.
TEST(LinearSrgb, IsTheStandardsMatrix) {
  const glm::dvec3 from_x = linear_srgb({1, 0, 0}), from_z = linear_srgb({0, 0, 1});
  EXPECT_NEAR(from_x.x, 3.2406, 5e-4);
  EXPECT_NEAR(from_x.y, -0.9689, 5e-4);
  EXPECT_NEAR(from_x.z, 0.0557, 5e-4);
  EXPECT_NEAR(from_z.x, -0.4986, 5e-4);
  EXPECT_NEAR(from_z.y, 0.0415, 5e-4);
  EXPECT_NEAR(from_z.z, 1.0570, 5e-4);
}

}  // namespace
}  // namespace litmus

// pictures_test.cpp: the report's pictures say what they are meant to.
#include "reports/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "compare/image_io.h"

namespace litmus {
namespace {
namespace fs = std::filesystem;
using ::testing::StartsWith;

constexpr std::string_view kHead = "data:image/png;base64,";

// The inverse of data_uri, written apart from it.
std::string decoded(std::string_view uri) {
  uri.remove_prefix(kHead.size());
  std::string bytes;
  int bits = 0, count = 0;
  for (const char c : uri) {
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                      : c == '/'             ? 63
                                             : -1;
    if (digit < 0) break;
    bits = (bits << 6 | digit) & 0xFFFF;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += char(bits >> count);
  }
  return bytes;
}

Picture shown(const std::string& uri) {
  std::string name = (fs::temp_directory_path() / "litmus-picture-XXXXXX.png").string();
  ::close(::mkstemps(name.data(), 4));
  std::ofstream(name, std::ios::binary) << decoded(uri);
  const Picture picture = read_picture(name);
  fs::remove(name);
  return picture;
}

TEST(DataUri, IsBase64WithItsPadding) {
  EXPECT_EQ(data_uri("Man"), std::string(kHead) + "TWFu");
  EXPECT_EQ(data_uri("Ma"), std::string(kHead) + "TWE=");
  EXPECT_EQ(data_uri("M"), std::string(kHead) + "TQ==");
  EXPECT_EQ(data_uri("\xFB\xFF"), std::string(kHead) + "+/8=");
  EXPECT_EQ(data_uri(""), kHead);
}

// One row of ours against zero, and the colours that it gets.
Picture colors(const std::vector<double>& differences, std::vector<std::uint8_t> edge = {}) {
  Picture ours(int(differences.size()), 1);
  for (std::size_t i = 0; i < differences.size(); ++i) ours.pixels[i].y = differences[i];
  return shown(difference_uri(ours, Picture(ours.width, 1), edge, 1e-6, 1e-3));
}

bool is_red(const glm::dvec3& color) { return color.r > color.b + 0.1; }
bool is_blue(const glm::dvec3& color) { return color.b > color.r + 0.1; }

TEST(DifferencePicture, IsRedWhereOursIsBrighterAndBlueWhereDarker) {
  const Picture picture = colors({1e-6, -1e-6, 0});
  EXPECT_TRUE(is_red(picture.at(0, 0)));
  EXPECT_TRUE(is_blue(picture.at(1, 0)));
  EXPECT_EQ(picture.at(2, 0), glm::dvec3(250 / 255.0));
}

TEST(DifferencePicture, GrowsDarkerWithTheDifference) {
  const Picture picture = colors({0, 0.3e-6, 0.6e-6, 1e-6, 1.001e-6});
  for (int x = 1; x < 5; ++x) EXPECT_LT(picture.at(x, 0).g, picture.at(x - 1, 0).g) << x;
}

TEST(DifferencePicture, SetsAPixelOverItsToleranceApart) {
  const Picture picture = colors({1e-6, 1.0001e-6, 5, -5});
  EXPECT_NE(picture.at(0, 0), picture.at(1, 0));
  EXPECT_EQ(picture.at(1, 0), picture.at(2, 0));
  EXPECT_EQ(over_color(true), "#8c0014");
  EXPECT_EQ(picture.at(2, 0), glm::dvec3(0x8c, 0, 0x14) / 255.0);
  EXPECT_TRUE(is_blue(picture.at(3, 0)));
}

TEST(DifferencePicture, MeasuresEdgesByTheirOwnTolerance) {
  const Picture picture = colors({1e-5, 1e-5, 2e-3}, {0, 1, 1});
  EXPECT_EQ(picture.at(0, 0), picture.at(2, 0)) << "both over";
  EXPECT_GT(picture.at(1, 0).g, 0.9) << "a hundredth of what an edge may be";
}

TEST(DifferencePicture, IsMagentaWhereAnyValueIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Picture picture = colors({nan, infinity, 0});
  EXPECT_EQ(picture.at(0, 0), glm::dvec3(1, 0, 1));
  EXPECT_EQ(picture.at(1, 0), glm::dvec3(1, 0, 1));
  EXPECT_NE(picture.at(2, 0), glm::dvec3(1, 0, 1));
}

TEST(Thumbnail, KeepsTheShapeAndAveragesLinearLight) {
  Picture picture(100, 50);
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 100; ++x) picture.at(x, y) = glm::dvec3(x % 2 == 0 ? 1 : 0);
  const Picture small = shown(thumbnail_uri(picture, 25));
  EXPECT_EQ(small.width, 25);
  EXPECT_EQ(small.height, 13);
  EXPECT_EQ(small.at(12, 6) * 255.0, glm::dvec3(188)) << "linear 0.5 in sRGB";
}

TEST(Thumbnail, IsNeverEnlarged) { EXPECT_EQ(shown(thumbnail_uri(Picture(7, 3), 72)).width, 7); }

}  // namespace
}  // namespace litmus

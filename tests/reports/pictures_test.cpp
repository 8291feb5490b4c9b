// pictures_test.cpp: the report's pictures say what they are meant to.
#include "reports/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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

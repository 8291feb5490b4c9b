// image_io_test.cpp: images survive the file, and bad files are refused.
#include "compare/image_io.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

#include "scene/refusal.h"
#include "tests/compare/pictures.h"

namespace litmus {
namespace {
namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A folder of its own for each test.
struct ImageFiles : ::testing::Test {
  fs::path folder;
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "litmus-image-XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string message_of(const std::function<void()>& action) {
    try {
      action();
    } catch (const Refusal& refusal) {
      return refusal.what();
    }
    return "(not refused)";
  }
};

Picture noise(int width, int height, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-30, 30);
  Picture picture(width, height);
  for (glm::dvec3& p : picture.pixels)
    p = {std::exp(exponent(random)), -std::exp(exponent(random)), std::exp(exponent(random))};
  return picture;
}

std::vector<std::uint32_t> float_bits(const Picture& picture) {
  std::vector<std::uint32_t> bits;
  for (const glm::dvec3& p : picture.pixels)
    for (int c = 0; c < 3; ++c) {
      const float value = float(p[c]);
      std::uint32_t pattern;
      std::memcpy(&pattern, &value, sizeof value);
      bits.push_back(pattern);
    }
  return bits;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

void write_other(const fs::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                 const void* values) {
  auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output && output->open(file.string(), spec)) << file;
  ASSERT_TRUE(output->write_image(type, values) && output->close()) << output->geterror();
}

TEST_F(ImageFiles, KeepEveryBitOfEveryFloat) {
  const Picture picture = noise(37, 21, 1);
  write_picture(folder / "x.exr", picture);
  EXPECT_EQ(float_bits(read_picture(folder / "x.exr")), float_bits(picture));
}

TEST_F(ImageFiles, KeepNonFiniteAndExtremeValues) {
  Picture picture(4, 1);
  picture.at(0, 0) = {kNaN, kInfinity, -kInfinity};
  picture.at(1, 0) = {1e-45, 3.4e38, -0.0};
  picture.at(2, 0) = {1e39, 1e-60, -1e-60};
  write_picture(folder / "x.exr", picture);
  const Picture read = read_picture(folder / "x.exr");
  EXPECT_TRUE(std::isnan(read.at(0, 0).x));
  EXPECT_EQ(read.at(0, 0).y, kInfinity);
  EXPECT_EQ(read.at(0, 0).z, -kInfinity);
  EXPECT_EQ(read.at(1, 0), glm::dvec3(double(1e-45f), double(3.4e38f), 0));
  EXPECT_TRUE(std::signbit(read.at(1, 0).z));
  EXPECT_EQ(read.at(2, 0), glm::dvec3(kInfinity, 0, 0)) << "beyond float's range";
}

TEST_F(ImageFiles, KeepEachLayerWithItsNameTypeAndMetadata) {
  const Layers layers{{"ambient", "ambient", noise(9, 5, 1)},
                      {"a <b> & \"c\" \xC3\xA9", "point", noise(9, 5, 2)},
                      {"lamp", "spot", noise(9, 5, 3)},
                      {"Lamp", "area", noise(9, 5, 4)}};
  const Metadata metadata{{"command", "povray +W9 \"x y\"\n-second line"}, {"version", "3.7.0.10"}};
  write_layers(folder / "x.exr", layers, metadata);
  const Layers read = read_layers(folder / "x.exr");
  ASSERT_EQ(read.size(), layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    EXPECT_EQ(read[i].light, layers[i].light);
    EXPECT_EQ(read[i].light_type, layers[i].light_type);
    EXPECT_EQ(float_bits(read[i].picture), float_bits(layers[i].picture)) << i;
  }
  EXPECT_EQ(read_metadata(folder / "x.exr"), metadata);
}

TEST_F(ImageFiles, KeepALayerForEachBandBesideTheColours) {
  const Picture colors = noise(5, 3, 1), bands = noise(5, 3, 2);
  const double wavelengths[] = {430, 530, 630, 730.5};
  write_bands(folder / "bands.exr", 5, 3, wavelengths,
              [&](const PutRows& put) {
                for (int y = 0; y < 3; ++y) {
                  std::vector<float> row;
                  for (int x = 0; x < 5; ++x) {
                    for (const Picture* one : {&colors, &bands})
                      for (int c = 0; c < 3; ++c) row.push_back(float(one->at(x, y)[c]));
                    row.push_back(float(x + 10 * y));
                  }
                  put(y, row);
                }
              },
              {{"scene", "w2"}});
  auto input = OIIO::ImageInput::open((folder / "bands.exr").string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec spec = input->spec();
  ASSERT_EQ(spec.nchannels, 7);
  EXPECT_EQ(spec.get_string_attribute("spectralLayoutVersion"), "1.0");
  EXPECT_EQ(read_metadata(folder / "bands.exr")["scene"], "w2");
  EXPECT_EQ(float_bits(read_picture(folder / "bands.exr")), float_bits(colors));
  std::vector<float> values(5 * 3 * 7);
  ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()));
  const auto value = [&](const char* name) {
    return values[std::size_t(7 * 8 + spec.channelindex(name))];  // pixel (3, 1)
  };
  EXPECT_EQ(value("S0.430,000000nm"), float(bands.at(3, 1).r));
  EXPECT_EQ(value("S0.530,000000nm"), float(bands.at(3, 1).g));
  EXPECT_EQ(value("S0.630,000000nm"), float(bands.at(3, 1).b));
  EXPECT_EQ(value("S0.730,500000nm"), 13);
}

TEST_F(ImageFiles, AreNotWrittenWithRowsLeftOut) {
  const double wavelengths[] = {430};
  const std::vector<float> row(5 * 4);
  for (const int second : {0, 2})
    EXPECT_THROW(write_bands(folder / "gap.exr", 5, 3, wavelengths,
                             [&](const PutRows& put) { put(0, row), put(second, row); }),
                 std::invalid_argument);
  EXPECT_THROW(
      write_bands(folder / "gap.exr", 5, 3, wavelengths, [&](const PutRows& put) { put(0, row); }),
      std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "gap.exr"));
}

TEST_F(ImageFiles, RefuseLayersThatCannotBeToldApart) {
  const Picture picture = noise(3, 2, 1);
  for (const std::string second : {"lamp", ""})
    EXPECT_THAT(
        message_of([&] {
          write_layers(folder / "x.exr", {{"lamp", "spot", picture}, {second, "point", picture}});
        }),
        HasSubstr("two layers are named '" + second + "'"));
}

TEST_F(ImageFiles, ReplaceAFileAndLeaveNothingElseBehind) {
  write_picture(folder / "x.exr", noise(3, 2, 1));
  write_picture(folder / "x.exr", noise(3, 2, 2));
  EXPECT_EQ(float_bits(read_picture(folder / "x.exr")), float_bits(noise(3, 2, 2)));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(ImageFiles, ThatCannotBeWrittenAreNamed) {
  const std::string message =
      message_of([&] { write_picture(folder / "missing" / "x.exr", noise(3, 2, 1)); });
  EXPECT_THAT(message, HasSubstr((folder / "missing" / "x.exr").string() + ": cannot be written"));
}

TEST_F(ImageFiles, RefuseLayersOfDifferentSize) {
  EXPECT_THAT(message_of([&] {
                write_layers(folder / "x.exr",
                             {{"a", "point", noise(3, 2, 1)}, {"b", "point", noise(2, 3, 1)}});
              }),
              HasSubstr("layer 'b' is 2 x 3, the first one 3 x 2"));
  EXPECT_FALSE(fs::exists(folder / "x.exr"));
}

TEST_F(ImageFiles, ThatAreMissingAreNamed) {
  EXPECT_THAT(message_of([&] { read_picture(folder / "no.exr"); }),
              HasSubstr((folder / "no.exr").string() + ": there is no such file"));
}

TEST_F(ImageFiles, ThatAreNoImagesAreRefused) {
  write_bytes(folder / "x.exr", "this is not an image");
  EXPECT_THAT(message_of([&] { read_picture(folder / "x.exr"); }),
              HasSubstr("not a readable image"));
  EXPECT_THAT(message_of([&] { read_layers(folder / "x.exr"); }),
              HasSubstr("not a readable image"));
}

TEST_F(ImageFiles, CutShortAnywhereAreRefused) {
  write_layers(folder / "whole.exr",
               {{"a", "point", noise(40, 40, 1)}, {"b", "point", noise(40, 40, 2)}});
  const std::string whole = bytes_of(folder / "whole.exr");
  ASSERT_GT(whole.size(), 1000u);
  for (const double part : {0.0, 0.001, 0.05, 0.3, 0.7, 0.9, 0.999}) {
    write_bytes(folder / "cut.exr", whole.substr(0, std::size_t(part * double(whole.size()))));
    EXPECT_THROW(read_layers(folder / "cut.exr"), Refusal) << part;
  }
  write_bytes(folder / "cut.exr", whole);
  EXPECT_NO_THROW(read_layers(folder / "cut.exr"));
}

TEST_F(ImageFiles, WithADamagedChunkAreRefused) {
  Picture picture(64, 64);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i].x = double(i);
  write_picture(folder / "x.exr", picture);
  std::string bytes = bytes_of(folder / "x.exr");
  for (std::size_t i = 0; i < 16; ++i) bytes[bytes.size() - 100 + i] ^= 0x5a;
  write_bytes(folder / "x.exr", bytes);
  EXPECT_THAT(message_of([&] { read_picture(folder / "x.exr"); }), HasSubstr("is damaged"));
}

// The header is rewritten to claim 1,000,000 x 64 pixels: the file stays small.
TEST_F(ImageFiles, ThatWouldFillTheMemoryAreRefusedBeforeDecoding) {
  write_picture(folder / "x.exr", Picture(64, 64));
  std::string bytes = bytes_of(folder / "x.exr");
  for (const std::string name : {"dataWindow", "displayWindow"}) {
    const std::size_t box = bytes.find(name) + name.size() + 1 + sizeof "box2i" + 4;
    const std::int32_t last_column = 999'999;
    std::memcpy(bytes.data() + box + 8, &last_column, 4);
  }
  write_bytes(folder / "x.exr", bytes);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(message_of([&] { read_picture(folder / "x.exr"); }), HasSubstr("the limit is 1 GiB"));
  EXPECT_THAT(message_of([&] { read_layers(folder / "x.exr"); }), HasSubstr("the limit is 1 GiB"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST_F(ImageFiles, GiveSixteenBitCodeValuesWithoutATransferFunction) {
  std::vector<std::uint16_t> codes(65536 * 3);
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = std::uint16_t(i / 3);
  OIIO::ImageSpec spec(256, 256, 3, OIIO::TypeDesc::UINT16);
  spec.attribute("oiio:Gamma", 2.2f);
  write_other(folder / "x.png", spec, OIIO::TypeDesc::UINT16, codes.data());
  const Picture picture = read_picture(folder / "x.png");
  for (std::size_t code = 0; code < 65536; ++code)
    ASSERT_EQ(picture.pixels[code], glm::dvec3(double(code) / 65535));
}

TEST_F(ImageFiles, GiveEightBitCodeValuesUntouchedByAlpha) {
  const std::vector<std::uint8_t> codes{0, 51, 255, 0, 255, 102, 0, 128};
  write_other(
      folder / "x.png",
      [] {
        OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeDesc::UINT8);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        return spec;
      }(),
      OIIO::TypeDesc::UINT8, codes.data());
  const Picture picture = read_picture(folder / "x.png");
  EXPECT_EQ(picture.at(0, 0), glm::dvec3(0, 0.2, 1)) << "alpha 0";
  EXPECT_EQ(picture.at(1, 0), glm::dvec3(1, 0.4, 0));
}

TEST_F(ImageFiles, TripleAGreyChannelAndRefuseTwo) {
  const std::vector<float> values{0.25f, 0.5f, 0.75f, 1};
  write_other(folder / "grey.exr", OIIO::ImageSpec(2, 2, 1, OIIO::TypeDesc::FLOAT),
              OIIO::TypeDesc::FLOAT, values.data());
  EXPECT_EQ(read_picture(folder / "grey.exr").at(1, 1), glm::dvec3(1));
  EXPECT_EQ(read_picture(folder / "grey.exr").at(0, 1), glm::dvec3(0.75));
  write_other(folder / "two.exr", OIIO::ImageSpec(2, 1, 2, OIIO::TypeDesc::FLOAT),
              OIIO::TypeDesc::FLOAT, values.data());
  EXPECT_THAT(message_of([&] { read_picture(folder / "two.exr"); }), HasSubstr("has 2 channels"));
}

TEST_F(ImageFiles, CroppedByTheirDataWindowAreRefused) {
  OIIO::ImageSpec spec(2, 2, 3, OIIO::TypeDesc::FLOAT);
  spec.full_width = spec.full_height = 4;
  spec.x = spec.y = 1;
  const std::vector<float> values(12);
  write_other(folder / "x.exr", spec, OIIO::TypeDesc::FLOAT, values.data());
  EXPECT_THAT(message_of([&] { read_picture(folder / "x.exr"); }), HasSubstr("crop"));
}

// PFM stores the bottom row first, little-endian where the scale is negative.
TEST_F(ImageFiles, ReadPfmTopDown) {
  const std::vector<float> values{4, 5, 6, 1, 2, 3};
  std::string bytes = "PF\n1 2\n-1.0\n";
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  write_bytes(folder / "x.pfm", bytes);
  const Picture picture = read_picture(folder / "x.pfm");
  EXPECT_EQ(picture.at(0, 0), glm::dvec3(1, 2, 3));
  EXPECT_EQ(picture.at(0, 1), glm::dvec3(4, 5, 6));
}

// RGBE: (mantissa, exponent) = (128, 129) is 1.
TEST_F(ImageFiles, ReadRadianceHdr) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n";
  write_bytes(folder / "x.hdr", header + std::string("\x80\x40\x20\x81\x80\x80\x80\x83", 8));
  const Picture picture = read_picture(folder / "x.hdr");
  EXPECT_EQ(picture.at(0, 0), glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(picture.at(0, 1), glm::dvec3(4));
}

TEST_F(ImageFiles, NotOfLitmusHaveNoLayers) {
  const std::vector<float> values(12);
  write_other(folder / "x.exr", OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::FLOAT),
              OIIO::TypeDesc::FLOAT, values.data());
  EXPECT_NO_THROW(read_picture(folder / "x.exr"));
  EXPECT_THAT(message_of([&] { read_layers(folder / "x.exr"); }),
              HasSubstr("not written by litmus"));
}

TEST_F(ImageFiles, ForPeopleAreSrgbAndShowNonFinitePixelsInMagenta) {
  Picture picture(5, 1);
  picture.at(0, 0) = glm::dvec3(0);
  picture.at(1, 0) = {0.215860500, 2, -1};  // sRGB 128/255
  picture.at(2, 0) = {0, kNaN, 0};
  picture.at(3, 0) = {kInfinity, 0, 0};
  picture.at(4, 0) = glm::dvec3(0.001);  // on the linear piece: 12.92 * 0.001 * 255 = 3.29
  write_bytes(folder / "x.png", encode_png(picture));
  const Picture shown = read_picture(folder / "x.png");
  EXPECT_EQ(shown.at(0, 0), glm::dvec3(0));
  EXPECT_EQ(shown.at(1, 0) * 255.0, glm::dvec3(128, 255, 0));
  EXPECT_EQ(shown.at(2, 0), glm::dvec3(1, 0, 1));
  EXPECT_EQ(shown.at(3, 0), glm::dvec3(1, 0, 1));
  EXPECT_EQ(shown.at(4, 0) * 255.0, glm::dvec3(3));
}

}  // namespace
}  // namespace litmus

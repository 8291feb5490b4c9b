// openimageio.cpp: image files through OpenImageIO, as a module that image_io.cpp opens.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "compare/image_library.h"
#include "compare/whole_file.h"
#include "scene/refusal.h"

namespace litmus {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = "litmus:";
constexpr std::string_view kLight = "litmus:light";
constexpr std::string_view kLightType = "litmus:light_type";

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw Refusal(fmt::format("{}: {}", file.string(), what));
}

// ---- Writing ---------------------------------------------------------------------------------

OIIO::ImageSpec part_spec(const Layer& layer, const Metadata& metadata) {
  OIIO::ImageSpec spec(layer.picture.width, layer.picture.height, 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("oiio:subimagename", layer.light);
  spec.attribute(kLight, layer.light);
  spec.attribute(kLightType, layer.light_type);
  for (const auto& [key, value] : metadata) spec.attribute(std::string(kPrefix) + key, value);
  return spec;
}

std::vector<float> as_floats(const Picture& picture) {
  std::vector<float> values;
  values.reserve(picture.pixels.size() * 3);
  for (const glm::dvec3& pixel : picture.pixels)
    for (int c = 0; c < 3; ++c) values.push_back(float(pixel[c]));
  return values;
}

void check_layers(const fs::path& file, const Layers& layers, const Metadata& metadata) {
  if (layers.empty()) refuse(file, "there is no layer to write");
  const Picture& first = layers.front().picture;
  std::set<std::string_view> names;
  for (const Layer& layer : layers) {
    const Picture& picture = layer.picture;
    if (layer.light.empty() || !names.insert(layer.light).second)
      refuse(file, fmt::format("two layers are named '{}', or one has no name", layer.light));
    if (picture.width < 1 || picture.height < 1 ||
        picture.pixels.size() != std::size_t(picture.width) * std::size_t(picture.height))
      refuse(file, fmt::format("layer '{}' has no pixels", layer.light));
    if (picture.width != first.width || picture.height != first.height)
      refuse(file, fmt::format("layer '{}' is {} x {}, the first one {} x {}", layer.light,
                               picture.width, picture.height, first.width, first.height));
  }
  for (const auto& [key, value] : metadata)
    if (std::string(kPrefix) + key == kLight || std::string(kPrefix) + key == kLightType)
      refuse(file, fmt::format("metadata may not be named '{}': it names the part", key));
}

void write_parts(const fs::path& temporary, const fs::path& file, const Layers& layers,
                 const std::vector<OIIO::ImageSpec>& specs) {
  auto output = OIIO::ImageOutput::create("openexr");
  if (!output) refuse(file, "cannot be written: OpenImageIO lacks OpenEXR");
  const auto check = [&](bool ok) {
    if (!ok) refuse(file, "cannot be written: " + output->geterror());
  };
  check(output->open(temporary.string(), int(specs.size()), specs.data()));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (i > 0) check(output->open(temporary.string(), specs[i], OIIO::ImageOutput::AppendSubimage));
    const std::vector<float> values = as_floats(layers[i].picture);
    check(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  }
  check(output->close());
}

// ---- Bands -----------------------------------------------------------------------------------

std::string channel_name(double wavelength) {
  std::string number = fmt::format("{:.6f}", wavelength);
  number[number.find('.')] = ',';  // a point would begin another layer
  return "S0." + number + "nm";
}

void write_rows(const fs::path& temporary, const fs::path& file, const OIIO::ImageSpec& spec,
                const std::function<void(const PutRows& put)>& fill) {
  auto output = OIIO::ImageOutput::create("openexr");
  if (!output) refuse(file, "cannot be written: OpenImageIO lacks OpenEXR");
  const auto check = [&](bool ok) {
    if (!ok) refuse(file, "cannot be written: " + output->geterror());
  };
  check(output->open(temporary.string(), spec));
  int next = 0;
  fill([&](int first, std::span<const float> values) {
    const int count = int(values.size() / std::size_t(spec.width * spec.nchannels));
    if (first != next || first + count > spec.height)
      throw std::invalid_argument(fmt::format("rows from {} on where {} comes next", first, next));
    next += count;
    check(output->write_scanlines(first, next, 0, OIIO::TypeDesc::FLOAT, values.data()));
  });
  if (next != spec.height) throw std::invalid_argument(fmt::format("only {} rows", next));
  check(output->close());
}

// ---- Reading ---------------------------------------------------------------------------------

std::unique_ptr<OIIO::ImageInput> open(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) refuse(file, "there is no such file");
  // Without this, OpenImageIO multiplies a PNG's colours by its alpha.
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(file.string(), &config);
  if (!input) refuse(file, "is not a readable image: " + OIIO::geterror());
  return input;
}

// Bytes that reading one part takes: the file's own type or our doubles, whichever is more.
std::int64_t decoded_bytes(const OIIO::ImageSpec& spec) {
  const double pixels = double(spec.width) * spec.height * std::max(1, spec.depth);
  const double bytes =
      std::max(pixels * double(sizeof(glm::dvec3)), pixels * double(spec.pixel_bytes(true)));
  return std::int64_t(std::min(bytes, 9e18));
}

void check_spec(const fs::path& file, const OIIO::ImageSpec& spec) {
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.deep)
    refuse(file, "is not a flat two-dimensional image");
  if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
      spec.height != spec.full_height)
    refuse(file,
           "holds a crop of its image (data window and display window differ); save it whole");
  if (spec.nchannels != 1 && spec.nchannels < 3)
    refuse(file, fmt::format("has {} channels; 1, or 3 and more are read", spec.nchannels));
}

void check_size(const fs::path& file, std::int64_t bytes) {
  if (bytes <= kMaximumImageBytes) return;
  refuse(file, fmt::format("would take {:.1f} GiB once decoded; the limit is {:.0f} GiB",
                           std::ldexp(double(bytes), -30), std::ldexp(kMaximumImageBytes, -30)));
}

template <class T>
Picture read_pixels(const fs::path& file, OIIO::ImageInput& input, int part,
                    const OIIO::ImageSpec& spec, OIIO::TypeDesc type, double divisor) {
  const int channels = std::min(spec.nchannels, 3);
  Picture picture(spec.width, spec.height);
  std::vector<T> values(picture.pixels.size() * std::size_t(channels));
  if (!input.read_image(part, 0, 0, channels, type, values.data()))
    refuse(file, "is damaged: " + input.geterror());
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      picture.pixels[i][int(c)] =
          double(values[i * std::size_t(channels) + (channels == 3 ? c : 0)]) / divisor;
  return picture;
}

// Integers are divided here, in double: OpenImageIO's own conversion rounds to float.
Picture read_part(const fs::path& file, OIIO::ImageInput& input, int part,
                  const OIIO::ImageSpec& spec) {
  check_spec(file, spec);
  switch (spec.format.basetype) {
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
      return read_pixels<float>(file, input, part, spec, OIIO::TypeDesc::FLOAT, 1);
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::UINT16:
      return read_pixels<std::uint16_t>(file, input, part, spec, OIIO::TypeDesc::UINT16, 65535);
    default:
      return read_pixels<double>(file, input, part, spec, OIIO::TypeDesc::DOUBLE, 1);
  }
}

// ---- The border ------------------------------------------------------------------------------

class OpenImageIO final : public ImageLibrary {
 public:
  void write_layers(const fs::path& file, const Layers& layers,
                    const Metadata& metadata) const override {
    check_layers(file, layers, metadata);
    std::vector<OIIO::ImageSpec> specs;
    for (const Layer& layer : layers) specs.push_back(part_spec(layer, metadata));
    write_whole(file,
                [&](const fs::path& temporary) { write_parts(temporary, file, layers, specs); });
  }

  void write_bands(const fs::path& file, int width, int height, std::span<const double> wavelengths,
                   const std::function<void(const PutRows& put)>& fill,
                   const Metadata& metadata) const override {
    OIIO::ImageSpec spec = part_spec({"all", "all", Picture()}, metadata);
    spec.width = spec.full_width = width, spec.height = spec.full_height = height;
    spec.nchannels = int(3 + wavelengths.size());
    spec.channelnames = {"R", "G", "B"};
    for (const double wavelength : wavelengths)
      spec.channelnames.push_back(channel_name(wavelength));
    spec.attribute("spectralLayoutVersion", "1.0");
    spec.attribute("emissiveUnits", "relative");
    write_whole(file, [&](const fs::path& temporary) { write_rows(temporary, file, spec, fill); });
  }

  Layers read_layers(const fs::path& file) const override {
    auto input = open(file);
    // Add up the headers before anything is decoded.
    std::vector<OIIO::ImageSpec> specs;
    std::int64_t bytes = 0;
    while (input->seek_subimage(int(specs.size()), 0)) {
      specs.push_back(input->spec());
      check_spec(file, specs.back());
      if (specs.back().find_attribute(kLight, OIIO::TypeDesc::STRING) == nullptr)
        refuse(file, fmt::format("part {} does not name its light; it was not written by litmus",
                                 specs.size()));
      const std::int64_t part_bytes = decoded_bytes(specs.back());
      bytes += std::min(part_bytes, kMaximumImageBytes + 1);
      check_size(file, std::max(bytes, part_bytes));
    }
    (void)input->geterror();  // the seek past the last part
    Layers layers;
    for (std::size_t i = 0; i < specs.size(); ++i)
      layers.push_back({std::string(specs[i].get_string_attribute(kLight)),
                        std::string(specs[i].get_string_attribute(kLightType)),
                        read_part(file, *input, int(i), specs[i])});
    return layers;
  }

  Metadata read_metadata(const fs::path& file) const override {
    auto input = open(file);
    Metadata metadata;
    for (const OIIO::ParamValue& attribute : input->spec().extra_attribs) {
      const std::string name = attribute.name().string();
      if (!name.starts_with(kPrefix) || name == kLight || name == kLightType) continue;
      metadata[name.substr(kPrefix.size())] = attribute.get_string();
    }
    return metadata;
  }

  Picture read_picture(const fs::path& file) const override {
    auto input = open(file);
    const OIIO::ImageSpec spec = input->spec();
    check_size(file, decoded_bytes(spec));
    return read_part(file, *input, 0, spec);
  }

  std::string encode_png(int width, int height, std::span<const std::uint8_t> rgb) const override {
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 9);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    auto output = OIIO::ImageOutput::create("png", &memory);
    if (!output || !output->open("memory.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, rgb.data()) || !output->close())
      throw Refusal(
          "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
          " cannot be encoded as PNG: " + (output ? output->geterror() : OIIO::geterror()));
    return {bytes.begin(), bytes.end()};
  }

  std::string version() const override {
    return fmt::format("{}.{}.{}", OIIO_VERSION_MAJOR, OIIO_VERSION_MINOR, OIIO_VERSION_PATCH);
  }
};

}  // namespace
}  // namespace litmus

extern "C" const litmus::ImageLibrary* litmus_image_library() {
  static const litmus::OpenImageIO library;
  return &library;
}

// image_io.cpp: opens the module with OpenImageIO when the first image is read or written. With
// everything that OpenImageIO brings, opening takes longer than most commands without an image.
#include "compare/image_io.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/image_library.h"
#include "scene/refusal.h"

namespace litmus {
namespace fs = std::filesystem;
namespace {

const ImageLibrary* open_module() {
  void* module = dlopen(kImageModule, RTLD_LAZY | RTLD_LOCAL);
  void* entry = module != nullptr ? dlsym(module, kImageModuleEntry) : nullptr;
  if (entry == nullptr)
    throw Refusal(
        fmt::format("images are read and written by {}, which cannot be opened: {}; it is"
                    " built with litmus and belongs into the program's folder",
                    kImageModule, dlerror()));
  return reinterpret_cast<ImageModuleEntry*>(entry)();
}

const ImageLibrary& library() {
  static const ImageLibrary* const opened = open_module();  // never closed
  return *opened;
}

// The sRGB transfer function (IEC 61966-2-1), as an 8-bit code value.
std::uint8_t srgb_code(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return std::uint8_t(std::lround(255 * encoded));
}

}  // namespace

void write_layers(const fs::path& file, const Layers& layers, const Metadata& metadata) {
  library().write_layers(file, layers, metadata);
}

Layers read_layers(const fs::path& file) { return library().read_layers(file); }

Metadata read_metadata(const fs::path& file) { return library().read_metadata(file); }

void write_picture(const fs::path& file, const Picture& picture, const Metadata& metadata) {
  write_layers(file, {{"all", "all", picture}}, metadata);
}

void write_bands(const fs::path& file, int width, int height, std::span<const double> wavelengths,
                 const std::function<void(const PutRows& put)>& fill, const Metadata& metadata) {
  library().write_bands(file, width, height, wavelengths, fill, metadata);
}

Picture read_picture(const fs::path& file) { return library().read_picture(file); }

std::string encode_png(int width, int height, std::span<const std::uint8_t> rgb) {
  return library().encode_png(width, height, rgb);
}

std::string encode_png(const Picture& picture) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(picture.pixels.size() * 3);
  for (const glm::dvec3& p : picture.pixels) {
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    const glm::dvec3 shown = finite ? p : glm::dvec3(1, 0, 1);
    for (int c = 0; c < 3; ++c) rgb.push_back(srgb_code(shown[c]));
  }
  return encode_png(picture.width, picture.height, rgb);
}

std::string image_library_version() { return library().version(); }

}  // namespace litmus

// image_library.h: the border between litmus and its one module that is linked with OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "compare/image_io.h"

namespace litmus {

/// What image_io.h promises, as the module does it. Each member is the function of its name.
class ImageLibrary {
 public:
  virtual void write_layers(const std::filesystem::path& file, const Layers& layers,
                            const Metadata& metadata) const = 0;
  virtual void write_bands(const std::filesystem::path& file, int width, int height,
                           std::span<const double> wavelengths,
                           const std::function<void(const PutRows& put)>& fill,
                           const Metadata& metadata) const = 0;
  virtual Layers read_layers(const std::filesystem::path& file) const = 0;
  virtual Metadata read_metadata(const std::filesystem::path& file) const = 0;
  virtual Picture read_picture(const std::filesystem::path& file) const = 0;
  virtual std::string encode_png(int width, int height,
                                 std::span<const std::uint8_t> rgb) const = 0;
  virtual std::string version() const = 0;

 protected:
  ~ImageLibrary() = default;
};

/// The file name of the module, which lies beside the program.
inline constexpr const char* kImageModule = "liblitmus_images.so";

/// The one symbol that the module gives away, and its type.
inline constexpr const char* kImageModuleEntry = "litmus_image_library";
using ImageModuleEntry = const ImageLibrary*();

}  // namespace litmus

// image_io.h: reading and writing image files, through OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "scene/picture.h"

namespace litmus {

// What opens a file, encodes one or asks for the version throws Refusal where OpenImageIO's module
// (compare/module) is not beside the program.

using Metadata = std::map<std::string, std::string>;

/// The largest image that is read, in bytes of decoded pixels. The header is checked first: a file
/// of 1.5 MB can hold 16000 x 16000 pixels.
inline constexpr std::int64_t kMaximumImageBytes = std::int64_t{1} << 30;

/// Writes 32-bit float EXR, one part per layer (the part is named after the light, its type is the
/// attribute "litmus:light_type"), lossless but for metadata with an empty value. The layers have
/// one size and different names. The file appears whole or not at all (temporary + rename). Throws
/// Refusal naming the file.
void write_layers(const std::filesystem::path& file, const Layers& layers,
                  const Metadata& metadata = {});

/// Reads what write_layers wrote. Throws Refusal naming the file and what is wrong with it.
Layers read_layers(const std::filesystem::path& file);
Metadata read_metadata(const std::filesystem::path& file);

/// One picture as one-part 32-bit float EXR.
void write_picture(const std::filesystem::path& file, const Picture& picture,
                   const Metadata& metadata = {});

/// One picture and what it is made of per wavelength, as a one-part 32-bit float EXR: R, G and B,
/// and for each of `wavelengths` (nm) a layer of its own with its middle wavelength for a name, as
/// the spectral layout of OpenEXR has them (Fichet, Pacanowski and Wilkie, JCGT 10(3), 2021):
/// "S0.385,000000nm". `fill` calls what it is given with some rows at a time, from the top, without
/// a gap: the first one's number and R, G, B and the bands of each pixel. Throws Refusal naming the
/// file, or for rows that are not the next ones std::invalid_argument.
using PutRows = std::function<void(int first, std::span<const float> values)>;
void write_bands(const std::filesystem::path& file, int width, int height,
                 std::span<const double> wavelengths,
                 const std::function<void(const PutRows& put)>& fill,
                 const Metadata& metadata = {});

/// Reads the first three channels (one grey channel is tripled) of a file's first part: EXR, PFM,
/// HDR as stored, PNG as code value / maximum code value, without any transfer function. Throws
/// Refusal on a missing or damaged file, on two or no channels, and above kMaximumImageBytes.
/// Damage inside a part that did not compress goes unnoticed: whoever keeps images keeps checksums.
Picture read_picture(const std::filesystem::path& file);

/// 8-bit sRGB PNG for people, exposure 1, values clipped to [0, 1], as bytes (for embedding). A
/// pixel that is not finite is magenta.
std::string encode_png(const Picture& picture);

/// The same from display values as they are: width * height * 3 bytes, row by row.
std::string encode_png(int width, int height, std::span<const std::uint8_t> rgb);

/// The version of OpenImageIO that reads and writes the images, as "2.4.7".
std::string image_library_version();

}  // namespace litmus

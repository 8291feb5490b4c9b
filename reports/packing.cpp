// packing.cpp: half floats, guesses, zlib and base64.
#include "reports/packing.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

namespace litmus {
namespace {

constexpr int kTopExponent = 15;  // half floats end just below 2^16

std::string deflated_bytes(std::string_view bytes, int level = 9) {
  uLongf size = compressBound(uLong(bytes.size()));
  std::string result(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size()), level);
  if (status != Z_OK) throw std::runtime_error("zlib cannot deflate a picture");
  result.resize(size);
  return result;
}

// High bytes first, then low bytes: what is alike stands together.
std::string shuffled(std::span<const std::uint16_t> words) {
  std::string bytes;
  bytes.reserve(words.size() * 2);
  for (const std::uint16_t word : words) bytes += char(word >> 8);
  for (const std::uint16_t word : words) bytes += char(word & 255);
  return bytes;
}

using Words = std::vector<std::uint16_t>;

std::uint16_t guessed(const Words& words, std::size_t i, std::size_t width, Guess guess) {
  if (i % width == 0) return i >= width ? words[i - width] : 0;
  const std::uint16_t left = words[i - 1];
  if (guess == Guess::Line) return i % width > 1 ? std::uint16_t(2 * left - words[i - 2]) : left;
  return i >= width ? std::uint16_t(left + words[i - width] - words[i - width - 1]) : left;
}

Words distances(const Words& words, std::size_t width, Guess guess) {
  Words result(words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const int d = std::int16_t(std::uint16_t(words[i] - guessed(words, i, width, guess)));
    result[i] = std::uint16_t(d < 0 ? -2 * d - 1 : 2 * d);
  }
  return result;
}

int exponent_for(const Picture& picture) {
  const double largest = largest_finite(picture);
  return largest > 0 ? kTopExponent - std::ilogb(largest) - 1 : 0;
}

// The words as PackedPicture says.
Words words_of(const Picture& picture, double step, int exponent) {
  const std::size_t count = picture.pixels.size();
  Words words(count * 3);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t before = 0;
    for (int c = 0; c < 3; ++c) {
      double value = picture.pixels[i][c];
      if (step > 0 && std::isfinite(value)) value = std::nearbyint(value / step) * step + 0.0;
      const std::uint16_t bits = half_bits(std::ldexp(value, exponent));
      words[std::size_t(c) * count + i] = std::uint16_t(bits - before);
      before = bits;
    }
  }
  return words;
}

}  // namespace

double largest_finite(const Picture& picture) {
  double largest = 0;
  for (const glm::dvec3& pixel : picture.pixels)
    for (int c = 0; c < 3; ++c)
      if (std::isfinite(pixel[c])) largest = std::max(largest, std::abs(pixel[c]));
  return largest;
}

std::uint16_t half_bits(double value) {
  if (std::isnan(value)) return 0x7e00;
  const std::uint16_t sign = std::signbit(value) ? 0x8000 : 0;
  const double size = std::abs(value);
  if (size >= 65520) return sign | 0x7c00;
  const int exponent = size > 0 ? std::max(std::ilogb(size), -14) : -14;
  // The leading bit of a normal number adds one to the exponent's field.
  const auto digits = std::uint16_t(std::nearbyint(std::ldexp(size, 10 - exponent)));
  return std::uint16_t(sign | (((exponent + 14) << 10) + digits));
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j > bytes.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
  }
  return text;
}

std::string deflated(std::string_view bytes) { return base64(deflated_bytes(bytes)); }

std::string_view name_of(Guess guess) {
  constexpr std::string_view names[] = {"none", "line", "plane"};
  return names[int(guess)];
}

PackedPicture packed(const Picture& picture, double step) {
  PackedPicture result;
  result.exponent = exponent_for(picture);
  const Words words = words_of(picture, step, result.exponent);
  std::string kept = shuffled(words);
  // A quick look tells which guess packs best.
  std::size_t least = deflated_bytes(kept, 1).size();
  for (const Guess guess : {Guess::Line, Guess::Plane}) {
    std::string bytes = shuffled(distances(words, std::size_t(picture.width), guess));
    const std::size_t size = deflated_bytes(bytes, 1).size();
    if (size >= least) continue;
    least = size, kept = std::move(bytes), result.guess = guess;
  }
  result.data = base64(deflated_bytes(kept));
  return result;
}

Picture as_unpacked(const Picture& picture) {
  const int exponent = exponent_for(picture);
  Picture result = picture;
  for (glm::dvec3& pixel : result.pixels)
    for (int c = 0; c < 3; ++c) {
      if (pixel[c] == 0 || !std::isfinite(pixel[c])) continue;
      const int digit = std::max(std::ilogb(pixel[c]) + exponent, -14) - 10;  // of the last bit
      pixel[c] =
          std::ldexp(std::nearbyint(std::ldexp(pixel[c], exponent - digit)), digit - exponent);
    }
  return result;
}

}  // namespace litmus

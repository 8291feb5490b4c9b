// pictures.cpp: the small pictures of a report, as text that a page can hold.
#include "reports/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compare/image_io.h"

namespace litmus {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

// A diverging scale that reads the same with any colour vision: blue - white - red.
constexpr std::array<Rgb, 5> kScale{
    {{67, 147, 195}, {172, 210, 230}, {250, 250, 250}, {250, 196, 168}, {222, 110, 84}}};
constexpr Rgb kUnder{5, 40, 120}, kOver{140, 0, 20}, kNotFinite{255, 0, 255};
constexpr int kSteps = 16;  // a side: few colours keep the PNG small

std::string css(const Rgb& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

// The colour of a share in [-1, 1]. The root lets a hundredth of the scale show as a tenth of its
// colour: what rounding leaves over keeps its shape without looking like an error.
Rgb scale_color(double share) {
  const double rooted = std::copysign(std::sqrt(std::abs(share)), share);
  const double stepped = std::round(rooted * kSteps) / kSteps;
  const double position = (stepped + 1) / 2 * double(kScale.size() - 1);
  const auto lower = std::min(std::size_t(position), kScale.size() - 2);
  const double part = position - double(lower);
  Rgb color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = std::uint8_t(
        std::lround(kScale[lower][c] + part * (kScale[lower + 1][c] - kScale[lower][c])));
  return color;
}

Rgb difference_color(const glm::dvec3& ours, const glm::dvec3& theirs, double allowed) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(ours[c]) || !std::isfinite(theirs[c])) return kNotFinite;
    const double d = ours[c] - theirs[c];
    if (std::abs(d) > std::abs(largest)) largest = d;
  }
  if (std::abs(largest) > allowed) return largest > 0 ? kOver : kUnder;
  return scale_color(allowed > 0 ? largest / allowed : 0);
}

// The mean of the pixels of `picture` that fall into one pixel of a smaller one.
glm::dvec3 box_mean(const Picture& picture, double left, double top, double right, double bottom) {
  glm::dvec3 total(0);
  double weight = 0;
  for (int y = int(top); y < std::min(int(std::ceil(bottom)), picture.height); ++y)
    for (int x = int(left); x < std::min(int(std::ceil(right)), picture.width); ++x) {
      const double w = (std::min(right, x + 1.0) - std::max(left, double(x))) *
                       (std::min(bottom, y + 1.0) - std::max(top, double(y)));
      total += w * picture.at(x, y);
      weight += w;
    }
  return total / weight;
}

}  // namespace

std::string data_uri(std::string_view png) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:image/png;base64,";
  text.reserve(text.size() + (png.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < png.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < png.size() ? static_cast<unsigned char>(png[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j > png.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
  }
  return text;
}

std::string picture_uri(const Picture& picture) { return data_uri(encode_png(picture)); }

std::string thumbnail_uri(const Picture& picture, int side) {
  const double factor = std::max(1.0, double(std::max(picture.width, picture.height)) / side);
  Picture small(std::max(1, int(std::lround(picture.width / factor))),
                std::max(1, int(std::lround(picture.height / factor))));
  const double across = double(picture.width) / small.width;
  const double down = double(picture.height) / small.height;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      small.at(x, y) = box_mean(picture, x * across, y * down, (x + 1) * across, (y + 1) * down);
  return picture_uri(small);
}

std::string difference_uri(const Picture& ours, const Picture& theirs,
                           std::span<const std::uint8_t> edge, double interior, double border) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(ours.pixels.size() * 3);
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    const bool on_edge = i < edge.size() && edge[i] != 0;
    const Rgb color =
        difference_color(ours.pixels[i], theirs.pixels[i], on_edge ? border : interior);
    rgb.insert(rgb.end(), color.begin(), color.end());
  }
  return data_uri(encode_png(ours.width, ours.height, rgb));
}

std::string difference_gradient() {
  std::vector<std::string> stops;
  for (const Rgb& color : kScale) stops.push_back(css(color));
  return fmt::format("linear-gradient(to right, {})", fmt::join(stops, ", "));
}

std::string over_color(bool brighter) { return css(brighter ? kOver : kUnder); }

}  // namespace litmus

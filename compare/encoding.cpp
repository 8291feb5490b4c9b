// encoding.cpp: the rounding of codes, carried through the transfer function.
#include "compare/encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/refusal.h"

namespace litmus {
namespace {

double codes(const Encoding& encoding) { return encoding.bits == 8 ? 255 : 65535; }

/// Code number, not rounded, to linear light; and back.
double light_of(double code, const Encoding& encoding) {
  const double value = code / codes(encoding);
  return (encoding.srgb ? srgb_decoded(value) : value) / encoding.exposure;
}
double code_of(double light, const Encoding& encoding) {
  const double value = std::clamp(light * encoding.exposure, 0.0, 1.0);
  return (encoding.srgb ? srgb_encoded(value) : value) * codes(encoding);
}

/// The weakest highlight (ks, under light 1) in which an exponent of 66 is sure to be told from 64:
/// at some h.n the two lie more than a whole step apart. 0 where that is a highlight of less than
/// 0.001, none where even ks = 1 is too weak.
std::optional<double> weakest_telling_highlight(const Encoding& encoding) {
  const auto told = [&](double ks) {
    constexpr int kSteps = 1000;
    for (int i = kSteps / 2; i < kSteps; ++i) {
      const double a = ks * std::pow(double(i) / kSteps, 64),
                   b = ks * std::pow(double(i) / kSteps, 66);
      if (a - b > half_step(a, encoding) + half_step(b, encoding)) return true;
    }
    return false;
  };
  for (double ks = 1e-3; ks <= 1; ks *= 1.02)
    if (told(ks)) return ks <= 1e-3 ? 0 : ks;
  return std::nullopt;
}

}  // namespace

std::string_view name_of(const Encoding& encoding) {
  for (const auto& [name, known] : kEncodings)
    if (known.bits == encoding.bits && known.srgb == encoding.srgb) return name;
  throw Refusal("an encoding that has no name");
}

double srgb_decoded(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

double srgb_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Picture to_light(const Picture& read, const Encoding& encoding) {
  Picture light = read;
  for (glm::dvec3& pixel : light.pixels)
    for (int c = 0; c < 3; ++c)
      pixel[c] = (encoding.srgb ? srgb_decoded(pixel[c]) : pixel[c]) / encoding.exposure;
  return light;
}

std::optional<std::array<int, 2>> finer_than(const Picture& read, const Encoding& encoding) {
  if (encoding.bits == 0) return std::nullopt;
  for (int y = 0; y < read.height; ++y)
    for (int x = 0; x < read.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const double code = read.at(x, y)[c] * codes(encoding);
        // A step of 16 bits is 0.004 of one of 8 bits.
        if (std::abs(code - std::round(code)) > 1e-3) return std::array{x, y};
      }
  return std::nullopt;
}

Cell cell_of(double light, const Encoding& encoding) {
  if (encoding.bits == 0) return {light, light};
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  const double code = std::round(code_of(light, encoding));
  return {code <= 0 ? -kEndless : light_of(code - 0.5, encoding),
          code >= codes(encoding) ? kEndless : light_of(code + 0.5, encoding)};
}

double half_step(double light, const Encoding& encoding) {
  if (encoding.bits == 0) return 0;
  const double code = std::round(code_of(light, encoding));
  const double middle = light_of(code, encoding);
  const double above = code < codes(encoding) ? light_of(code + 0.5, encoding) - middle : 0;
  const double below = code > 0 ? middle - light_of(code - 0.5, encoding) : 0;
  return std::max(above, below);
}

Picture nearest_that_rounds_to(const Picture& ours, const std::vector<const Picture*>& layers,
                               const Encoding& encoding) {
  Picture nearest(ours.width, ours.height);
  for (std::size_t i = 0; i < ours.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      Cell sum;
      for (const Picture* layer : layers) {
        const Cell cell = cell_of(layer->pixels[i][c], encoding);
        sum.low += cell.low, sum.high += cell.high;
      }
      // What is not a number stays so on both sides.
      const double wanted = ours.pixels[i][c];
      const bool inside = wanted >= sum.low && wanted <= sum.high;
      nearest.pixels[i][c] = inside ? wanted : wanted > sum.high ? sum.high : sum.low;
    }
  return nearest;
}

long clipped_pixels(const Picture& light, const Encoding& encoding) {
  if (encoding.bits == 0) return 0;
  return std::count_if(light.pixels.begin(), light.pixels.end(), [&](const glm::dvec3& p) {
    return std::round(code_of(std::max({p.x, p.y, p.z}), encoding)) >= codes(encoding);
  });
}

std::string blindness(const Encoding& encoding) {
  if (encoding.bits == 0) return "";
  const double white = 1 / encoding.exposure;
  const double grey = std::min(0.214, white / 2);  // half way in sRGB codes
  const double black_step = half_step(0, encoding), grey_step = half_step(grey, encoding),
               white_step = half_step(white, encoding);
  const std::optional<double> telling = weakest_telling_highlight(encoding);
  const std::string exponent =
      !telling ? ", a specular exponent of 66 in place of 64"
      : *telling == 0
          ? ""
          : fmt::format(", a specular exponent of 66 in place of 64 where ks is below {:.2g}",
                        *telling);
  return fmt::format(
      "{} rounds by up to {:.2g} near black, {:.2g} in mid-grey ({:.3g}) and {:.2g} at {:.3g}, "
      "above which it clips. Each value therefore stands for an interval, and what lies within it "
      "passes; only an error of more than a whole step, twice that, is sure to be found. May pass, "
      "for example: a light that is {:.2g} % too strong, ambient light of {:.2g} where there is "
      "none{}.",
      name_of(encoding), black_step, grey_step, grey, white_step, white, 200 * white_step / white,
      black_step, exponent);
}

}  // namespace litmus

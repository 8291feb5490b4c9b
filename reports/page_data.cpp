// page_data.cpp: the pictures of a scene as numbers, packed so that the page can unpack them.
#include "reports/page_data.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "compare/difference.h"
#include "reports/overview.h"
#include "reports/plain_text.h"

namespace litmus {
namespace {
using nlohmann::ordered_json;

constexpr int kTopExponent = 15;  // half floats end just below 2^16
// Differences are kept to this part of the tolerance where a row of the scene fails, else to that.
constexpr double kStepsOfFailures = 256, kStepsOfPasses = 32;

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

int exponent_for(const Picture& picture) {
  double largest = 0;
  for (const glm::dvec3& pixel : picture.pixels)
    for (int c = 0; c < 3; ++c)
      if (std::isfinite(pixel[c])) largest = std::max(largest, std::abs(pixel[c]));
  return largest > 0 ? kTopExponent - std::ilogb(largest) - 1 : 0;
}

ordered_json packed_json(const PackedPicture& picture) {
  return {{"exponent", picture.exponent}, {"delta", picture.delta}, {"data", picture.data}};
}

const Comparison* row_of(const std::vector<Comparison>& rows, const Case& one,
                         const CaseLayer& layer, const std::string& reference, Region region) {
  for (const Comparison& row : rows)
    if (row.scene == one.scene && row.light == layer.light && row.reference == reference &&
        row.region == name_of(region) && row.against == "litmus")
      return &row;
  return nullptr;
}

ordered_json theirs_json(const Study& study, const Case& one, const CaseLayer& layer,
                         const CaseLayer::Theirs& theirs, bool judged) {
  const std::vector<Comparison>& rows = judged ? study.comparisons : study.informative;
  ordered_json result{{"reference", clean_text(theirs.reference)},
                      {"title", clean_text(reference_title(theirs.reference))},
                      {"source", theirs.source},
                      {"judged", judged}};
  double inside = 0;
  for (const Region region : {Region::Interior, Region::Edge}) {
    const Comparison* row = row_of(rows, one, layer, theirs.reference, region);
    const double allowed = row != nullptr ? row->tolerance : 0;
    result["allowed"].push_back(allowed);
    if (region == Region::Interior) inside = allowed;
  }
  const bool fails =
      tally(study, [&](const Comparison& row) { return row.scene == one.scene; }).failed > 0;
  const double steps = fails ? kStepsOfFailures : kStepsOfPasses;
  const double step = inside > 0 ? std::exp2(std::floor(std::log2(inside / steps))) : 0;
  result["step"] = step;
  result["difference"] = packed_json(packed(packed_difference(layer.ours, theirs.picture), step));
  return result;
}

ordered_json layer_json(const Study& study, const Case& one, const CaseLayer& layer) {
  const std::string edge(layer.edge.begin(), layer.edge.end());
  const std::string flags(layer.flags.begin(), layer.flags.end());
  ordered_json result{{"light", clean_text(layer.light)},
                      {"type", layer.light_type},
                      {"ours", packed_json(packed(layer.ours))},
                      {"edge", deflated(edge)},
                      {"flags", deflated(flags)},
                      {"theirs", ordered_json::array()}};
  for (const CaseLayer::Theirs& theirs : layer.theirs)
    if (same_size(layer.ours, theirs.picture))
      result["theirs"].push_back(theirs_json(study, one, layer, theirs, true));
  for (const CaseLayer::Theirs& theirs : layer.aside)
    if (same_size(layer.ours, theirs.picture))
      result["theirs"].push_back(theirs_json(study, one, layer, theirs, false));
  return result;
}

// A picture that the scene has shown before is named by its place instead: the whole of one light
// is that light.
void name_repeated(ordered_json& layers) {
  std::map<std::string, std::string> seen;
  const auto once = [&](ordered_json& picture, const std::string& place) {
    const auto [known, fresh] = seen.emplace(picture.dump(), place);
    if (!fresh) picture = ordered_json{{"same", known->second}};
  };
  for (std::size_t k = 0; k < layers.size(); ++k) {
    once(layers[k]["ours"], fmt::format("{}", k));
    ordered_json& theirs = layers[k]["theirs"];
    for (std::size_t r = 0; r < theirs.size(); ++r)
      once(theirs[r]["difference"], fmt::format("{},{}", k, r));
  }
}

}  // namespace

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

PackedPicture packed(const Picture& picture, double step) {
  PackedPicture result;
  result.exponent = exponent_for(picture);
  const std::size_t count = picture.pixels.size();
  std::vector<std::uint16_t> words(count * 3);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t before = 0;
    for (int c = 0; c < 3; ++c) {
      double value = picture.pixels[i][c];
      if (step > 0 && std::isfinite(value)) value = std::nearbyint(value / step) * step + 0.0;
      const std::uint16_t bits = half_bits(std::ldexp(value, result.exponent));
      words[std::size_t(c) * count + i] = std::uint16_t(bits - before);
      before = bits;
    }
  }
  const std::string plain = shuffled(words);
  for (std::size_t i = words.size(); i-- > 1;) words[i] = std::uint16_t(words[i] - words[i - 1]);
  const std::string deltas = shuffled(words);
  // A quick look tells which of the two packs better.
  result.delta = deflated_bytes(deltas, 1).size() < deflated_bytes(plain, 1).size();
  result.data = base64(deflated_bytes(result.delta ? deltas : plain));
  return result;
}

Picture packed_difference(const Picture& ours, const Picture& theirs) {
  Picture result(ours.width, ours.height);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double own = ours.pixels[i][c];
      result.pixels[i][c] = (std::isfinite(own) ? own : 0) - theirs.pixels[i][c];
    }
  return result;
}

std::string shell_word(const std::string& text) {
  const std::string word = clean_text(text);
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string_view("/._-").find(c) != std::string_view::npos;
  });
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string scene_word(const Case& one) {
  const std::filesystem::path file(one.file);
  const bool canonical = file.parent_path().filename() == "canonical" && file.stem() == one.scene;
  return shell_word(canonical || one.file.empty() ? one.scene : one.file);
}

std::string pictures_json(const Study& study, const Case& one) {
  ordered_json result{{"scene", clean_text(one.scene)},
                      {"word", scene_word(one)},
                      {"width", one.width},
                      {"height", one.height},
                      {"layers", ordered_json::array()}};
  for (const CaseLayer& layer : one.layers)
    result["layers"].push_back(layer_json(study, one, layer));
  name_repeated(result["layers"]);
  return result.dump();
}

}  // namespace litmus

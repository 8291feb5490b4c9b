// regions.cpp: the edge mask, and the regions of a light.
#include "compare/regions.h"

#include <algorithm>

namespace litmus {
namespace {

bool differs_nearby(const Signature& signature, int x, int y) {
  const auto value = [&](int column, int row) {
    return signature.values[std::size_t(row) * std::size_t(signature.width) + std::size_t(column)];
  };
  const std::uint64_t own = value(x, y);
  for (int row = std::max(0, y - 1); row <= std::min(signature.height - 1, y + 1); ++row)
    for (int column = std::max(0, x - 1); column <= std::min(signature.width - 1, x + 1); ++column)
      if (value(column, row) != own) return true;
  return false;
}

bool belongs(std::uint8_t flags, Region region) {
  const int shadow = flags & (kLit | kPenumbra | kUmbra);
  switch (region) {
    case Region::Lit:
      return shadow == kLit;
    case Region::Umbra:
      return shadow == kUmbra;
    case Region::Penumbra:
      return shadow != 0 && shadow != kLit && shadow != kUmbra;
    case Region::Highlight:
      return (flags & kHighlight) != 0;
    default:
      return false;
  }
}

}  // namespace

std::vector<std::uint8_t> edge_mask(const Signature& signature) {
  std::vector<std::uint8_t> mask;
  mask.reserve(signature.values.size());
  for (int y = 0; y < signature.height; ++y)
    for (int x = 0; x < signature.width; ++x) mask.push_back(differs_nearby(signature, x, y));
  return mask;
}

std::vector<std::uint8_t> region_mask(std::span<const std::uint8_t> flags,
                                      std::span<const std::uint8_t> edge, Region region) {
  std::vector<std::uint8_t> mask;
  mask.reserve(flags.size());
  for (std::size_t i = 0; i < flags.size(); ++i)
    mask.push_back(edge[i] == 0 && belongs(flags[i], region));
  return mask;
}

}  // namespace litmus

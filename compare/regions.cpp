// regions.cpp: the edge mask.
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

}  // namespace

std::vector<std::uint8_t> edge_mask(const Signature& signature) {
  std::vector<std::uint8_t> mask;
  mask.reserve(signature.values.size());
  for (int y = 0; y < signature.height; ++y)
    for (int x = 0; x < signature.width; ++x) mask.push_back(differs_nearby(signature, x, y));
  return mask;
}

}  // namespace litmus

// hash.cpp: XXH3-128 over texts and files.
#include "reference/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <fstream>
#include <memory>
#include <vector>

#include "scene/refusal.h"

namespace litmus {
namespace {

std::string hexadecimal(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string hash_text(std::string_view text) {
  return hexadecimal(XXH3_128bits(text.data(), text.size()));
}

std::string hash_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Refusal(file.string() + ": cannot be read");
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                       XXH3_freeState);
  XXH3_128bits_reset(state.get());
  std::vector<char> block(std::size_t{1} << 18);
  while (in.read(block.data(), std::streamsize(block.size())), in.gcount() > 0)
    XXH3_128bits_update(state.get(), block.data(), std::size_t(in.gcount()));
  if (in.bad()) throw Refusal(file.string() + ": cannot be read to its end");
  return hexadecimal(XXH3_128bits_digest(state.get()));
}

}  // namespace litmus

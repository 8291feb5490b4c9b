// hash.h: names and checksums of contents, XXH3-128 (fast, not against an adversary).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace litmus {

/// 32 hexadecimal digits.
std::string hash_text(std::string_view text);

/// The same for a file's bytes. Throws Refusal naming the file if it cannot be read.
std::string hash_file(const std::filesystem::path& file);

}  // namespace litmus

// whole_file.h: files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace litmus {

/// Calls `write` with a temporary name in the file's own folder (same extension), flushes what it
/// wrote to the disk and renames it to `file`. If `write` throws, the temporary is removed and an
/// existing `file` stays as it was. Throws Refusal naming the file if it cannot be written.
void write_whole(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for text that is ready.
void write_whole(const std::filesystem::path& file, std::string_view text);

}  // namespace litmus

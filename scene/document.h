// document.h: a scene file as a tree of values that know where they stand. Its .cpp is the only
// user of toml++ (6 s a translation unit).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace litmus {

inline constexpr std::uintmax_t kLargestFile = 16u << 20;  ///< bytes, of a scene or an OBJ file

/// A place in a file, both counted from 1.
struct Position {
  std::uint32_t line = 1, column = 1;
};

struct Entry;

/// One TOML value: a date or time is monostate (no key of a scene takes one).
struct Node {
  using Array = std::vector<Node>;
  using Table = std::vector<Entry>;  ///< in the file's order
  Position at;
  std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Table> value;
};

struct Entry {
  std::string key;
  Position at;  ///< of the key
  Node node;
};

/// Reads a TOML file; the root is a table. Throws Refusal if it cannot be read, is larger than
/// kLargestFile, or is not TOML.
Node read_document(const std::filesystem::path& file);

/// A whole file as bytes. Throws std::runtime_error with a reason that fits after "file.obj: " if
/// it is missing, not a regular file, unreadable or larger than kLargestFile.
std::string read_limited(const std::filesystem::path& file);

/// "file:line:column: field: message", as every refusal reads.
[[noreturn]] void refuse(const std::filesystem::path& file, Position at, const std::string& field,
                         const std::string& message);

/// A value as its author might have written it, shortened: 0.5, "text", [1, 2, 3], a table.
std::string shown(const Node& node);

}  // namespace litmus

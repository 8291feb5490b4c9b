// fields.h: strict reading of one table of a scene file: every key is known, every value checked.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/document.h"
#include "scene/scene.h"

namespace litmus {

/// What a number may be. The text completes "must be ..., not <value>".
struct Range {
  double low = -std::numeric_limits<double>::max();
  bool low_allowed = true;
  std::string_view text = "a finite number";
  double high = std::numeric_limits<double>::max();
  bool high_allowed = true;

  bool holds(double value) const;  ///< false for NaN
};

inline constexpr Range kAnyNumber{};
inline constexpr Range kNotNegative{0, true, "a finite number >= 0"};
inline constexpr Range kPositive{0, false, "a finite number > 0"};

/// The longest component of a direction lies in this interval, so that its square is representable.
inline constexpr double kShortestVector = 1e-100, kLongestVector = 1e100;

/// A table of the file. Reading a key that is absent, of another type or out of range throws
/// Refusal at that value's place, or at the table's place if the key is absent.
class Fields {
 public:
  /// `what` is how messages call the table: "a sphere", "[camera]". Throws if the node is no table.
  Fields(const std::filesystem::path& file, const Node& node, std::string what);

  /// Refuses any key that is not listed, naming the nearest and the whole list.
  void only(std::initializer_list<std::string_view> keys) const;

  const Node* find(std::string_view key) const;  ///< nullptr if absent
  bool has(std::string_view key) const { return find(key) != nullptr; }
  Position place() const;                      ///< of the table
  Position place(std::string_view key) const;  ///< of the value, or of the table if absent
  const std::filesystem::path& file() const { return *file_; }

  double number(std::string_view key, const Range& range) const;
  double number(std::string_view key, const Range& range, double fallback) const;
  int integer(std::string_view key, int low, int high) const;
  int integer(std::string_view key, int low, int high, int fallback) const;
  bool boolean(std::string_view key, bool fallback) const;
  std::string text(std::string_view key) const;  ///< neither empty nor with control characters
  std::string text(std::string_view key, std::string fallback) const;
  std::vector<std::string> texts(std::string_view key) const;  ///< empty if absent

  Point point(std::string_view key) const;
  Point point(std::string_view key, Point fallback) const;
  /// Three numbers of a length that can be normalised.
  Vector direction(std::string_view key) const;
  Vector direction(std::string_view key, Vector fallback) const;
  /// A number >= 0, for grey, or [r, g, b], each >= 0. A spectrum's name is left to read_spectra:
  /// it gives the fallback.
  Color color(std::string_view key, Color fallback) const;

  /// The value that belongs to the word, such as {"centres", Placement::Centres}.
  template <class T>
  T choice(std::string_view key, std::initializer_list<std::pair<std::string_view, T>> words) const;

  /// The tables of `[[key]]`; empty if absent.
  const Node::Array& tables(std::string_view key) const;

  [[noreturn]] void refuse(std::string_view key, const std::string& message) const;
  [[noreturn]] void refuse_missing(std::string_view key, std::string_view allowed) const;
  /// "must be <allowed>, not <value>"
  [[noreturn]] void refuse_value(std::string_view key, const Node& value,
                                 std::string_view allowed) const;
  /// "must be "a", "b" or "c", not "word"; did you mean ...?"
  [[noreturn]] void refuse_word(std::string_view key, const std::string& word,
                                const std::vector<std::string>& words) const;

 private:
  const Node& required(std::string_view key, std::string_view allowed) const;
  double checked(std::string_view key, const Node& value, const Range& range) const;

  const std::filesystem::path* file_;
  const Node* node_;
  const Node::Table* table_;
  std::string what_;
};

template <class T>
T Fields::choice(std::string_view key,
                 std::initializer_list<std::pair<std::string_view, T>> words) const {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) names.emplace_back('"' + std::string(name) + '"');
  std::string allowed = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) allowed += " or " + names[i];
  const Node& node = required(key, allowed);
  const auto* word = std::get_if<std::string>(&node.value);
  if (!word) refuse_value(key, node, allowed);
  for (const auto& [name, value] : words)
    if (*word == name) return value;
  names.clear();
  for (const auto& [name, value] : words) names.emplace_back(name);
  refuse_word(key, *word, names);
}

/// True if the longest component is within kShortestVector..kLongestVector.
bool normalizable(const Vector& vector);

/// True if the two directions are parallel or opposite to 1e-9, where a frame made from them would
/// keep less than half of its digits.
bool nearly_parallel(const Vector& a, const Vector& b);

}  // namespace litmus

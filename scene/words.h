// words.h: words and numbers in messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace litmus {

/// Shortest text that reads back as the same double, whatever the locale: 0.1, 1e-25, inf, nan.
std::string number_text(double value);

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other,
/// whatever their case (restricted Damerau-Levenshtein distance).
int edit_distance(std::string_view a, std::string_view b);

/// The candidates that a typing error may have meant, nearest first: at most a third of the longer
/// word's letters differ, rounded (one at least).
std::vector<std::string> near_words(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "x"?`, or nothing if no candidate is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

/// a, b and c; "none" for an empty list.
std::string listed(std::span<const std::string> words, std::string_view last = "and");

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

}  // namespace litmus

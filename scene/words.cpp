// words.cpp: words and numbers in messages.
#include "scene/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace litmus {

std::string number_text(double value) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return lower;
}

int edit_distance(std::string_view first, std::string_view second) {
  const std::string a = lower_case(first), b = lower_case(second);
  const std::size_t columns = b.size() + 1;
  std::vector<int> d((a.size() + 1) * columns);
  for (std::size_t j = 0; j < columns; ++j) d[j] = int(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int* row = &d[i * columns];
    const int* above = row - columns;
    row[0] = int(i);
    for (std::size_t j = 1; j < columns; ++j) {
      const int replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], d[(i - 2) * columns + j - 2] + 1);
    }
  }
  return d.back();
}

std::vector<std::string> near_words(std::string_view word,
                                    std::span<const std::string> candidates) {
  std::vector<std::pair<int, std::string>> ranked;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(word, candidate);
    const int longest = int(std::max(word.size(), candidate.size()));
    if (distance <= std::max(1, (longest + 1) / 3) && distance < longest)
      ranked.emplace_back(distance, candidate);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> words;
  for (auto& [distance, candidate] : ranked) words.push_back(std::move(candidate));
  return words;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  const std::vector<std::string> near = near_words(word, candidates);
  return near.empty() ? "" : "; did you mean \"" + near.front() + "\"?";
}

std::string listed(std::span<const std::string> words, std::string_view last) {
  if (words.empty()) return "none";
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i)
    text += i + 1 == words.size() ? fmt::format(" {} {}", last, words[i]) : ", " + words[i];
  return text;
}

}  // namespace litmus

// text.cpp: numbers, strings, comments and names as text for other programs.
#include "exporters/text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace litmus {
namespace {

constexpr char32_t kReplacement = 0xfffd;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Takes one code point off the front of UTF-8 text; an invalid byte counts as one replacement.
char32_t take_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return std::uint8_t(text[i]); };
  const auto take = [&](std::size_t count, char32_t value) {
    text.remove_prefix(count);
    return value;
  };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return take(1, lead);
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return take(1, kReplacement);
  char32_t value = lead & (0x7f >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return take(1, kReplacement);
    value = value << 6 | (byte(i) & 0x3f);
  }
  const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  const bool surrogate = value >= 0xd800 && value <= 0xdfff;
  if (overlong || surrogate || value > 0x10ffff) return take(1, kReplacement);
  return take(length, value);
}

void append_utf8(std::string& out, char32_t c) {
  if (c < 0x80) {
    out += char(c);
    return;
  }
  const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  out += char((0xff00 >> (more + 1) & 0xff) | c >> (6 * more));
  for (int i = more - 1; i >= 0; --i) out += char(0x80 | (c >> (6 * i) & 0x3f));
}

// Controls, line and paragraph separators, and the marks that reorder the text that a person sees.
bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x2028 || c == 0x2029 || c == 0xfeff ||
         (c >= 0x200b && c <= 0x200f) || (c >= 0x202a && c <= 0x202e) ||
         (c >= 0x2066 && c <= 0x2069);
}

}  // namespace

std::string number(double value) {
  assert(std::isfinite(value));
  if (value == 0) return "0";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return std::string(text, end);
}

std::string povray_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c < 0x20 || c > 0x7e ? '?' : c;
  }
  return out + '"';
}

std::string python_string(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const char32_t c = take_code_point(text);
    if (c == '"' || c == '\\')
      out += '\\', out += char(c);
    else if (c == '\n')
      out += "\\n";
    else if (c >= 0x20 && c < 0x7f)
      out += char(c);
    else if (c < 0x100)
      out += fmt::format("\\x{:02x}", std::uint32_t(c));
    else if (c < 0x10000)
      out += fmt::format("\\u{:04x}", std::uint32_t(c));
    else
      out += fmt::format("\\U{:08x}", std::uint32_t(c));
  }
  return out + '"';
}

std::string comment(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const char32_t c = take_code_point(text);
    append_utf8(out, is_control(c) ? U' ' : c);
  }
  // A backslash at the end of a line may join it with the next one.
  while (!out.empty() && (out.back() == ' ' || out.back() == '\\')) out.pop_back();
  return out;
}

std::string comment_block(std::string_view text, std::string_view prefix, std::size_t width) {
  const std::string clean = comment(text);
  std::string out, line;
  const auto flush = [&] {
    out += fmt::format("{}{}\n", prefix, comment(line));
    line.clear();
  };
  for (std::size_t at = 0; at < clean.size();) {
    const std::size_t end = std::min(clean.find(' ', at), clean.size());
    const std::string_view word = std::string_view(clean).substr(at, end - at);
    if (!line.empty() && line.size() + 1 + word.size() > width) flush();
    if (!word.empty()) line += line.empty() ? std::string(word) : fmt::format(" {}", word);
    at = end + 1;
  }
  if (!line.empty()) flush();
  return out;
}

std::string identifier(std::string_view prefix, std::string_view name,
                       std::set<std::string>& taken) {
  assert(!prefix.empty() && prefix[0] >= 'A' && prefix[0] <= 'Z');
  constexpr std::size_t kLongest = 48;  // names stay readable; POV-Ray allows 128 characters
  std::string word;
  bool capital = true;
  for (const char c : name) {
    if (word.size() == kLongest) break;
    if (!is_letter(c) && !is_digit(c)) {
      capital = true;
      continue;
    }
    const bool lower = c >= 'a' && c <= 'z';
    word += capital && lower ? char(c - 'a' + 'A') : c;
    capital = false;
  }
  const std::string base = word.empty() ? std::string(prefix) : fmt::format("{}_{}", prefix, word);
  std::string result = base;
  for (int i = 2; !taken.insert(result).second; ++i) result = fmt::format("{}_{}", base, i);
  return result;
}

}  // namespace litmus

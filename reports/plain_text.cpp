// plain_text.cpp: text and numbers as the writers print them.
#include "reports/plain_text.h"

#include <fmt/format.h>

#include <cmath>

namespace litmus {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// Length of the well-formed UTF-8 sequence at the start of the text, or 0 (Unicode 15, table 3-7).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const auto continues = [&](std::size_t i) { return byte(i) >= 0x80 && byte(i) <= 0xBF; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool ok = second >= (first == 0xE0 ? 0xA0u : 0x80u) &&
                    second <= (first == 0xED ? 0x9Fu : 0xBFu) && continues(2);
    return ok ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool ok = second >= (first == 0xF0 ? 0x90u : 0x80u) &&
                    second <= (first == 0xF4 ? 0x8Fu : 0xBFu) && continues(2) && continues(3);
    return ok ? 4 : 0;
  }
  return 0;
}

// Length of a terminal's escape sequence (ESC [ ... letter) at the start of the text.
std::size_t escape_length(std::string_view text) {
  if (text.size() < 2 || text[1] != '[') return 1;
  std::size_t i = 2;
  while (i < text.size() && text[i] >= 0x20 && text[i] <= 0x3F) ++i;
  return std::min(i + 1, text.size());
}

}  // namespace

std::string clean_text(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  while (!text.empty()) {
    std::size_t length = sequence_length(text);
    const char first = text.front();
    if (length == 0) {
      clean += kReplacement;
      length = 1;
    } else if (first == '\x1B') {
      length = escape_length(text);
    } else if (first == '\n' || first == '\t' || (first != '\x7F' && (first < 0 || first >= ' '))) {
      clean += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return clean;
}

std::string clipped(std::string_view text, std::size_t limit) {
  std::string clean = clean_text(text);
  if (clean.size() <= limit) return clean;
  std::size_t end = limit;
  while (end > 0 && (static_cast<unsigned char>(clean[end]) & 0xC0) == 0x80) --end;
  return clean.substr(0, end) + " ...";
}

std::string nearby(const std::filesystem::path& file) {
  if (file.empty()) return "";
  const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
  const std::filesystem::path below = whole.lexically_relative(std::filesystem::current_path());
  return (below.empty() || *below.begin() == ".." ? whole : below).string();
}

std::string short_number(double value) {
  if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : "not finite";
  const double magnitude = std::abs(value);
  if (magnitude >= 9.995 && magnitude < 9999.5) return fmt::format("{:.0f}", value);
  std::string text = magnitude >= 0.00995 && magnitude < 9999.5 ? fmt::format("{:.2g}", value)
                                                                : fmt::format("{:.1e}", value);
  // 1.0e-07 reads better as 1e-7.
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::string mantissa = text.substr(0, e), exponent = text.substr(e + 1);
  if (mantissa.ends_with(".0")) mantissa.resize(mantissa.size() - 2);
  while (exponent.size() > 2 && exponent[1] == '0') exponent.erase(1, 1);
  return mantissa + "e" + exponent;
}

std::string short_seconds(double seconds) {
  if (seconds >= 99.5)
    return fmt::format("{} min {} s", std::lround(seconds) / 60, std::lround(seconds) % 60);
  if (seconds >= 0.01 || seconds == 0) return short_number(seconds) + " s";
  return short_number(seconds * 1000) + " ms";
}

std::string with_commas(long long count) {
  std::string digits = std::to_string(count);
  for (std::ptrdiff_t at = std::ptrdiff_t(digits.size()) - 3; at > (count < 0 ? 1 : 0); at -= 3)
    digits.insert(std::size_t(at), ",");
  return digits;
}

std::string counted(long long count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", with_commas(count), count == 1 ? one : many);
}

}  // namespace litmus

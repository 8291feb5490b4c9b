// spectrum_file.cpp: spectra measured and kept in text files.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "scene/document.h"
#include "scene/spectrum.h"

namespace litmus {
namespace {

constexpr std::size_t kMostSamples = 10'000;  // of one spectrum

using Words = std::vector<std::string_view>;

Words words_of(std::string_view line, std::string_view separators) {
  Words words;
  for (std::size_t at = 0; (at = line.find_first_not_of(separators, at)) != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

/// A finite number and nothing else.
std::optional<double> number_of(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return {};
  return value;
}

[[noreturn]] void fail(std::size_t line, const std::string& message) {
  throw std::runtime_error(fmt::format("line {}: {}", line, message));
}

/// The lines of a text, numbered from 1, each as words; empty ones are left out.
struct Line {
  std::size_t number;
  Words words;
};

std::vector<Line> lines_of(std::string_view text, std::string_view separators) {
  std::vector<Line> lines;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, text.find_first_of("#\n"));
    text.remove_prefix(std::min(end + 1, text.size()));
    Words words = words_of(line, separators);
    ++number;
    if (!words.empty()) lines.push_back({number, std::move(words)});
  }
  return lines;
}

/// What a CGATS file says of its samples.
struct Header {
  double start = 0, end = 0, norm = 1;
  std::size_t bands = 0;
};

Header read_header(const std::vector<Line>& lines) {
  std::optional<double> start, end, bands, norm;
  for (const auto& [number, words] : lines) {
    if (words.size() < 2) continue;
    for (const auto& [key, value] : {std::pair{"SPECTRAL_START_NM", &start},
                                     {"SPECTRAL_END_NM", &end},
                                     {"SPECTRAL_BANDS", &bands},
                                     {"SPECTRAL_NORM", &norm}}) {
      if (words[0] != key) continue;
      std::string_view word = words[1];
      if (word.size() > 2 && word.front() == '"') word = word.substr(1, word.size() - 2);
      *value = number_of(word);
      if (!*value) fail(number, fmt::format("{} is no number", words[0]));
    }
  }
  if (!start || !end || !bands)
    throw std::runtime_error(
        "has no SPECTRAL_START_NM, SPECTRAL_END_NM or SPECTRAL_BANDS, as a CGATS file must");
  if (!(*start > 0 && *end > *start && *bands >= 2 && *bands <= double(kMostSamples)))
    throw std::runtime_error(fmt::format(
        "has {} bands from {} to {} nm; there must be 2..{}, and the wavelengths must rise", *bands,
        *start, *end, kMostSamples));
  if (norm && !(*norm > 0)) throw std::runtime_error("has a SPECTRAL_NORM that is not > 0");
  return {*start, *end, norm.value_or(1), std::size_t(*bands)};
}

std::vector<NamedSpectrum> read_cgats(const std::vector<Line>& lines) {
  const Header header = read_header(lines);
  std::vector<NamedSpectrum> spectra;
  bool inside = false;
  for (const auto& [number, words] : lines) {
    if (words[0] == "BEGIN_DATA") {
      inside = true;
      continue;
    }
    if (words[0] == "END_DATA") inside = false;
    if (!inside) continue;
    if (words.size() != header.bands && words.size() != header.bands + 1)
      fail(number,
           fmt::format("{} values where SPECTRAL_BANDS says {}", words.size(), header.bands));
    const std::size_t named = words.size() - header.bands;
    NamedSpectrum one;
    if (named) one.name = words[0];
    for (std::size_t i = 0; i < header.bands; ++i) {
      const auto value = number_of(words[named + i]);
      if (!value) fail(number, fmt::format("\"{}\" is no number", words[named + i]));
      one.spectrum.nm.push_back(header.start +
                                (header.end - header.start) * double(i) / double(header.bands - 1));
      one.spectrum.values.push_back(*value / header.norm);
    }
    spectra.push_back(std::move(one));
  }
  if (spectra.empty()) throw std::runtime_error("has no line between BEGIN_DATA and END_DATA");
  return spectra;
}

std::vector<NamedSpectrum> read_columns(const std::vector<Line>& lines) {
  Spectrum spectrum;
  for (const auto& [number, words] : lines) {
    const auto nm = number_of(words[0]);
    const auto value = words.size() == 2 ? number_of(words[1]) : std::nullopt;
    if (!nm || !value) fail(number, "must be a wavelength in nm and a value");
    if (!(*nm > (spectrum.nm.empty() ? 0 : spectrum.nm.back())))
      fail(number, "wavelengths must be > 0 and rise from line to line");
    if (spectrum.nm.size() == kMostSamples)
      fail(number, fmt::format("more than {} samples", kMostSamples));
    spectrum.nm.push_back(*nm), spectrum.values.push_back(*value);
  }
  if (spectrum.nm.empty()) throw std::runtime_error("has no samples");
  return {{"", std::move(spectrum)}};
}

}  // namespace

std::vector<NamedSpectrum> read_spectra_file(const std::filesystem::path& file) {
  const std::string text = read_limited(file);
  const bool cgats = text.find("BEGIN_DATA") != std::string::npos;
  return cgats ? read_cgats(lines_of(text, " \t\r")) : read_columns(lines_of(text, " \t\r,;"));
}

}  // namespace litmus

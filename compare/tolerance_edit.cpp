// tolerance_edit.cpp: new figures for tolerances.toml, line by line.
#include "compare/tolerance_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "scene/refusal.h"

namespace litmus {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Not below the value, with so many digits.
double rounded_up(double value, int digits) {
  if (!(value > 0)) return 0;
  const double rounded = std::stod(fmt::format("{:.{}e}", value, digits - 1));
  if (rounded >= value) return rounded;
  const double step = std::pow(10, std::floor(std::log10(value)) - (digits - 1));
  return std::stod(fmt::format("{:.{}e}", rounded + step, digits - 1));
}

std::string quoted(const std::string& text) {
  std::string safe = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') safe += '\\';
    safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return safe + "\"";
}

/// Replaces `key = ...` in the table that starts at lines[start].
void set_line(std::vector<std::string>& lines, std::size_t start, std::string_view key,
              const std::string& value) {
  for (std::size_t i = start + 1; i < lines.size() && lines[i].rfind("[", 0) != 0; ++i) {
    if (lines[i].rfind(fmt::format("{} =", key), 0) != 0) continue;
    lines[i] = fmt::format("{} = {}", key, value);
    return;
  }
  throw Refusal(fmt::format("tolerances.toml:{}: has no line \"{} = ...\" of its own to change",
                            start + 1, key));
}

}  // namespace

ToleranceChange raised(const NamedTolerance& row, double max_abs, double mean_abs,
                       std::string reason) {
  ToleranceChange change;
  change.reference = row.reference, change.region = row.region;
  change.reason = std::move(reason);
  change.seen_max = std::max(row.seen_max, rounded_up(max_abs, 3));
  change.seen_mean = std::max(row.seen_mean, rounded_up(mean_abs, 3));
  change.tolerance = row.tolerance;
  if (max_abs > row.tolerance.max_abs)
    change.tolerance.max_abs = rounded_up(kRaisedMargin * max_abs, 2);
  if (mean_abs > row.tolerance.mean_abs)
    change.tolerance.mean_abs = rounded_up(kRaisedMargin * mean_abs, 2);
  return change;
}

std::string edited_tolerances(std::string_view text, std::span<const NamedTolerance> rows,
                              std::span<const ToleranceChange> changes) {
  std::vector<std::string> lines = lines_of(text);
  for (const ToleranceChange& change : changes) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const NamedTolerance& one) {
      return one.reference == change.reference && one.region == change.region;
    });
    if (row == rows.end() || std::size_t(row->line) > lines.size())
      throw Refusal(fmt::format("tolerances.toml: has no tolerance of {}, {}", change.reference,
                                name_of(change.region)));
    const std::size_t start = std::size_t(row->line) - 1;
    set_line(lines, start, "max_abs", fmt::format("{}", change.tolerance.max_abs));
    set_line(lines, start, "mean_abs", fmt::format("{}", change.tolerance.mean_abs));
    set_line(lines, start, "seen_max", fmt::format("{}", change.seen_max));
    set_line(lines, start, "seen_mean", fmt::format("{}", change.seen_mean));
    set_line(lines, start, "reason", quoted(change.reason));
  }
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

std::string line_diff(std::string_view file, std::string_view before, std::string_view after) {
  const std::vector<std::string> old_lines = lines_of(before), new_lines = lines_of(after);
  std::string text;
  for (std::size_t i = 0; i < std::min(old_lines.size(), new_lines.size()); ++i)
    if (old_lines[i] != new_lines[i])
      text += fmt::format("@@ -{0} +{0} @@\n-{1}\n+{2}\n", i + 1, old_lines[i], new_lines[i]);
  return text.empty() ? "" : fmt::format("--- {0}\n+++ {0}\n{1}", file, text);
}

}  // namespace litmus

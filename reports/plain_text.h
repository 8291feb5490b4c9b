// plain_text.h: text and numbers as the writers print them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace litmus {

/// Valid UTF-8 without control characters, so that any text of a scene file or a renderer's log can
/// stand in JSON, XML and HTML: bad bytes become U+FFFD, escape sequences and controls but newline
/// and tab go.
std::string clean_text(std::string_view text);

/// At most `limit` bytes of clean text, cut at a character; " ..." shows the cut.
std::string clipped(std::string_view text, std::size_t limit);

/// The file as it is called from the working folder, where it lies below it; else its whole path.
/// So reports of one project do not depend on where it lies.
std::string nearby(const std::filesystem::path& file);

/// Two digits for people: 0, 0.25, 12, 1.2e-7, 3e+8. Plain notation from 0.01 to 9999.
std::string short_number(double value);

/// "0.25 s", "12 s", "3 min 20 s".
std::string short_seconds(double seconds);

/// "1,200".
std::string with_commas(long long count);

/// "1 pixel", "1,200 pixels".
std::string counted(long long count, std::string_view one, std::string_view many);

}  // namespace litmus

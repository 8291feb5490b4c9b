// text.h: numbers, strings, comments and names as text that POV-Ray and Python read back unharmed.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace litmus {

/// The shortest decimal text that reads back as the same double: "0.1", "1e-05", "-3". The decimal
/// separator is '.' in every locale. Negative zero is "0". `value` must be finite.
std::string number(double value);

/// A POV-Ray string literal with its quotes. POV-Ray strings are ASCII here: a byte outside
/// 0x20..0x7e becomes '?', quote and backslash are escaped.
std::string povray_string(std::string_view text);

/// A Python string literal with its quotes, in ASCII: everything else is \n, \xNN, \uNNNN or
/// \UNNNNNNNN. Bytes that are not UTF-8 become U+FFFD.
std::string python_string(std::string_view text);

/// Text for the rest of a comment line ("//" in POV-Ray, "#" in Python): one line, valid UTF-8, no
/// control characters, so that nothing after it can leave the comment. No comment sign is added.
std::string comment(std::string_view text);

/// comment(), broken between words into lines of at most `width` bytes, each with `prefix` before
/// it and a newline behind. Longer words stay whole.
std::string comment_block(std::string_view text, std::string_view prefix, std::size_t width = 96);

/// An identifier of both languages made from any text: PascalCase of its ASCII letters and digits
/// behind `prefix`, which must begin with a capital ("red floor" -> "Material_RedFloor"). A name
/// that `taken` already holds gets "_2", "_3", ...; the result is added to `taken`.
std::string identifier(std::string_view prefix, std::string_view name,
                       std::set<std::string>& taken);

}  // namespace litmus

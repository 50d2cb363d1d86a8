// Text from outside, made fit for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// `text` with every control character (an escape sequence could do anything to a terminal) and
/// every byte that is not UTF-8 as \xNN. Line breaks and tabs pass only through printable_lines().
std::string printable(std::string_view text);
std::string printable_lines(std::string_view text);

/// Bytes of the UTF-8 character that begins at `i`; 0 where none does.
std::size_t utf8_length(std::string_view text, std::size_t i);

/// Whether the text is UTF-16, which nothing here reads: by its byte order mark, or as ASCII letters with
/// a NUL beside each.
bool is_utf16(std::string_view text);
/// What is said of such a text.
inline constexpr std::string_view kUtf16Fault = "its text is UTF-16; save it as UTF-8";

}  // namespace plumbline

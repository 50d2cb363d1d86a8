// Lines, words and numbers of text formats. Private to engine/assets.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline::assets {

/// Cuts text into lines. Views are good until the next call.
class LineReader {
public:
    explicit LineReader(std::string_view text) : text_(text) {}

    /// The next line without its end and the blanks around it, joined where a backslash ends it;
    /// nothing at the end of text.
    std::optional<std::string_view> next();
    bool ended() const { return text_.empty(); }

private:
    std::string_view text_;
    std::string joined_;
};

/// Cuts the first word off the line, with the blanks around it.
std::string_view next_word(std::string_view& line);
/// The text without blanks at either end.
std::string_view trimmed(std::string_view text);
/// A number at the word's start, and the characters that it takes: none where there is none. Beyond
/// a double's range it is infinite, or 0.
struct LeadingNumber {
    double value{0.0};
    std::size_t length{0};
};
LeadingNumber leading_number(std::string_view word);
/// The whole word as a number that a float can hold, not NaN and not infinite; what is too small for
/// a float is 0.
std::optional<float> finite_number(std::string_view word);

}  // namespace plumbline::assets

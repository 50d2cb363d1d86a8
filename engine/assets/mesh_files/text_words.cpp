#include "engine/assets/mesh_files/text_words_impl.h"
#include "engine/core/text/split.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace plumbline::assets {
namespace {

bool is_blank(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\v' || letter == '\f';
}

}  // namespace

std::optional<std::string_view> LineReader::next() {
    if (text_.empty()) return std::nullopt;
    std::string_view line = trimmed(cut_part(text_, '\n'));
    if (!line.ends_with('\\')) return line;
    joined_.clear();
    bool goes_on = true;
    while (goes_on) {
        goes_on = line.ends_with('\\') && !text_.empty();
        if (line.ends_with('\\')) line.remove_suffix(1);
        joined_ += line;
        joined_ += ' ';
        if (goes_on) line = trimmed(cut_part(text_, '\n'));
    }
    return trimmed(joined_);
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view next_word(std::string_view& line) {
    line = trimmed(line);
    std::size_t end = 0;
    while (end < line.size() && !is_blank(line[end])) ++end;
    const std::string_view word = line.substr(0, end);
    line = trimmed(line.substr(end));
    return word;
}

LeadingNumber leading_number(std::string_view word) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    const auto length = static_cast<std::size_t>(end - word.data());
    if (fault == std::errc::result_out_of_range) {
        // The value is left alone, whichever end of the range the number lies beyond.
        const std::string_view digits = word.substr(0, length);
        const bool small = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
        if (!small) value = std::numeric_limits<double>::infinity();
    }
    return {.value = value, .length = length};
}

std::optional<float> finite_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const LeadingNumber number = leading_number(word);
    if (word.empty() || number.length != word.size()) return std::nullopt;
    const auto value = static_cast<float>(number.value);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace plumbline::assets

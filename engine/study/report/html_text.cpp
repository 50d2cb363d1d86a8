#include "engine/study/report/html_text.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::study {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Bytes of the well-formed UTF-8 character that `text` begins with; 0 where there is none.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    std::size_t length = 0;
    if (lead >= 0xC2 && lead <= 0xDF) length = 2;
    if (lead >= 0xE0 && lead <= 0xEF) length = 3;
    if (lead >= 0xF0 && lead <= 0xF4) length = 4;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
    }
    // Too long a form, half a surrogate pair, beyond the last character, or one that XML has not.
    if (lead == 0xE0 && byte(1) < 0xA0) return 0;
    if (lead == 0xED && byte(1) > 0x9F) return 0;
    if (lead == 0xF0 && byte(1) < 0x90) return 0;
    if (lead == 0xF4 && byte(1) > 0x8F) return 0;
    if (lead == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE) return 0;
    return length;
}

/// One ASCII character.
std::string_view escaped(const char& letter) {
    switch (letter) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        case '\n':
        case '\t':
            return {&letter, 1};
        default:
            break;
    }
    const bool is_control = static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F;
    return is_control ? kReplacement : std::string_view(&letter, 1);
}

}  // namespace

std::string escape_html(std::string_view text) {
    std::string out;
    out.reserve(text.size() + text.size() / 8);
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 1) {
            out += escaped(text.front());
        } else {
            out += length == 0 ? kReplacement : text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

std::string number_text(double value) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return "infinite";
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size >= 999.5 && size < 1e7) return fmt::format("{:.0f}", value);
    if (size < 1e-4 || size >= 1e7) return fmt::format("{:.1e}", value);
    return fmt::format("{:.3g}", value);
}

std::string error_text(double error) {
    if (!std::isfinite(error) || error == 0 || std::abs(error) < 1e-5) return number_text(error);
    return fmt::format("{} %", number_text(error * 100));
}

}  // namespace plumbline::study

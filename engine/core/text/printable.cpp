#include "engine/core/text/printable.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

constexpr unsigned char kDelete = 0x7f;

unsigned char byte_at(std::string_view text, std::size_t i) {
    return static_cast<unsigned char>(text[i]);
}

bool is_control_character(std::string_view text, std::size_t i) {
    const unsigned char first = byte_at(text, i);
    if (first < 0x80) return first < 0x20 || first == kDelete;
    return first == 0xC2 && i + 1 < text.size() && byte_at(text, i + 1) < 0xA0;
}

std::string escaped(std::string_view text, std::string_view passing) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        std::size_t length = utf8_length(text, i);
        if (is_control_character(text, i) && passing.find(text[i]) == std::string_view::npos)
            length = 0;
        if (length == 0) out += fmt::format("\\x{:02x}", static_cast<unsigned>(byte_at(text, i)));
        out += text.substr(i, length);
        i += length == 0 ? 1 : length;
    }
    return out;
}

}  // namespace

bool is_utf16(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
    if (text.size() < 4) return false;
    const auto is_letter = [&](std::size_t i) {
        const unsigned char byte = byte_at(text, i);
        return byte == '\t' || byte == '\r' || byte == '\n' || (byte >= 0x20 && byte < kDelete);
    };
    const std::size_t first = text[0] == '\0' ? 1 : 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i % 2 == first ? !is_letter(i) : text[i] != '\0') return false;
    }
    return true;
}

std::size_t utf8_length(std::string_view text, std::size_t i) {
    const unsigned char first = byte_at(text, i);
    if (first < 0x80) return 1;
    std::size_t length = 0;
    if (first >= 0xC2 && first < 0xE0) length = 2;
    if (first >= 0xE0 && first < 0xF0) length = 3;
    if (first >= 0xF0 && first < 0xF5) length = 4;
    if (length == 0 || i + length > text.size()) return 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte_at(text, i + k) & 0xC0U) != 0x80U) return 0;
    }
    const unsigned char second = byte_at(text, i + 1);
    // Longer than need be, surrogates, and beyond the last character.
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0)) return 0;
    if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90)) return 0;
    return length;
}

std::string printable(std::string_view text) {
    return escaped(text, {});
}

std::string printable_lines(std::string_view text) {
    return escaped(text, "\n\t");
}

}  // namespace plumbline

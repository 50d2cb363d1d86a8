#include "engine/platform/gamepad_mapping.h"

#include "engine/core/text/split.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace plumbline::platform {
namespace {

constexpr std::size_t kGuidDigits = 32;
constexpr std::size_t kMaxLineBytes = 1'024;
constexpr std::size_t kMaxNameBytes = 127;  // GLFW keeps 128 with the end

constexpr std::string_view kElements =
    "a b x y back start guide leftstick rightstick leftshoulder rightshoulder dpup dpdown dpleft "
    "dpright leftx lefty rightx righty lefttrigger righttrigger misc1 misc2 paddle1 paddle2 "
    "paddle3 "
    "paddle4 touchpad";

bool is_element(std::string_view name) {
    for (std::string_view rest = kElements; !rest.empty();)
        if (cut_part(rest, ' ') == name) return true;
    return false;
}

bool is_number(std::string_view text, int max) {
    if (text.empty() || text.size() > 3) return false;
    int value = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return false;
        value = value * 10 + (c - '0');
    }
    return value <= max;
}

/// "b3", "a2", "+a1", "-a1", "a4~", "h0.8".
bool is_source(std::string_view text) {
    if (text.empty()) return false;
    const bool half = text.front() == '+' || text.front() == '-';
    if (half) text.remove_prefix(1);
    if (text.empty()) return false;
    const char kind = text.front();
    text.remove_prefix(1);
    if (kind == 'b') return !half && is_number(text, 255);
    if (kind == 'a') {
        if (!text.empty() && text.back() == '~') text.remove_suffix(1);
        return is_number(text, 63);
    }
    const auto dot = text.find('.');
    if (kind != 'h' || half || dot == std::string_view::npos) return false;
    const std::string_view bit = text.substr(dot + 1);
    return is_number(text.substr(0, dot), 15) &&
           (bit == "1" || bit == "2" || bit == "4" || bit == "8");
}

Error fault(std::string message) {
    return {.message = std::move(message)};
}

Result<Done> check_element(std::string_view field) {
    const auto colon = field.find(':');
    if (colon == std::string_view::npos)
        return fault(fmt::format("\"{}\" is not element:source", field));
    std::string_view name = field.substr(0, colon);
    const std::string_view source = field.substr(colon + 1);
    if (name == "platform" || name == "crc" || name == "type" || name == "hint" ||
        name.starts_with("sdk"))
        return Done{};
    if (name.starts_with('+') || name.starts_with('-')) name.remove_prefix(1);
    if (!is_element(name)) return fault(fmt::format("unknown element \"{}\"", name));
    if (!is_source(source))
        return fault(fmt::format("\"{}\" is no button, axis or hat (b0, a0, h0.1)", source));
    return Done{};
}

}  // namespace

Result<Done> check_gamepad_mapping(std::string_view line) {
    if (line.size() > kMaxLineBytes)
        return fault(fmt::format("{} bytes long, at most {}", line.size(), kMaxLineBytes));
    const auto is_control = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    };
    if (std::ranges::any_of(line, is_control)) return fault("holds a control character");
    std::string_view rest = line;
    const std::string_view guid = cut_part(rest, ',');
    const auto is_hex = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
    if (guid.size() != kGuidDigits || !std::ranges::all_of(guid, is_hex))
        return fault("does not begin with 32 hexadecimal digits and a comma");
    const std::string_view name = cut_part(rest, ',');
    if (name.empty() || name.size() > kMaxNameBytes)
        return fault(
            fmt::format("the name has {} bytes, 1 to {} expected", name.size(), kMaxNameBytes));
    std::size_t elements = 0;
    while (!rest.empty()) {
        const std::string_view field = cut_part(rest, ',');
        if (field.empty()) continue;
        if (Result<Done> checked = check_element(field); !checked) return checked;
        ++elements;
    }
    if (elements == 0) return fault("maps nothing");
    return Done{};
}

GamepadMappings read_gamepad_mappings(std::string_view text) {
    GamepadMappings mappings;
    std::size_t number = 0;
    while (!text.empty()) {
        std::string_view line = cut_part(text, '\n');
        ++number;
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        if (line.empty() || line.front() == '#') continue;
        if (Result<Done> checked = check_gamepad_mapping(line); !checked) {
            mappings.rejected.push_back(fmt::format("{}: {}", number, checked.error().message));
            continue;
        }
        const auto platform = line.find("platform:");
        if (platform != std::string_view::npos && !line.substr(platform + 9).starts_with("Linux"))
            continue;
        mappings.accepted.emplace_back(line);
    }
    return mappings;
}

}  // namespace plumbline::platform

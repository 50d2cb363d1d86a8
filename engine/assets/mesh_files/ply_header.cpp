#include "engine/assets/mesh_files/ply_header_impl.h"
#include "engine/assets/mesh_files/text_words_impl.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMostElements = 64;
constexpr std::size_t kMostProperties = 256;

std::optional<PlyNumber> number_of(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, PlyNumber>, 16> kWords{
        {{"char", PlyNumber::Int8},
         {"int8", PlyNumber::Int8},
         {"uchar", PlyNumber::Uint8},
         {"uint8", PlyNumber::Uint8},
         {"short", PlyNumber::Int16},
         {"int16", PlyNumber::Int16},
         {"ushort", PlyNumber::Uint16},
         {"uint16", PlyNumber::Uint16},
         {"int", PlyNumber::Int32},
         {"int32", PlyNumber::Int32},
         {"uint", PlyNumber::Uint32},
         {"uint32", PlyNumber::Uint32},
         {"float", PlyNumber::Float},
         {"float32", PlyNumber::Float},
         {"double", PlyNumber::Double},
         {"float64", PlyNumber::Double}}};
    for (const auto& [known, number] : kWords) {
        if (word == known) return number;
    }
    return std::nullopt;
}

std::size_t bytes_of(PlyNumber number) {
    switch (number) {
        case PlyNumber::Int8:
        case PlyNumber::Uint8:
            return 1;
        case PlyNumber::Int16:
        case PlyNumber::Uint16:
            return 2;
        case PlyNumber::Int32:
        case PlyNumber::Uint32:
        case PlyNumber::Float:
            return 4;
        case PlyNumber::Double:
            return 8;
    }
    return 1;
}

/// One line up to its end, which is cut off too.
std::string_view header_line(std::string_view& bytes) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = trimmed(bytes.substr(0, end));
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return line;
}

std::string read_property(std::string_view line, PlyHeader& header) {
    if (header.elements.empty()) return "a property stands before any element";
    PlyProperty property;
    std::string_view type = next_word(line);
    if (type == "list") {
        property.count = number_of(next_word(line));
        if (!property.count) return "a list's length has an unknown type";
        type = next_word(line);
    }
    const std::optional<PlyNumber> number = number_of(type);
    if (!number) return fmt::format("the type \"{}\" is unknown", type);
    property.type = *number;
    property.name = std::string(next_word(line));
    header.elements.back().properties.push_back(std::move(property));
    return header.elements.back().properties.size() > kMostProperties ? "it has too many properties"
                                                                      : "";
}

std::string read_element(std::string_view line, PlyHeader& header) {
    PlyElement element{.name = std::string(next_word(line))};
    const std::string_view digits = next_word(line);
    const auto [end, fault] =
        std::from_chars(digits.data(), digits.data() + digits.size(), element.count);
    if (fault != std::errc{} || end != digits.data() + digits.size()) {
        return fmt::format("element {} has no count", element.name);
    }
    if (element.count > limits::kIndices)
        return fmt::format("{} {} are too many", element.count, element.name);
    header.elements.push_back(std::move(element));
    return header.elements.size() > kMostElements ? "it has too many elements" : "";
}

}  // namespace

std::string read_ply_header(std::string_view bytes, PlyHeader& header) {
    if (header_line(bytes) != "ply") return "its content is not PLY";
    bool has_format = false;
    while (!bytes.empty()) {
        std::string_view line = header_line(bytes);
        const std::string_view key = next_word(line);
        std::string fault;
        if (key == "end_header") {
            if (!has_format) return "its header names no format";
            header.body = bytes;
            return {};
        }
        if (key == "format") {
            const std::string_view format = next_word(line);
            has_format = true;
            if (format == "binary_little_endian") {
                header.format = PlyFormat::Little;
            } else if (format == "binary_big_endian") {
                header.format = PlyFormat::Big;
            } else if (format != "ascii") {
                fault = fmt::format("its format \"{}\" is unknown", format);
            }
        } else if (key == "element") {
            fault = read_element(line, header);
        } else if (key == "property") {
            fault = read_property(line, header);
        }
        if (!fault.empty()) return fault;
    }
    return "its header breaks off";
}

std::size_t least_bytes_of(const PlyHeader& header) {
    std::size_t least = 0;
    for (const PlyElement& element : header.elements) {
        for (const PlyProperty& property : element.properties) {
            const std::size_t bytes = header.format == PlyFormat::Text
                                          ? 2
                                          : bytes_of(property.count.value_or(property.type));
            least += element.count * bytes;
        }
    }
    return least;
}

}  // namespace plumbline::assets

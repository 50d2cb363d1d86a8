#include "engine/assets/mesh_files/ply_header_impl.h"
#include "engine/assets/mesh_files/text_words_impl.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/limits.h"
#include "engine/core/text/split.h"

#include <array>
#include <charconv>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMostElements = 64;
constexpr std::size_t kMostProperties = 256;

template <class T>
double read_as(ByteReader& from, std::endian order) {
    return static_cast<double>(from.number<T>(order));
}
constexpr std::array<PlyNumber, 8> kNumbers{
    {{"char", "int8", 1, read_as<std::int8_t>},
     {"uchar", "uint8", 1, read_as<std::uint8_t>, 255.0},
     {"short", "int16", 2, read_as<std::int16_t>},
     {"ushort", "uint16", 2, read_as<std::uint16_t>, 65'535.0},
     {"int", "int32", 4, read_as<std::int32_t>},
     {"uint", "uint32", 4, read_as<std::uint32_t>},
     {"float", "float32", 4, read_as<float>},
     {"double", "float64", 8, read_as<double>}}};

/// Null for a type unknown.
const PlyNumber* number_of(std::string_view word) {
    for (const PlyNumber& known : kNumbers) {
        if (word == known.name || word == known.other_name) return &known;
    }
    return nullptr;
}

void read_property(std::string_view line, PlyHeader& header) {
    if (header.elements.empty()) fail("a property stands before any element");
    PlyProperty property;
    std::string_view type = next_word(line);
    if (type == "list") {
        property.count = number_of(next_word(line));
        if (property.count == nullptr) fail("a list's length has an unknown type");
        type = next_word(line);
    }
    property.type = number_of(type);
    if (property.type == nullptr) fail("the type \"{}\" is unknown", type);
    property.name = std::string(next_word(line));
    std::vector<PlyProperty>& properties = header.elements.back().properties;
    properties.push_back(std::move(property));
    if (properties.size() > kMostProperties) fail("it has too many properties");
}

void read_element(std::string_view line, PlyHeader& header) {
    PlyElement element{.name = std::string(next_word(line))};
    const std::string_view digits = next_word(line);
    const auto [end, fault] =
        std::from_chars(digits.data(), digits.data() + digits.size(), element.count);
    if (fault != std::errc{} || end != digits.data() + digits.size()) {
        fail("element {} has no count", element.name);
    }
    if (element.count > limits::kIndices) fail("{} {} are too many", element.count, element.name);
    header.elements.push_back(std::move(element));
    if (header.elements.size() > kMostElements) fail("it has too many elements");
}

PlyFormat binary_format(std::string_view name) {
    if (name == "binary_little_endian") return PlyFormat::Little;
    if (name == "binary_big_endian") return PlyFormat::Big;
    fail("its format \"{}\" is unknown", name);
}

}  // namespace

PlyHeader read_ply_header(std::string_view bytes) {
    if (trimmed(cut_part(bytes, '\n')) != "ply") fail("its content is not PLY");
    PlyHeader header;
    bool has_format = false;
    while (!bytes.empty()) {
        std::string_view line = trimmed(cut_part(bytes, '\n'));
        const std::string_view key = next_word(line);
        if (key == "end_header") {
            if (!has_format) fail("its header names no format");
            header.body = bytes;
            return header;
        }
        if (key == "format") {
            const std::string_view format = next_word(line);
            if (format != "ascii") header.format = binary_format(format);
            has_format = true;
        } else if (key == "element") {
            read_element(line, header);
        } else if (key == "property") {
            read_property(line, header);
        }
    }
    fail("its header breaks off");
}

std::size_t least_bytes_of(const PlyHeader& header) {
    std::size_t least = 0;
    for (const PlyElement& element : header.elements) {
        for (const PlyProperty& property : element.properties) {
            const PlyNumber* stored = property.count != nullptr ? property.count : property.type;
            least += element.count * (header.format == PlyFormat::Text ? 2 : stored->bytes);
        }
    }
    return least;
}

}  // namespace plumbline::assets

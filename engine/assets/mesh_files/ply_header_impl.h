// What the head of a PLY file promises. Private to ply_import.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets {

enum class PlyNumber : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

struct PlyProperty {
    std::string name;
    PlyNumber type{PlyNumber::Float};
    std::optional<PlyNumber> count;  ///< lists: how their length is stored
};

struct PlyElement {
    std::string name;
    std::size_t count{0};
    std::vector<PlyProperty> properties;
};

enum class PlyFormat { Text, Little, Big };

struct PlyHeader {
    PlyFormat format{PlyFormat::Text};
    std::vector<PlyElement> elements;
    std::string_view body;
};

/// Empty, or what is wrong with it.
std::string read_ply_header(std::string_view bytes, PlyHeader& header);

/// The least that the promised rows take, to refuse counts that the file has no room for.
std::size_t least_bytes_of(const PlyHeader& header);

}  // namespace plumbline::assets

// What the head of a PLY file promises. Private to ply_import.cpp.
#pragma once

#include "engine/assets/byte_reader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets {

/// How numbers are stored.
struct PlyNumber {
    std::string_view name;
    std::string_view other_name;
    std::size_t bytes;
    double (*read)(ByteReader& from, std::endian order);
    double range{1.0};  ///< colours are shares of this
};

struct PlyProperty {
    std::string name;
    const PlyNumber* type{nullptr};
    const PlyNumber* count{nullptr};  ///< lists: how their length is stored
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

/// Fails where something is wrong with it.
PlyHeader read_ply_header(std::string_view bytes);

/// The least that the promised rows take, to refuse counts that the file has no room for.
std::size_t least_bytes_of(const PlyHeader& header);

}  // namespace plumbline::assets

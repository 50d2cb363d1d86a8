#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMaxViews = 65'536;

/// A component type by GL's number.
struct ComponentType {
    unsigned number;
    std::size_t bytes;
    float range;  ///< what a normalized whole number is divided by
};
constexpr std::array<ComponentType, 6> kComponentTypes{{{5120, 1, 127.0F},
                                                        {5121, 1, 255.0F},
                                                        {5122, 2, 32'767.0F},
                                                        {5123, 2, 65'535.0F},
                                                        {5125, 4, 1.0F},
                                                        {5126, 4, 1.0F}}};

/// Of no bytes where it is unknown.
ComponentType component_type(unsigned number) {
    const auto* const found = std::ranges::find(kComponentTypes, number, &ComponentType::number);
    return found == kComponentTypes.end() ? ComponentType{number, 0, 1.0F} : *found;
}

/// The bytes behind a buffer's URI.
std::string buffer_bytes(GltfReader& reader, const std::string& uri, const std::string& where) {
    if (uri.starts_with("data:")) return data_uri_bytes(uri, where);
    const std::filesystem::path file = resolved(reader, decoded_uri(uri, where), where);
    Result<std::string> bytes = read_file(file, limits::kModelFileBytes);
    reader.model.files.push_back(file);
    if (!bytes) fail("{}: {}", where, bytes.error().message);
    return std::move(*bytes);
}

/// The elements of an accessor that are others than in its view.
struct SparsePart {
    std::vector<std::uint32_t> indices{};
    std::string_view values{};  ///< in a buffer, packed
};

SparsePart read_sparse(const GltfReader& reader,
                       const Json& source,
                       const GltfAccessor& accessor,
                       const std::string& where) {
    const auto part = [&](const char* key) {
        const auto found = source.find(key);
        if (found == source.end() || !found->is_object()) {
            fail("{} must have indices and values", where);
        }
        return GltfObject{.json = *found, .where = fmt::format("{}.{}", where, key)};
    };
    const GltfObject indices = part("indices");
    const GltfObject values = part("values");
    const std::size_t count = GltfObject{source, where}.whole("count").value_or(0);
    const auto index_view = indices.index("bufferView", reader.views.size());
    const auto value_view = values.index("bufferView", reader.views.size());
    const std::size_t index_offset = indices.whole("byteOffset").value_or(0);
    const std::size_t value_offset = values.whole("byteOffset").value_or(0);
    const std::size_t number = indices.whole("componentType").value_or(0);
    if (count < 1 || count > accessor.count) {
        fail("{}.count is {}; 1 to {} fit", where, count, accessor.count);
    }
    if (!is_whole(number)) fail("{}.indices.componentType is {}", where, number);
    if (!index_view || !value_view) fail("{} lacks a bufferView", where);
    const auto component = static_cast<unsigned>(number);
    const std::size_t index_bytes = component_type(component).bytes;
    const GltfView& index_place = reader.views[*index_view];
    const GltfView& value_place = reader.views[*value_view];
    if (index_offset > index_place.size || count * index_bytes > index_place.size - index_offset ||
        value_offset > value_place.size ||
        count * element_bytes(accessor) > value_place.size - value_offset) {
        fail("{} runs past its bufferView", where);
    }
    SparsePart sparse;
    sparse.values = std::string_view(reader.buffers[value_place.buffer])
                        .substr(value_place.offset + value_offset);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = unsigned_at(reader.buffers[index_place.buffer],
                                                index_place.offset + index_offset + i * index_bytes,
                                                component);
        if (index >= accessor.count) {
            fail("{}: index {} is out of range; the accessor has {} elements",
                 where,
                 index,
                 accessor.count);
        }
        sparse.indices.push_back(index);
    }
    return sparse;
}

/// Whether the accessor's elements lie within its view.
void check_extent(const GltfReader& reader,
                  const GltfAccessor& accessor,
                  const std::string& where) {
    if (!accessor.view) return;
    const GltfView& view = reader.views[*accessor.view];
    const std::size_t bytes = element_bytes(accessor);
    const std::size_t stride = elements_of(reader, accessor).stride;
    if (stride < bytes) {
        fail("{}: a stride of {} is shorter than an element of {} bytes", where, stride, bytes);
    }
    const std::size_t extent = stride * (accessor.count - 1) + bytes;  // counts are limited: fits
    if (accessor.offset > view.size || extent > view.size - accessor.offset) {
        fail("{} runs past its bufferView: {} bytes from {} of {}",
             where,
             extent,
             accessor.offset,
             view.size);
    }
}

/// Elements without a view are zeros, and sparse ones differ in places: both are written out here
/// as a packed buffer of our own, so that only the plain case goes on.
void make_dense(GltfReader& reader,
                GltfAccessor& accessor,
                const SparsePart& sparse,
                const std::string& where) {
    const std::size_t element = element_bytes(accessor);
    if (reader.buffer_bytes + element * accessor.count > limits::kModelFileBytes) {
        fail("{}: written out it passes {} bytes", where, limits::kModelFileBytes);
    }
    std::string dense(element * accessor.count, '\0');
    if (accessor.view) {
        const GltfElements from = elements_of(reader, accessor);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            std::memcpy(dense.data() + i * element, from.bytes.data() + from.place(i), element);
        }
    }
    for (std::size_t i = 0; i < sparse.indices.size(); ++i) {
        std::memcpy(dense.data() + sparse.indices[i] * element,
                    sparse.values.data() + i * element,
                    element);
    }
    accessor.view = add_buffer(reader, std::move(dense));
    accessor.offset = 0;
}

/// A signed or unsigned whole number as stored.
float whole_at(const std::string& bytes, std::size_t place, unsigned component) {
    const std::uint32_t raw = unsigned_at(bytes, place, component);
    if (component == 5120) return static_cast<float>(static_cast<std::int8_t>(raw));
    if (component == 5122) return static_cast<float>(static_cast<std::int16_t>(raw));
    return static_cast<float>(raw);
}

}  // namespace

std::size_t component_count(std::string_view type) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 7> kTypes{{{"SCALAR", 1},
                                                                              {"VEC2", 2},
                                                                              {"VEC3", 3},
                                                                              {"VEC4", 4},
                                                                              {"MAT2", 4},
                                                                              {"MAT3", 9},
                                                                              {"MAT4", 16}}};
    for (const auto& [known, count] : kTypes) {
        if (type == known) return count;
    }
    return 0;
}

std::size_t element_bytes(const GltfAccessor& accessor) {
    return component_type(accessor.component).bytes * component_count(accessor.type);
}

GltfElements elements_of(const GltfReader& reader, const GltfAccessor& accessor) {
    const GltfView& view = reader.views[*accessor.view];
    return {.bytes = reader.buffers[view.buffer],
            .first = view.offset + accessor.offset,
            .stride = view.stride == 0 ? element_bytes(accessor) : view.stride};
}

bool is_whole(std::size_t component) {
    return component == 5121 || component == 5123 || component == 5125;
}

std::uint32_t unsigned_at(const std::string& bytes, std::size_t place, unsigned component) {
    std::uint32_t value = 0;
    for (std::size_t i = component_type(component).bytes; i-- > 0;) {
        value = value << 8U | static_cast<std::uint8_t>(bytes[place + i]);
    }
    return value;
}

std::vector<float> floats_of(GltfReader& reader, const GltfAccessor& accessor) {
    const std::size_t width = component_count(accessor.type);
    if (accessor.count * width > reader.numbers_left) {
        fail("its accessors are used for more numbers than are read");
    }
    reader.numbers_left -= accessor.count * width;
    const GltfElements from = elements_of(reader, accessor);
    const ComponentType type = component_type(accessor.component);
    const float share = accessor.normalized ? 1.0F / type.range : 1.0F;
    std::vector<float> values(accessor.count * width);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        const std::size_t place = from.place(i);
        if (accessor.component == 5126) {
            std::memcpy(&values[i * width], from.bytes.data() + place, width * sizeof(float));
            continue;
        }
        for (std::size_t k = 0; k < width; ++k) {
            const float value =
                whole_at(from.bytes, place + k * type.bytes, accessor.component) * share;
            values[i * width + k] = accessor.normalized ? std::max(value, -1.0F) : value;
        }
    }
    return values;
}

std::string data_uri_bytes(std::string_view uri, const std::string& where) {
    const std::size_t comma = uri.find(',');
    const std::string_view head = uri.substr(0, comma);
    if (comma == std::string_view::npos || !head.ends_with(";base64")) {
        fail("{}.uri is a data URI that is not base64", where);
    }
    std::optional<std::string> decoded = base64_decoded(uri.substr(comma + 1));
    if (!decoded) fail("{}.uri holds bad base64", where);
    return std::move(*decoded);
}

std::string decoded_uri(const std::string& uri, const std::string& where) {
    std::optional<std::string> decoded = percent_decoded(uri);
    if (!decoded) fail("{}.uri: \"{}\" has a bad percent escape", where, uri);
    return std::move(*decoded);
}

std::filesystem::path resolved(GltfReader& reader,
                               const std::string& reference,
                               const std::string& where) {
    Result<std::filesystem::path> file = reader.references.resolve(reference, where + ".uri");
    if (!file) fail("{}", file.error().message);
    return std::move(*file);
}

std::size_t add_buffer(GltfReader& reader, std::string bytes) {
    const std::size_t buffer = reader.buffers.size();
    const std::size_t size = bytes.size();
    reader.buffers.push_back(std::move(bytes));
    reader.buffer_bytes += size;
    reader.views.push_back({.buffer = buffer, .offset = 0, .size = size});
    return reader.views.size() - 1;
}

void read_buffers(GltfReader& reader, std::optional<std::string_view> binary) {
    for (const GltfObject& source : reader.objects("buffers", limits::kReferencedFiles)) {
        const std::string& where = source.where;
        const std::size_t size = source.whole("byteLength").value_or(0);
        const std::string uri = source.text("uri");
        if (size == 0) fail("{}.byteLength is missing or 0", where);
        std::string bytes;
        if (!uri.empty()) {
            bytes = buffer_bytes(reader, uri, where);
        } else if (reader.buffers.empty() && binary) {
            bytes = *binary;
        } else {
            fail("{} has neither a URI nor the GLB's binary chunk", where);
        }
        if (bytes.size() < size) {
            fail("{} has {} bytes; its byteLength says {}", where, bytes.size(), size);
        }
        reader.buffer_bytes += size;
        if (reader.buffer_bytes > limits::kModelFileBytes) {
            fail("its buffers have more than {} bytes", limits::kModelFileBytes);
        }
        bytes.resize(size);
        reader.buffers.push_back(std::move(bytes));
    }
}

void read_views(GltfReader& reader) {
    for (const GltfObject& source : reader.objects("bufferViews", kMaxViews)) {
        const auto buffer = source.index("buffer", reader.buffers.size());
        GltfView view{.offset = source.whole("byteOffset").value_or(0),
                      .size = source.whole("byteLength").value_or(0),
                      .stride = source.whole("byteStride").value_or(0)};
        if (!buffer) fail("{} names no buffer", source.where);
        view.buffer = *buffer;
        const std::size_t available = reader.buffers[view.buffer].size();
        if (view.size == 0 || view.offset > available || view.size > available - view.offset) {
            fail("{} runs past its buffer: {} bytes from {} of {}",
                 source.where,
                 view.size,
                 view.offset,
                 available);
        }
        if (view.stride != 0 && (view.stride < 4 || view.stride > 252 || view.stride % 4 != 0)) {
            fail("{}.byteStride is {}; 4 to 252 in steps of 4 are allowed",
                 source.where,
                 view.stride);
        }
        reader.views.push_back(view);
    }
}

void read_accessors(GltfReader& reader) {
    for (const GltfObject& source : reader.objects("accessors", limits::kModelAccessors)) {
        const std::string& where = source.where;
        GltfAccessor accessor{
            .view = source.index("bufferView", reader.views.size()),
            .offset = source.whole("byteOffset").value_or(0),
            .count = source.whole("count").value_or(0),
            .component = static_cast<unsigned>(
                std::min<std::size_t>(source.whole("componentType").value_or(0), 0xFFFFU)),
            .type = source.text("type"),
            .normalized = source.json.value("normalized", Json(false)) == Json(true)};
        if (element_bytes(accessor) == 0) {
            fail("{}: componentType {} of type \"{}\" is unknown",
                 where,
                 accessor.component,
                 accessor.type);
        }
        if (accessor.count < 1 || accessor.count > limits::kIndices) {
            fail("{}.count is {}; 1 to {} are read", where, accessor.count, limits::kIndices);
        }
        check_extent(reader, accessor, where);
        const auto sparse = source.json.find("sparse");
        if (sparse != source.json.end()) {
            make_dense(
                reader, accessor, read_sparse(reader, *sparse, accessor, where + ".sparse"), where);
        } else if (!accessor.view) {
            make_dense(reader, accessor, {}, where);
        }
        reader.accessors.push_back(std::move(accessor));
    }
}

}  // namespace plumbline::assets

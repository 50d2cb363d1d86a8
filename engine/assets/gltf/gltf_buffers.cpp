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

std::size_t component_bytes(unsigned component) {
    switch (component) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

/// The bytes behind a buffer's URI; a fault leaves them empty.
std::string buffer_bytes(GltfReader& reader, const std::string& uri, const std::string& where) {
    if (uri.starts_with("data:")) return data_uri_bytes(reader, uri, where);
    const std::optional<std::string> decoded = percent_decoded(uri);
    if (!decoded) {
        reader.fail("{}.uri: \"{}\" has a bad percent escape", where, uri);
        return {};
    }
    const Result<std::filesystem::path> file = reader.references.resolve(*decoded, where + ".uri");
    if (!file) {
        reader.fail("{}", file.error().message);
        return {};
    }
    Result<std::string> bytes = read_file(*file, limits::kModelFileBytes);
    reader.model.files.push_back(*file);
    if (bytes) return std::move(*bytes);
    reader.fail("{}: {}", where, bytes.error().message);
    return {};
}

/// The sparse part: ranges, and every index.
void read_sparse(GltfReader& reader,
                 const Json& sparse,
                 const GltfAccessor& accessor,
                 const std::string& where) {
    if (!sparse.is_object() || !sparse.contains("indices") || !sparse.contains("values") ||
        !sparse["indices"].is_object() || !sparse["values"].is_object()) {
        reader.fail("{} must have indices and values", where);
        return;
    }
    const Json& indices = sparse["indices"];
    const Json& values = sparse["values"];
    const std::size_t count = reader.whole(sparse, "count", where).value_or(0);
    const auto index_view =
        reader.index(indices, "bufferView", where + ".indices", reader.views.size());
    const auto value_view =
        reader.index(values, "bufferView", where + ".values", reader.views.size());
    const std::size_t index_offset =
        reader.whole(indices, "byteOffset", where + ".indices").value_or(0);
    const std::size_t value_offset =
        reader.whole(values, "byteOffset", where + ".values").value_or(0);
    const std::size_t component =
        reader.whole(indices, "componentType", where + ".indices").value_or(0);
    if (reader.failed()) return;
    if (count < 1 || count > accessor.count) {
        reader.fail("{}.count is {}; 1 to {} fit", where, count, accessor.count);
        return;
    }
    if (component != 5121 && component != 5123 && component != 5125) {
        reader.fail("{}.indices.componentType is {}", where, component);
        return;
    }
    if (!index_view || !value_view) {
        reader.fail("{} lacks a bufferView", where);
        return;
    }
    const std::size_t index_bytes = component_bytes(static_cast<unsigned>(component));
    const GltfView& index_place = reader.views[*index_view];
    const GltfView& value_place = reader.views[*value_view];
    if (index_offset > index_place.size || count * index_bytes > index_place.size - index_offset ||
        value_offset > value_place.size ||
        count * element_bytes(accessor) > value_place.size - value_offset) {
        reader.fail("{} runs past its bufferView", where);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = unsigned_at(reader.buffers[index_place.buffer],
                                                index_place.offset + index_offset + i * index_bytes,
                                                static_cast<unsigned>(component));
        if (index >= accessor.count) {
            reader.fail("{}: index {} is out of range; the accessor has {} elements",
                        where,
                        index,
                        accessor.count);
            return;
        }
    }
}

/// Whether the accessor's elements lie within its view.
void check_extent(GltfReader& reader, const GltfAccessor& accessor, const std::string& where) {
    if (!accessor.view) return;
    const GltfView& view = reader.views[*accessor.view];
    const std::size_t bytes = element_bytes(accessor);
    const std::size_t stride = view.stride == 0 ? bytes : view.stride;
    if (stride < bytes) {
        reader.fail(
            "{}: a stride of {} is shorter than an element of {} bytes", where, stride, bytes);
        return;
    }
    const std::size_t extent = stride * (accessor.count - 1) + bytes;  // counts are limited: fits
    if (accessor.offset > view.size || extent > view.size - accessor.offset) {
        reader.fail("{} runs past its bufferView: {} bytes from {} of {}",
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
                const Json& source,
                const std::string& where) {
    const std::size_t element = element_bytes(accessor);
    if (reader.buffer_bytes + element * accessor.count > limits::kModelFileBytes) {
        reader.fail("{}: written out it passes {} bytes", where, limits::kModelFileBytes);
        return;
    }
    std::string dense(element * accessor.count, '\0');
    if (accessor.view) {
        const GltfView& view = reader.views[*accessor.view];
        const std::size_t stride = view.stride == 0 ? element : view.stride;
        const char* first = reader.buffers[view.buffer].data() + view.offset + accessor.offset;
        for (std::size_t i = 0; i < accessor.count; ++i) {
            std::memcpy(dense.data() + i * element, first + i * stride, element);
        }
    }
    if (accessor.sparse) {
        const Json& sparse = source["sparse"];
        const Json& indices = sparse["indices"];
        const Json& values = sparse["values"];
        const auto offset_of = [](const Json& part) {
            return part.value("byteOffset", std::size_t{0});
        };
        const GltfView& index_view = reader.views[indices["bufferView"].get<std::size_t>()];
        const GltfView& value_view = reader.views[values["bufferView"].get<std::size_t>()];
        const auto component = indices["componentType"].get<unsigned>();
        for (std::size_t i = 0; i < sparse["count"].get<std::size_t>(); ++i) {
            const std::uint32_t index =
                unsigned_at(reader.buffers[index_view.buffer],
                            index_view.offset + offset_of(indices) + i * component_bytes(component),
                            component);
            const char* value = reader.buffers[value_view.buffer].data() + value_view.offset +
                                offset_of(values) + i * element;
            std::memcpy(dense.data() + index * element, value, element);
        }
    }
    accessor.view = add_buffer(reader, std::move(dense));
    accessor.offset = 0;
    accessor.sparse = false;
}

/// A signed or unsigned whole number as stored.
float whole_at(const std::string& bytes, std::size_t place, unsigned component) {
    const std::uint32_t raw = unsigned_at(bytes, place, component);
    if (component == 5120) return static_cast<float>(static_cast<std::int8_t>(raw));
    if (component == 5122) return static_cast<float>(static_cast<std::int16_t>(raw));
    return static_cast<float>(raw);
}

/// What a normalized whole number is divided by.
float range_of(unsigned component) {
    switch (component) {
        case 5120:
            return 127.0F;
        case 5121:
            return 255.0F;
        case 5122:
            return 32'767.0F;
        case 5123:
            return 65'535.0F;
        default:
            return 1.0F;
    }
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
    return component_bytes(accessor.component) * component_count(accessor.type);
}

std::uint32_t unsigned_at(const std::string& bytes, std::size_t place, unsigned component) {
    std::uint32_t value = 0;
    for (std::size_t i = component_bytes(component); i-- > 0;) {
        value = value << 8U | static_cast<std::uint8_t>(bytes[place + i]);
    }
    return value;
}

std::vector<float> floats_of(GltfReader& reader, const GltfAccessor& accessor) {
    const std::size_t numbers = accessor.count * component_count(accessor.type);
    if (numbers > reader.numbers_left) {
        reader.fail("its accessors are used for more numbers than are read");
        return {};
    }
    reader.numbers_left -= numbers;
    const GltfView& view = reader.views[*accessor.view];
    const std::string& bytes = reader.buffers[view.buffer];
    const std::size_t width = component_count(accessor.type);
    const std::size_t step = component_bytes(accessor.component);
    const std::size_t stride = view.stride == 0 ? element_bytes(accessor) : view.stride;
    const float share = accessor.normalized ? 1.0F / range_of(accessor.component) : 1.0F;
    std::vector<float> values(accessor.count * width);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        const std::size_t place = view.offset + accessor.offset + i * stride;
        if (accessor.component == 5126) {
            std::memcpy(&values[i * width], bytes.data() + place, width * sizeof(float));
            continue;
        }
        for (std::size_t k = 0; k < width; ++k) {
            const float value = whole_at(bytes, place + k * step, accessor.component) * share;
            values[i * width + k] = accessor.normalized ? std::max(value, -1.0F) : value;
        }
    }
    return values;
}

std::string data_uri_bytes(GltfReader& reader, std::string_view uri, const std::string& where) {
    const std::size_t comma = uri.find(',');
    const std::string_view head = uri.substr(0, comma);
    if (comma == std::string_view::npos || !head.ends_with(";base64")) {
        reader.fail("{}.uri is a data URI that is not base64", where);
        return {};
    }
    std::optional<std::string> decoded = base64_decoded(uri.substr(comma + 1));
    if (!decoded) reader.fail("{}.uri holds bad base64", where);
    return std::move(decoded).value_or("");
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
    const Json& list = reader.objects("buffers", limits::kReferencedFiles);
    for (std::size_t i = 0; i < list.size() && !reader.failed(); ++i) {
        const std::string where = fmt::format("buffers[{}]", i);
        const std::size_t size = reader.whole(list[i], "byteLength", where).value_or(0);
        const std::string uri = reader.text(list[i], "uri", where);
        if (reader.failed()) return;
        if (size == 0) reader.fail("{}.byteLength is missing or 0", where);
        std::string bytes;
        if (!uri.empty()) {
            bytes = buffer_bytes(reader, uri, where);
        } else if (i == 0 && binary) {
            bytes = *binary;
        } else {
            reader.fail("{} has neither a URI nor the GLB's binary chunk", where);
        }
        if (reader.failed()) return;
        if (bytes.size() < size) {
            reader.fail("{} has {} bytes; its byteLength says {}", where, bytes.size(), size);
        }
        reader.buffer_bytes += size;
        if (reader.buffer_bytes > limits::kModelFileBytes) {
            reader.fail("its buffers have more than {} bytes", limits::kModelFileBytes);
        }
        bytes.resize(size);
        reader.buffers.push_back(std::move(bytes));
    }
}

void read_views(GltfReader& reader) {
    const Json& list = reader.objects("bufferViews", kMaxViews);
    for (std::size_t i = 0; i < list.size() && !reader.failed(); ++i) {
        const std::string where = fmt::format("bufferViews[{}]", i);
        const auto buffer = reader.index(list[i], "buffer", where, reader.buffers.size());
        GltfView view{.offset = reader.whole(list[i], "byteOffset", where).value_or(0),
                      .size = reader.whole(list[i], "byteLength", where).value_or(0),
                      .stride = reader.whole(list[i], "byteStride", where).value_or(0)};
        if (reader.failed()) return;
        if (!buffer) {
            reader.fail("{} names no buffer", where);
            return;
        }
        view.buffer = *buffer;
        const std::size_t available = reader.buffers[view.buffer].size();
        if (view.size == 0 || view.offset > available || view.size > available - view.offset) {
            reader.fail("{} runs past its buffer: {} bytes from {} of {}",
                        where,
                        view.size,
                        view.offset,
                        available);
        }
        if (view.stride != 0 && (view.stride < 4 || view.stride > 252 || view.stride % 4 != 0)) {
            reader.fail(
                "{}.byteStride is {}; 4 to 252 in steps of 4 are allowed", where, view.stride);
        }
        reader.views.push_back(view);
    }
}

void read_accessors(GltfReader& reader) {
    const Json& list = reader.objects("accessors", limits::kModelAccessors);
    for (std::size_t i = 0; i < list.size() && !reader.failed(); ++i) {
        const std::string where = fmt::format("accessors[{}]", i);
        GltfAccessor accessor{
            .view = reader.index(list[i], "bufferView", where, reader.views.size()),
            .offset = reader.whole(list[i], "byteOffset", where).value_or(0),
            .count = reader.whole(list[i], "count", where).value_or(0),
            .component = static_cast<unsigned>(std::min<std::size_t>(
                reader.whole(list[i], "componentType", where).value_or(0), 0xFFFFU)),
            .type = reader.text(list[i], "type", where),
            .normalized = list[i].value("normalized", Json(false)) == Json(true),
            .sparse = list[i].contains("sparse")};
        if (reader.failed()) return;
        if (element_bytes(accessor) == 0) {
            reader.fail("{}: componentType {} of type \"{}\" is unknown",
                        where,
                        accessor.component,
                        accessor.type);
            return;
        }
        if (accessor.count < 1 || accessor.count > limits::kIndices) {
            reader.fail(
                "{}.count is {}; 1 to {} are read", where, accessor.count, limits::kIndices);
            return;
        }
        check_extent(reader, accessor, where);
        if (accessor.sparse && !reader.failed()) {
            read_sparse(reader, list[i]["sparse"], accessor, where + ".sparse");
        }
        if (reader.failed()) return;
        if (!accessor.view || accessor.sparse) make_dense(reader, accessor, list[i], where);
        if (reader.failed()) return;
        reader.accessors.push_back(std::move(accessor));
    }
}

}  // namespace plumbline::assets

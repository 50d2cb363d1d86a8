#include "engine/assets/gltf_check_impl.h"
#include "engine/core/files.h"
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

/// The bytes behind a buffer's URI; a fault leaves them empty.
std::string buffer_bytes(GltfCheck& check, const std::string& uri, const std::string& where) {
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(',');
        const std::string_view head = std::string_view(uri).substr(0, comma);
        if (comma == std::string::npos || !head.ends_with(";base64")) {
            check.fail("{}.uri is a data URI that is not base64", where);
            return {};
        }
        std::optional<std::string> decoded =
            base64_decoded(std::string_view(uri).substr(comma + 1));
        if (!decoded) check.fail("{}.uri holds bad base64", where);
        return std::move(decoded).value_or("");
    }
    const std::optional<std::string> decoded = percent_decoded(uri);
    if (!decoded) {
        check.fail("{}.uri: \"{}\" has a bad percent escape", where, uri);
        return {};
    }
    const Result<std::filesystem::path> file = check.references.resolve(*decoded, where + ".uri");
    if (!file) {
        check.fail("{}", file.error().message);
        return {};
    }
    Result<std::string> bytes = read_file(*file, limits::kModelFileBytes);
    if (bytes) return std::move(*bytes);
    check.fail("{}: {}", where, bytes.error().message);
    return {};
}

/// The sparse part: ranges, and every index.
void check_sparse(GltfCheck& check,
                  const Json& sparse,
                  const GltfAccessor& accessor,
                  const std::string& where) {
    if (!sparse.is_object() || !sparse.contains("indices") || !sparse.contains("values") ||
        !sparse["indices"].is_object() || !sparse["values"].is_object()) {
        check.fail("{} must have indices and values", where);
        return;
    }
    const Json& indices = sparse["indices"];
    const Json& values = sparse["values"];
    const std::size_t count = check.whole(sparse, "count", where).value_or(0);
    const auto index_view =
        check.index(indices, "bufferView", where + ".indices", check.views.size());
    const auto value_view =
        check.index(values, "bufferView", where + ".values", check.views.size());
    const std::size_t index_offset =
        check.whole(indices, "byteOffset", where + ".indices").value_or(0);
    const std::size_t value_offset =
        check.whole(values, "byteOffset", where + ".values").value_or(0);
    const std::size_t component =
        check.whole(indices, "componentType", where + ".indices").value_or(0);
    if (check.failed()) return;
    if (count < 1 || count > accessor.count) {
        check.fail("{}.count is {}; 1 to {} fit", where, count, accessor.count);
        return;
    }
    if (component != 5121 && component != 5123 && component != 5125) {
        check.fail("{}.indices.componentType is {}", where, component);
        return;
    }
    if (!index_view || !value_view) {
        check.fail("{} lacks a bufferView", where);
        return;
    }
    const std::size_t index_bytes = component_bytes(static_cast<unsigned>(component));
    const GltfView& index_place = check.views[*index_view];
    const GltfView& value_place = check.views[*value_view];
    if (index_offset > index_place.size || count * index_bytes > index_place.size - index_offset ||
        value_offset > value_place.size ||
        count * element_bytes(accessor) > value_place.size - value_offset) {
        check.fail("{} runs past its bufferView", where);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = unsigned_at(check.buffers[index_place.buffer],
                                                index_place.offset + index_offset + i * index_bytes,
                                                static_cast<unsigned>(component));
        if (index >= accessor.count) {
            check.fail("{}: index {} is out of range; the accessor has {} elements",
                       where,
                       index,
                       accessor.count);
            return;
        }
    }
}

/// Whether the accessor's elements lie within its view.
void check_extent(GltfCheck& check, const GltfAccessor& accessor, const std::string& where) {
    if (!accessor.view) return;
    const GltfView& view = check.views[*accessor.view];
    const std::size_t bytes = element_bytes(accessor);
    const std::size_t stride = view.stride == 0 ? bytes : view.stride;
    if (stride < bytes) {
        check.fail(
            "{}: a stride of {} is shorter than an element of {} bytes", where, stride, bytes);
        return;
    }
    const std::size_t extent = stride * (accessor.count - 1) + bytes;  // counts are limited: fits
    if (accessor.offset > view.size || extent > view.size - accessor.offset) {
        check.fail("{} runs past its bufferView: {} bytes from {} of {}",
                   where,
                   extent,
                   accessor.offset,
                   view.size);
    }
}

/// Elements without a view are zeros, and sparse ones differ in places: both are written out here
/// as a packed buffer of our own, so that only the plain case goes on.
void make_dense(GltfCheck& check,
                GltfAccessor& accessor,
                const Json& source,
                const std::string& where) {
    const std::size_t element = element_bytes(accessor);
    if (check.buffer_bytes + element * accessor.count > limits::kModelFileBytes) {
        check.fail("{}: written out it passes {} bytes", where, limits::kModelFileBytes);
        return;
    }
    std::string dense(element * accessor.count, '\0');
    if (accessor.view) {
        const GltfView& view = check.views[*accessor.view];
        const std::size_t stride = view.stride == 0 ? element : view.stride;
        const char* first = check.buffers[view.buffer].data() + view.offset + accessor.offset;
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
        const GltfView& index_view = check.views[indices["bufferView"].get<std::size_t>()];
        const GltfView& value_view = check.views[values["bufferView"].get<std::size_t>()];
        const auto component = indices["componentType"].get<unsigned>();
        for (std::size_t i = 0; i < sparse["count"].get<std::size_t>(); ++i) {
            const std::uint32_t index =
                unsigned_at(check.buffers[index_view.buffer],
                            index_view.offset + offset_of(indices) + i * component_bytes(component),
                            component);
            const char* value = check.buffers[value_view.buffer].data() + value_view.offset +
                                offset_of(values) + i * element;
            std::memcpy(dense.data() + index * element, value, element);
        }
    }
    accessor.view = add_buffer(check, std::move(dense));
    accessor.offset = 0;
    accessor.sparse = false;
}

}  // namespace

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

std::size_t add_buffer(GltfCheck& check, std::string bytes) {
    const std::size_t buffer = check.buffers.size();
    const std::size_t size = bytes.size();
    check.clean["buffers"].push_back(
        Json{{"byteLength", size}, {"uri", fmt::format("buffer{}.bin", buffer)}});
    check.clean["bufferViews"].push_back(
        Json{{"buffer", buffer}, {"byteOffset", 0}, {"byteLength", size}});
    check.buffers.push_back(std::move(bytes));
    check.buffer_bytes += size;
    check.views.push_back({.buffer = buffer, .offset = 0, .size = size});
    return check.views.size() - 1;
}

void check_buffers(GltfCheck& check, std::optional<std::string_view> binary) {
    const Json& list = check.objects("buffers", limits::kReferencedFiles);
    for (std::size_t i = 0; i < list.size() && !check.failed(); ++i) {
        const std::string where = fmt::format("buffers[{}]", i);
        const std::size_t size = check.whole(list[i], "byteLength", where).value_or(0);
        const std::string uri = check.text(list[i], "uri", where);
        if (check.failed()) return;
        if (size == 0) check.fail("{}.byteLength is missing or 0", where);
        std::string bytes;
        if (!uri.empty()) {
            bytes = buffer_bytes(check, uri, where);
        } else if (i == 0 && binary) {
            bytes = *binary;
        } else {
            check.fail("{} has neither a URI nor the GLB's binary chunk", where);
        }
        if (check.failed()) return;
        if (bytes.size() < size) {
            check.fail("{} has {} bytes; its byteLength says {}", where, bytes.size(), size);
        }
        check.buffer_bytes += size;
        if (check.buffer_bytes > limits::kModelFileBytes) {
            check.fail("its buffers have more than {} bytes", limits::kModelFileBytes);
        }
        bytes.resize(size);
        check.buffers.push_back(std::move(bytes));
        check.clean["buffers"].push_back(
            Json{{"byteLength", size}, {"uri", fmt::format("buffer{}.bin", i)}});
    }
}

void check_views(GltfCheck& check) {
    const Json& list = check.objects("bufferViews", kMaxViews);
    for (std::size_t i = 0; i < list.size() && !check.failed(); ++i) {
        const std::string where = fmt::format("bufferViews[{}]", i);
        const auto buffer = check.index(list[i], "buffer", where, check.buffers.size());
        GltfView view{.offset = check.whole(list[i], "byteOffset", where).value_or(0),
                      .size = check.whole(list[i], "byteLength", where).value_or(0),
                      .stride = check.whole(list[i], "byteStride", where).value_or(0)};
        if (check.failed()) return;
        if (!buffer) {
            check.fail("{} names no buffer", where);
            return;
        }
        view.buffer = *buffer;
        const std::size_t available = check.buffers[view.buffer].size();
        if (view.size == 0 || view.offset > available || view.size > available - view.offset) {
            check.fail("{} runs past its buffer: {} bytes from {} of {}",
                       where,
                       view.size,
                       view.offset,
                       available);
        }
        if (view.stride != 0 && (view.stride < 4 || view.stride > 252 || view.stride % 4 != 0)) {
            check.fail(
                "{}.byteStride is {}; 4 to 252 in steps of 4 are allowed", where, view.stride);
        }
        Json clean{{"buffer", view.buffer}, {"byteOffset", view.offset}, {"byteLength", view.size}};
        if (view.stride != 0) clean["byteStride"] = view.stride;
        check.clean["bufferViews"].push_back(std::move(clean));
        check.views.push_back(view);
    }
}

void check_accessors(GltfCheck& check) {
    const Json& list = check.objects("accessors", limits::kModelAccessors);
    for (std::size_t i = 0; i < list.size() && !check.failed(); ++i) {
        const std::string where = fmt::format("accessors[{}]", i);
        GltfAccessor accessor{
            .view = check.index(list[i], "bufferView", where, check.views.size()),
            .offset = check.whole(list[i], "byteOffset", where).value_or(0),
            .count = check.whole(list[i], "count", where).value_or(0),
            .component = static_cast<unsigned>(std::min<std::size_t>(
                check.whole(list[i], "componentType", where).value_or(0), 0xFFFFU)),
            .type = check.text(list[i], "type", where),
            .normalized = list[i].value("normalized", Json(false)) == Json(true),
            .sparse = list[i].contains("sparse")};
        if (check.failed()) return;
        if (element_bytes(accessor) == 0) {
            check.fail("{}: componentType {} of type \"{}\" is unknown",
                       where,
                       accessor.component,
                       accessor.type);
            return;
        }
        if (accessor.count < 1 || accessor.count > limits::kIndices) {
            check.fail("{}.count is {}; 1 to {} are read", where, accessor.count, limits::kIndices);
            return;
        }
        check_extent(check, accessor, where);
        if (accessor.sparse && !check.failed()) {
            check_sparse(check, list[i]["sparse"], accessor, where + ".sparse");
        }
        if (check.failed()) return;
        if (!accessor.view || accessor.sparse) make_dense(check, accessor, list[i], where);
        if (check.failed()) return;
        check.clean["accessors"].push_back(Json{{"bufferView", *accessor.view},
                                                {"byteOffset", accessor.offset},
                                                {"componentType", accessor.component},
                                                {"count", accessor.count},
                                                {"type", accessor.type},
                                                {"normalized", accessor.normalized}});
        check.accessors.push_back(std::move(accessor));
    }
}

}  // namespace plumbline::assets

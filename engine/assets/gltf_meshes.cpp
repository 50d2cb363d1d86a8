#include "engine/assets/gltf_check_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <cstring>

namespace plumbline::assets {
namespace {

enum class Mode : std::size_t { Triangles = 4, TriangleStrip = 5, TriangleFan = 6 };

struct MeshKeep {
    Json primitives = Json::array();
    std::size_t vertices{0};
    std::size_t indices{0};
};

/// Why one primitive's faces cannot be trusted; empty when they can. These cost the primitive,
/// not the file.
std::string index_fault(const GltfCheck& check, const GltfAccessor& indices, std::size_t vertices) {
    if (indices.type != "SCALAR" ||
        (indices.component != 5121 && indices.component != 5123 && indices.component != 5125)) {
        return "its indices are not whole numbers";
    }
    const GltfView& view = check.views[*indices.view];
    const std::size_t stride = view.stride == 0 ? element_bytes(indices) : view.stride;
    const std::string& bytes = check.buffers[view.buffer];
    const std::size_t first = view.offset + indices.offset;
    for (std::size_t i = 0; i < indices.count; ++i) {
        const std::uint32_t index = unsigned_at(bytes, first + i * stride, indices.component);
        if (index >= vertices) {
            return fmt::format("index {} names vertex {} of {}", i, index, vertices);
        }
    }
    return {};
}

/// Texture coordinates stored as 8 or 16 bits, written out as floats.
std::size_t float_texture_coordinates(GltfCheck& check, const GltfAccessor& source) {
    const GltfView& view = check.views[*source.view];
    const std::size_t stride = view.stride == 0 ? element_bytes(source) : view.stride;
    const std::size_t component_size = element_bytes(source) / 2;
    const float scale = source.component == 5121 ? 1.0F / 255.0F : 1.0F / 65'535.0F;
    std::string bytes(source.count * 2 * sizeof(float), '\0');
    for (std::size_t i = 0; i < source.count * 2; ++i) {
        const std::size_t place =
            view.offset + source.offset + (i / 2) * stride + (i % 2) * component_size;
        const float value = scale * static_cast<float>(unsigned_at(
                                        check.buffers[view.buffer], place, source.component));
        std::memcpy(bytes.data() + i * sizeof(float), &value, sizeof(float));
    }
    const std::size_t count = source.count;
    GltfAccessor made{.view = add_buffer(check, std::move(bytes)),
                      .count = count,
                      .component = 5126,
                      .type = "VEC2"};
    check.clean["accessors"].push_back(Json{{"bufferView", *made.view},
                                            {"componentType", made.component},
                                            {"count", made.count},
                                            {"type", made.type}});
    check.accessors.push_back(std::move(made));
    return check.accessors.size() - 1;
}

bool has_known_form(const GltfAccessor& accessor, std::string_view attribute) {
    const bool is_float = accessor.component == 5126;
    const bool is_scaled =
        accessor.normalized && (accessor.component == 5121 || accessor.component == 5123);
    if (attribute == "TEXCOORD_0") return accessor.type == "VEC2" && (is_float || is_scaled);
    if (attribute == "COLOR_0") {
        return (accessor.type == "VEC3" || accessor.type == "VEC4") && (is_float || is_scaled);
    }
    return accessor.type == "VEC3" && is_float;
}

/// The attributes that are kept, by number of their accessor.
Json kept_attributes(GltfCheck& check, const Json& source, const std::string& where) {
    Json kept = Json::object();
    std::size_t vertices = 0;
    for (const char* attribute : {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"}) {
        const auto number = check.index(source, attribute, where, check.accessors.size());
        if (check.failed()) return kept;
        if (!number) continue;
        const GltfAccessor accessor = check.accessors[*number];
        if (!has_known_form(accessor, attribute)) {
            log_warning("model {}: {}.{} is left out: {} of component type {} is not read",
                        check.name,
                        where,
                        attribute,
                        accessor.type,
                        accessor.component);
            continue;
        }
        if (kept.empty()) vertices = accessor.count;
        if (accessor.count != vertices) {
            check.fail(
                "{}.{} has {} elements, POSITION {}", where, attribute, accessor.count, vertices);
            return kept;
        }
        const bool expand = attribute[0] == 'T' && accessor.component != 5126;
        kept[attribute] = expand ? float_texture_coordinates(check, accessor) : *number;
    }
    return kept;
}

/// Triangles that `elements` indices or vertices give, times 3.
std::size_t triangle_corners(Mode mode, std::size_t elements) {
    if (mode == Mode::Triangles) return elements - elements % 3;
    return elements < 3 ? 0 : (elements - 2) * 3;
}

void keep_primitive(GltfCheck& check,
                    const Json& source,
                    const std::string& where,
                    MeshKeep& keep) {
    const auto leave_out = [&](std::string_view why) {
        log_warning("model {}: {} is left out: {}", check.name, where, why);
    };
    if (!source.is_object() || !source.contains("attributes") ||
        !source["attributes"].is_object()) {
        check.fail("{} has no attributes", where);
        return;
    }
    const std::size_t mode_number = check.whole(source, "mode", where).value_or(4);
    const auto material = check.index(source, "material", where, check.materials.size());
    const auto indices = check.index(source, "indices", where, check.accessors.size());
    if (check.failed()) return;
    if (mode_number > 6) {
        check.fail("{}.mode is {}; 0 to 6 are known", where, mode_number);
        return;
    }
    if (mode_number < 4) return leave_out("it holds points or lines");
    const Json attributes = kept_attributes(check, source["attributes"], where);
    if (check.failed()) return;
    if (!attributes.contains("POSITION")) return leave_out("it has no positions");
    if (source.contains("targets")) {
        log_note(
            "model {}: {} keeps its rest shape; morph targets are not read", check.name, where);
    }
    const std::size_t vertices = check.accessors[attributes["POSITION"].get<std::size_t>()].count;
    if (indices) {
        const std::string fault = index_fault(check, check.accessors[*indices], vertices);
        if (!fault.empty()) return leave_out(fault);
    }
    const auto mode = static_cast<Mode>(mode_number);
    keep.vertices += vertices;
    keep.indices += triangle_corners(mode, indices ? check.accessors[*indices].count : vertices);
    Json primitive{{"attributes", attributes}, {"mode", mode_number}};
    if (indices) primitive["indices"] = *indices;
    if (material) primitive["material"] = *material;
    keep.primitives.push_back(std::move(primitive));
}

}  // namespace

void check_meshes(GltfCheck& check) {
    const Json& list = check.objects("meshes", limits::kModelMeshes);
    for (std::size_t i = 0; i < list.size() && !check.failed(); ++i) {
        const std::string where = fmt::format("meshes[{}]", i);
        const Json& primitives = check.array(list[i], "primitives", where);
        MeshKeep keep;
        if (primitives.size() > limits::kModelMeshes) {
            check.fail("{} has {} primitives", where, primitives.size());
        }
        for (std::size_t k = 0; k < primitives.size() && !check.failed(); ++k) {
            keep_primitive(check, primitives[k], fmt::format("{}.primitives[{}]", where, k), keep);
        }
        check.vertex_counts.push_back(keep.vertices);
        check.index_counts.push_back(keep.indices);
        const std::string name = check.text(list[i], "name", where);
        check.clean["meshes"].push_back(Json{{"name", name.empty() ? fmt::format("{}", i) : name},
                                             {"primitives", std::move(keep.primitives)}});
    }
}

}  // namespace plumbline::assets

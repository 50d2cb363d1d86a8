#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace plumbline::assets {
namespace {

enum class Mode : std::size_t { Triangles = 4, TriangleStrip = 5, TriangleFan = 6 };

constexpr std::size_t kMaxTargets = 256;

/// A primitive's faces; `unusable` says why they cannot be trusted. That costs the primitive, not the file.
std::vector<std::uint32_t> indices_of(const GltfReader& reader,
                                      const GltfAccessor& accessor,
                                      std::size_t vertices,
                                      std::string& unusable) {
    if (accessor.type != "SCALAR" || !is_whole(accessor.component)) {
        unusable = "its indices are not whole numbers";
        return {};
    }
    const GltfElements from = elements_of(reader, accessor);
    std::vector<std::uint32_t> indices(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        indices[i] = unsigned_at(from.bytes, from.place(i), accessor.component);
        if (indices[i] < vertices) continue;
        unusable = fmt::format("index {} names vertex {} of {}", i, indices[i], vertices);
        return {};
    }
    return indices;
}

/// Strips and fans as triangles; what is left over of an incomplete one is dropped.
std::vector<std::uint32_t> as_triangles(Mode mode, std::vector<std::uint32_t> corners) {
    if (mode == Mode::Triangles) {
        corners.resize(corners.size() - corners.size() % 3);
        return corners;
    }
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        if (mode == Mode::TriangleFan) {
            triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
        } else if (i % 2 == 0) {
            triangles.insert(triangles.end(), {corners[i - 2], corners[i - 1], corners[i]});
        } else {
            triangles.insert(triangles.end(), {corners[i - 1], corners[i - 2], corners[i]});
        }
    }
    return triangles;
}

/// Whole numbers stand for positions and normals in files with KHR_mesh_quantization.
bool has_known_form(const GltfAccessor& accessor, std::string_view attribute) {
    const bool is_float = accessor.component == 5126;
    const bool is_small = accessor.component >= 5120 && accessor.component <= 5123;
    if (attribute.starts_with("TEXCOORD_"))
        return accessor.type == "VEC2" && (is_float || is_small);
    if (attribute == "COLOR_0") {
        const bool is_scaled = accessor.normalized && is_whole(accessor.component);
        return (accessor.type == "VEC3" || accessor.type == "VEC4") && (is_float || is_scaled);
    }
    if (attribute == "_WIND") return accessor.type == "VEC4" && is_float;
    if (attribute == "JOINTS_0") return accessor.type == "VEC4" && is_whole(accessor.component);
    if (attribute == "WEIGHTS_0") return accessor.type == "VEC4" && (is_float || is_small);
    return accessor.type == "VEC3" && (is_float || is_small);
}

/// The numbers of one attribute; empty when it is absent or (a warning) of a form not read.
std::vector<float> attribute_of(GltfReader& reader,
                                const GltfObject& attributes,
                                const std::string& key,
                                std::size_t vertices) {
    const auto number = attributes.index(key.c_str(), reader.accessors.size());
    if (!number) return {};
    const GltfAccessor& accessor = reader.accessors[*number];
    if (!has_known_form(accessor, key)) {
        log_warning("model {}: {}.{} is left out: {} of component type {} is not read",
                    reader.name,
                    attributes.where,
                    key,
                    accessor.type,
                    accessor.component);
        return {};
    }
    if (vertices > 0 && accessor.count != vertices) {
        fail("{}.{} has {} elements, POSITION {}", attributes.where, key, accessor.count, vertices);
    }
    return floats_of(reader, accessor);
}

std::vector<Vec3f> vectors_of(const std::vector<float>& numbers) {
    std::vector<Vec3f> vectors(numbers.size() / 3);
    if (!vectors.empty())
        std::memcpy(vectors.data(), numbers.data(), vectors.size() * sizeof(Vec3f));
    return vectors;
}

Vec2f placed(const GltfTexturePlace& place, Vec2f uv) {
    uv *= place.scale;
    if (place.rotation_rad != 0.0F) {
        const float sine = std::sin(place.rotation_rad);
        const float cosine = std::cos(place.rotation_rad);
        uv = {cosine * uv.x + sine * uv.y, cosine * uv.y - sine * uv.x};
    }
    return uv + place.offset;
}

/// Sway, phase and flutter from 0 to 1, as our own plants have them in the attribute _WIND.
WindWeights wind_of(const float* weights) {
    const auto byte = [](float weight) {
        const float share = std::isfinite(weight) ? std::clamp(weight, 0.0F, 1.0F) : 0.0F;
        return static_cast<std::uint8_t>(std::lround(share * 255.0F));
    };
    return {.sway = byte(weights[0]), .phase = byte(weights[1]), .flutter = byte(weights[2])};
}

void read_influences(GltfReader& reader, const GltfObject& attributes, ModelMesh& mesh) {
    const std::size_t count = mesh.vertices.size();
    const std::vector<float> joints = attribute_of(reader, attributes, "JOINTS_0", count);
    const std::vector<float> weights = attribute_of(reader, attributes, "WEIGHTS_0", count);
    if (joints.empty() || weights.empty()) return;
    mesh.influences.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        JointInfluence& influence = mesh.influences[i];
        float sum = 0.0F;
        for (std::size_t k = 0; k < 4; ++k) {
            const float weight = weights[i * 4 + k];
            influence.weights[k] = std::isfinite(weight) ? std::clamp(weight, 0.0F, 1.0F) : 0.0F;
            sum += influence.weights[k];
            influence.joints[k] =
                static_cast<std::uint16_t>(std::min(joints[i * 4 + k], 65'535.0F));
        }
        for (float& weight : influence.weights) weight = sum > 0.0F ? weight / sum : 0.0F;
    }
}

void read_targets(GltfReader& reader, const GltfObject& source, ModelMesh& mesh) {
    const Json& targets = source.array("targets");
    if (targets.size() > kMaxTargets) {
        fail("{} has {} targets; at most {} are read", source.where, targets.size(), kMaxTargets);
    }
    const std::size_t count = mesh.vertices.size();
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const GltfObject attributes = object_at(targets, t, source.where + ".targets");
        MorphTarget target{
            .positions = vectors_of(attribute_of(reader, attributes, "POSITION", count)),
            .normals = vectors_of(attribute_of(reader, attributes, "NORMAL", count))};
        if (target.positions.empty()) target.positions.resize(count, Vec3f{0.0F});
        for (Vec3f& offset : target.positions) {
            if (!is_finite(offset)) offset = Vec3f{0.0F};
        }
        mesh.targets.push_back(std::move(target));
    }
}

/// Positions and what goes with them; why they are of no use, or nothing.
std::string read_vertices(GltfReader& reader,
                          const GltfObject& attributes,
                          const GltfTexturePlace& place,
                          ModelMesh& mesh) {
    const std::vector<float> positions = attribute_of(reader, attributes, "POSITION", 0);
    if (positions.empty()) return "it has no positions";
    const std::size_t count = positions.size() / 3;
    const std::string uv_name = fmt::format("TEXCOORD_{}", place.set);
    const std::vector<float> normals = attribute_of(reader, attributes, "NORMAL", count);
    const std::vector<float> uvs = attribute_of(reader, attributes, uv_name, count);
    const std::vector<float> colors = attribute_of(reader, attributes, "COLOR_0", count);
    const std::size_t color_width = colors.size() / count;
    const std::vector<float> winds = attribute_of(reader, attributes, "_WIND", count);
    mesh.vertices.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Vertex& vertex = mesh.vertices[i];
        if (!winds.empty()) vertex.wind = wind_of(&winds[i * 4]);
        vertex.position_body = {positions[i * 3], positions[i * 3 + 1], positions[i * 3 + 2]};
        vertex.normal_body = Vec3f{0.0F};
        if (!normals.empty()) {
            vertex.normal_body = {normals[i * 3], normals[i * 3 + 1], normals[i * 3 + 2]};
        }
        if (!uvs.empty() && std::isfinite(uvs[i * 2]) && std::isfinite(uvs[i * 2 + 1])) {
            vertex.uv = placed(place, {uvs[i * 2], uvs[i * 2 + 1]});
        }
        if (!colors.empty()) {
            const float* color = &colors[i * color_width];
            const Vec3f rgb{color[0], color[1], color[2]};
            if (is_finite(rgb)) vertex.color = glm::max(rgb, Vec3f{0.0F});
        }
        if (!is_finite(vertex.position_body)) {
            return fmt::format("its vertex {} is not finite", i);
        }
    }
    return {};
}

/// The material's number; meshes without one share a plain one, made here.
std::uint32_t material_of(GltfReader& reader, std::optional<std::size_t> number) {
    if (number) return static_cast<std::uint32_t>(*number);
    std::vector<MaterialData>& materials = reader.model.materials;
    if (materials.size() == reader.texture_places.size()) materials.push_back({.name = "default"});
    return static_cast<std::uint32_t>(materials.size() - 1);
}

/// Whether the mesh's colours say anything; a material with maps shows them only if so.
void note_colors(GltfReader& reader, const ModelMesh& mesh) {
    const bool colored =
        std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vertex& vertex) {
            return vertex.color != Vec3f{1.0F};
        });
    if (colored) reader.model.materials[mesh.material].vertex_colors = true;
}

/// Adds one primitive to the model's meshes and its number to `parts`.
void read_primitive(GltfReader& reader,
                    const GltfObject& source,
                    const std::string& name,
                    std::vector<std::uint32_t>& parts) {
    const auto leave_out = [&](std::string_view why) {
        log_warning("model {}: {} is left out: {}", reader.name, source.where, why);
    };
    const auto found = source.json.find("attributes");
    if (found == source.json.end() || !found->is_object()) {
        fail("{} has no attributes", source.where);
    }
    const GltfObject attributes{.json = *found, .where = source.where};
    const std::size_t mode_number = source.whole("mode").value_or(4);
    const auto material = source.index("material", reader.texture_places.size());
    const auto indices = source.index("indices", reader.accessors.size());
    if (mode_number > 6) fail("{}.mode is {}; 0 to 6 are known", source.where, mode_number);
    if (mode_number < 4) return leave_out("it holds points or lines");
    ModelMesh mesh{.name = name};
    const GltfTexturePlace place = material ? reader.texture_places[*material] : GltfTexturePlace{};
    std::string unusable = read_vertices(reader, attributes, place, mesh);
    std::vector<std::uint32_t> corners(mesh.vertices.size());
    std::iota(corners.begin(), corners.end(), 0U);
    if (unusable.empty() && indices) {
        corners = indices_of(reader, reader.accessors[*indices], corners.size(), unusable);
    }
    if (!unusable.empty()) return leave_out(unusable);
    mesh.indices = as_triangles(static_cast<Mode>(mode_number), std::move(corners));
    mesh.material = material_of(reader, material);
    read_influences(reader, attributes, mesh);
    read_targets(reader, source, mesh);
    note_colors(reader, mesh);
    parts.push_back(static_cast<std::uint32_t>(reader.model.meshes.size()));
    reader.model.meshes.push_back(std::move(mesh));
}

/// What a file may hold in all before instances are counted.
void check_size(const GltfReader& reader) {
    std::size_t vertices = 0;
    std::size_t indices = 0;
    for (const ModelMesh& mesh : reader.model.meshes) {
        vertices += mesh.vertices.size();
        indices += mesh.indices.size();
    }
    if (vertices > limits::kVertices) {
        fail("its meshes have {} vertices; at most {} are read", vertices, limits::kVertices);
    }
    if (indices > limits::kIndices) {
        fail("its meshes have {} indices; at most {} are read", indices, limits::kIndices);
    }
}

}  // namespace

void read_meshes(GltfReader& reader) {
    for (const GltfObject& source : reader.objects("meshes", limits::kModelMeshes)) {
        const Json& primitives = source.array("primitives");
        std::string name = source.text("name");
        if (name.empty()) name = fmt::format("{}", reader.mesh_parts.size());
        if (primitives.size() > limits::kModelMeshes) {
            fail("{} has {} primitives", source.where, primitives.size());
        }
        std::vector<std::uint32_t> parts;
        for (std::size_t k = 0; k < primitives.size(); ++k) {
            const std::string place = fmt::format("{}.primitives[{}]", source.where, k);
            read_primitive(reader, {.json = primitives[k], .where = place}, name, parts);
            check_size(reader);
        }
        reader.mesh_weights.push_back(source.numbers("weights", source.array("weights").size()));
        reader.mesh_parts.push_back(std::move(parts));
    }
}

}  // namespace plumbline::assets

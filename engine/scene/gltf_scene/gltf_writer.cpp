#include "engine/scene/gltf_scene/gltf_writer_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace plumbline::scene {
namespace {

using Json = nlohmann::json;

// GL's numbers, as glTF has them.
constexpr int kFloat = 5126;
constexpr int kUnsigned = 5125;
constexpr int kVertexBuffer = 34962;
constexpr int kIndexBuffer = 34963;

Json floats(const Vec3f& v) {
    return {v.x, v.y, v.z};
}

/// A Blinn-Phong exponent as a roughness (Walter et al. 2007: alpha^2 = 2 / (n + 2), and alpha = roughness^2).
float roughness_of(const assets::MaterialData& material) {
    if (material.shininess <= 0.0F) return material.roughness;
    return std::sqrt(std::sqrt(2.0F / (material.shininess + 2.0F)));
}

void pad(std::string& bytes, char with) {
    bytes.resize((bytes.size() + 3) / 4 * 4, with);
}

void append_u32(std::string& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<char>((value >> shift) & 0xFFU));
}

/// A field of all vertices, one after the other.
template <class T, class Field>
std::vector<T> column_of(const assets::MeshData& mesh, Field field) {
    std::vector<T> column;
    column.reserve(mesh.vertices.size());
    for (const assets::Vertex& vertex : mesh.vertices) column.push_back(field(vertex));
    return column;
}

}  // namespace

std::size_t GltfWriter::add_view(const void* bytes, std::size_t size, std::optional<int> target) {
    pad(binary_, '\0');
    Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
    if (target) view["target"] = *target;
    binary_.append(static_cast<const char*>(bytes), size);
    json["bufferViews"].push_back(std::move(view));
    return json["bufferViews"].size() - 1;
}

std::size_t GltfWriter::add_accessor(std::size_t view,
                                     int component,
                                     const char* type,
                                     std::size_t count) {
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"type", type}, {"count", count}});
    return json["accessors"].size() - 1;
}

std::size_t GltfWriter::add_positions(const std::vector<Vec3f>& positions) {
    const std::size_t view =
        add_view(positions.data(), positions.size() * sizeof(Vec3f), kVertexBuffer);
    const std::size_t accessor = add_accessor(view, kFloat, "VEC3", positions.size());
    Vec3f min = positions.front();
    Vec3f max = positions.front();
    for (const Vec3f& position : positions) {
        min = glm::min(min, position);
        max = glm::max(max, position);
    }
    json["accessors"][accessor]["min"] = floats(min);
    json["accessors"][accessor]["max"] = floats(max);
    return accessor;
}

std::size_t GltfWriter::add_indices(std::span<const std::uint32_t> indices) {
    const std::size_t view = add_view(indices.data(), indices.size_bytes(), kIndexBuffer);
    return add_accessor(view, kUnsigned, "SCALAR", indices.size());
}

std::size_t GltfWriter::add_mesh(const assets::MeshData& mesh,
                                 std::span<const std::size_t> materials) {
    const auto add = [&](const auto& column, const char* type) {
        const std::size_t view =
            add_view(column.data(), column.size() * sizeof(column.front()), kVertexBuffer);
        return add_accessor(view, kFloat, type, column.size());
    };
    Json attributes;
    attributes["POSITION"] = add_positions(
        column_of<Vec3f>(mesh, [](const assets::Vertex& v) { return v.position_body; }));
    attributes["NORMAL"] =
        add(column_of<Vec3f>(mesh, [](const assets::Vertex& v) { return v.normal_body; }), "VEC3");
    attributes["TANGENT"] =
        add(column_of<Vec4f>(mesh, [](const assets::Vertex& v) { return v.tangent_body; }), "VEC4");
    attributes["TEXCOORD_0"] =
        add(column_of<Vec2f>(mesh, [](const assets::Vertex& v) { return v.uv; }), "VEC2");
    const auto colors = column_of<Vec3f>(mesh, [](const assets::Vertex& v) { return v.color; });
    const bool white = std::ranges::all_of(colors, [](const Vec3f& c) { return c == Vec3f{1.0F}; });
    if (!white) attributes["COLOR_0"] = add(colors, "VEC3");
    Json primitives = Json::array();
    for (const assets::SubMesh& run : mesh.sub_meshes) {
        Json primitive{
            {"attributes", attributes},
            {"indices",
             add_indices(std::span(mesh.indices).subspan(run.first_index, run.index_count))}};
        if (run.material < materials.size()) primitive["material"] = materials[run.material];
        primitives.push_back(std::move(primitive));
    }
    json["meshes"].push_back({{"primitives", std::move(primitives)}});
    return json["meshes"].size() - 1;
}

std::size_t GltfWriter::add_triangles(const std::vector<Vec3f>& positions,
                                      const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<std::uint32_t> indices;
    indices.reserve(triangles.size() * 3);
    for (const auto& corners : triangles)
        indices.insert(indices.end(), corners.begin(), corners.end());
    Json primitive{{"attributes", {{"POSITION", add_positions(positions)}}},
                   {"indices", add_indices(indices)}};
    json["meshes"].push_back({{"primitives", Json::array({std::move(primitive)})}});
    return json["meshes"].size() - 1;
}

std::optional<std::size_t> GltfWriter::add_texture(const std::filesystem::path& map) {
    if (map.empty()) return {};
    if (const auto known = textures_.find(map); known != textures_.end()) return known->second;
    std::optional<std::size_t>& texture = textures_[map];
    const std::string bytes = read_image_(map);
    const bool is_png = bytes.starts_with("\x89PNG");
    if (!is_png && !bytes.starts_with("\xFF\xD8\xFF")) {
        notes_.push_back(
            fmt::format("the image {} is left out: glTF takes PNG and JPEG", map.string()));
        return texture;
    }
    const std::size_t view = add_view(bytes.data(), bytes.size(), {});
    json["images"].push_back({{"bufferView", view},
                              {"mimeType", is_png ? "image/png" : "image/jpeg"},
                              {"name", map.stem().string()}});
    json["textures"].push_back({{"source", json["images"].size() - 1}});
    texture = json["textures"].size() - 1;
    return texture;
}

std::size_t GltfWriter::add_material(const assets::MaterialData& material) {
    const auto same = [&](const auto& known) { return known.first == material; };
    const auto known = std::ranges::find_if(materials_, same);
    if (known != materials_.end()) return known->second;
    Json surface{{"metallicFactor", material.metallic},
                 {"roughnessFactor", roughness_of(material)}};
    const Vec3f& color = material.base_color;
    surface["baseColorFactor"] = {
        std::min(color.x, 1.0F), std::min(color.y, 1.0F), std::min(color.z, 1.0F), material.alpha};
    Json out{{"name", material.name}};
    if (const auto map = add_texture(material.base_color_map))
        surface["baseColorTexture"] = {{"index", *map}};
    if (const auto map = add_texture(material.orm_map)) {
        surface["metallicRoughnessTexture"] = {{"index", *map}};
        out["occlusionTexture"] = {{"index", *map}, {"strength", material.occlusion}};
    }
    if (const auto map = add_texture(material.normal_map)) out["normalTexture"] = {{"index", *map}};
    if (const auto map = add_texture(material.emissive_map))
        out["emissiveTexture"] = {{"index", *map}};
    const float brightest =
        std::max({material.emissive.x, material.emissive.y, material.emissive.z});
    if (brightest > 0.0F)
        out["emissiveFactor"] = floats(material.emissive / std::max(brightest, 1.0F));
    if (brightest > 1.0F) {
        use("KHR_materials_emissive_strength");
        out["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", brightest}};
    }
    if (material.shading == assets::Shading::Unlit) {
        use("KHR_materials_unlit");
        out["extensions"]["KHR_materials_unlit"] = Json::object();
    }
    constexpr std::array<const char*, 3> kModes{"OPAQUE", "MASK", "BLEND"};
    out["alphaMode"] = kModes.at(static_cast<std::size_t>(material.alpha_mode));
    if (material.alpha_mode == assets::AlphaMode::Mask) out["alphaCutoff"] = material.alpha_cutoff;
    out["doubleSided"] = material.two_sided;
    out["pbrMetallicRoughness"] = std::move(surface);
    json["materials"].push_back(std::move(out));
    materials_.emplace_back(material, json["materials"].size() - 1);
    return materials_.back().second;
}

std::size_t GltfWriter::add_node(Json node, bool in_scene) {
    json["nodes"].push_back(std::move(node));
    if (!in_scene) outside_.insert(json["nodes"].size() - 1);
    return json["nodes"].size() - 1;
}

void GltfWriter::use(const std::string& extension) {
    Json& used = json["extensionsUsed"];
    if (std::ranges::find(used, Json(extension)) == used.end()) used.push_back(extension);
}

std::string GltfWriter::glb() {
    const std::size_t count = json.contains("nodes") ? json["nodes"].size() : 0;
    std::vector<bool> is_child(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        for (const Json& child : json["nodes"][i].value("children", Json::array()))
            is_child[child.get<std::size_t>()] = true;
    }
    Json roots = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
        if (!is_child[i] && !outside_.contains(i)) roots.push_back(i);
    }
    json["scenes"] = Json::array({{{"nodes", std::move(roots)}}});
    json["scene"] = 0;
    pad(binary_, '\0');
    if (!binary_.empty()) json["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    pad(text, ' ');
    std::string file = "glTF";
    append_u32(file, 2);
    append_u32(file, 12 + 8 + text.size() + (binary_.empty() ? 0 : 8 + binary_.size()));
    append_u32(file, text.size());
    file += "JSON" + text;
    if (binary_.empty()) return file;
    append_u32(file, binary_.size());
    file += std::string("BIN\0", 4) + binary_;
    return file;
}

}  // namespace plumbline::scene

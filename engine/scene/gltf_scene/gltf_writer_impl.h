// A .glb in the making: meshes, materials and images by number, nodes as the caller writes them. Internal to the scene
// module.
#pragma once

#include "engine/assets/material_data.h"
#include "engine/assets/mesh_data.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace plumbline::scene {

class GltfWriter {
public:
    /// Bytes of an image file; an empty text where there is none.
    using ReadImage = std::function<std::string(const std::filesystem::path&)>;
    explicit GltfWriter(ReadImage read_image) : read_image_(std::move(read_image)) {}

    /// The document's top level; who writes nodes puts them there.
    nlohmann::json json{{"asset", {{"version", "2.0"}, {"generator", "Plumbline"}}}};

    /// Metal and roughness as they are; highlights of other shadings by their nearest roughness. Equal materials are one.
    std::size_t add_material(const assets::MaterialData& material);
    /// A primitive for each sub-mesh, with the material of that number in `materials`.
    std::size_t add_mesh(const assets::MeshData& mesh, std::span<const std::size_t> materials);
    /// Positions alone: what collides and is not seen.
    std::size_t add_triangles(const std::vector<Vec3f>& positions,
                              const std::vector<std::array<std::uint32_t, 3>>& triangles);
    /// One outside the scene is there to be named only.
    std::size_t add_node(nlohmann::json node, bool in_scene = true);
    /// A name in `extensionsUsed`.
    void use(const std::string& extension);

    /// The whole file. The scene consists of the nodes that no other one has as a child.
    std::string glb();

    /// What could not be written, for a person.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    std::size_t add_view(const void* bytes, std::size_t size, std::optional<int> target);
    std::size_t add_accessor(std::size_t view, int component, const char* type, std::size_t count);
    std::size_t add_positions(const std::vector<Vec3f>& positions);
    std::size_t add_indices(std::span<const std::uint32_t> indices);
    std::optional<std::size_t> add_texture(const std::filesystem::path& map);

    ReadImage read_image_;
    std::string binary_;
    std::set<std::size_t> outside_;  ///< nodes
    std::vector<std::pair<assets::MaterialData, std::size_t>> materials_;
    std::map<std::filesystem::path, std::optional<std::size_t>> textures_;
    std::vector<std::string> notes_;
};

}  // namespace plumbline::scene

// A mesh of cards, as a crown of leaves is.
#pragma once

#include "engine/assets/mesh_data.h"

#include <cstdint>
#include <vector>

namespace plumbline::render {

/// A square card of 10 cm, two triangles, from each of these corners along x and y.
inline assets::MeshData card_mesh(const std::vector<Vec3f>& corners_m) {
    assets::MeshData mesh;
    for (const Vec3f& at : corners_m) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vec3f& corner :
             {Vec3f{0, 0, 0}, Vec3f{0.1F, 0, 0}, Vec3f{0.1F, 0.1F, 0}, Vec3f{0, 0.1F, 0}}) {
            assets::Vertex vertex;
            vertex.position_body = at + corner;
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + k);
    }
    mesh.sub_meshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), 0}};
    mesh.bounds = assets::bounds_of(mesh);
    return mesh;
}

}  // namespace plumbline::render

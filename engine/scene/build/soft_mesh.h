// Triangles of a soft body: its outer faces, or those of a model that its cells carry along.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/physics/soft_body.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::scene {

/// Faces of one side share their normals; texture coordinates run over each face.
class SoftFaces {
public:
    explicit SoftFaces(const physics::SoftGrid& grid);
    const assets::MeshData& mesh() const { return mesh_; }
    void shape(std::span<const Vec3d> points_m, assets::MeshData& mesh) const;

private:
    std::vector<std::uint32_t> points_;  ///< by vertex
    assets::MeshData mesh_;
};

/// Vertices of a model, each with its place in the nearest cell.
class SoftModel {
public:
    /// `model` is in the grid's frame.
    SoftModel(const physics::SoftGrid& grid, const assets::MeshData& model);
    void shape(std::span<const Vec3d> points_m, assets::MeshData& mesh) const;

private:
    struct Place {
        std::array<std::uint32_t, 8> points{};
        std::array<float, 8> weights{};
    };
    std::vector<Place> places_;  ///< by vertex
};

/// Whether a place is inside a closed mesh: its rays along x meet an odd number of triangles.
bool is_inside(const assets::MeshData& mesh, const Vec3d& place);

}  // namespace plumbline::scene

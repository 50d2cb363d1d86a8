#include "engine/scene/build/soft_mesh.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace plumbline::scene {
namespace {

void finish(assets::MeshData& mesh) {
    assets::compute_normals(mesh);
    mesh.bounds = assets::bounds_of(mesh);
    ++mesh.version;
}

}  // namespace

SoftFaces::SoftFaces(const physics::SoftGrid& grid) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> vertices;  // by side and point
    for (const physics::SoftGrid::Face& face : grid.faces) {
        std::array<std::uint32_t, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [found, is_new] = vertices.try_emplace(
                {face.side, face.points[i]}, static_cast<std::uint32_t>(points_.size()));
            corners[i] = found->second;
            if (!is_new) continue;
            points_.push_back(face.points[i]);
            assets::Vertex vertex;
            vertex.position_body = Vec3f(grid.points_m[face.points[i]]);
            vertex.uv = {i == 1 || i == 2 ? 1.0F : 0.0F, i >= 2 ? 1.0F : 0.0F};
            mesh_.vertices.push_back(vertex);
        }
        for (const std::size_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh_.indices.push_back(corners[i]);
    }
    mesh_.sub_meshes = {{.first_index = 0,
                         .index_count = static_cast<std::uint32_t>(mesh_.indices.size()),
                         .material = 0}};
}

void SoftFaces::shape(std::span<const Vec3d> points_m, assets::MeshData& mesh) const {
    for (std::size_t i = 0; i < points_.size(); ++i)
        mesh.vertices[i].position_body = Vec3f(points_m[points_[i]]);
    finish(mesh);
}

SoftModel::SoftModel(const physics::SoftGrid& grid, const assets::MeshData& model) {
    for (const assets::Vertex& vertex : model.vertices) {
        const Vec3d at(vertex.position_body);
        const std::array<std::uint32_t, 8>* nearest = nullptr;
        double nearest_m = std::numeric_limits<double>::max();
        for (const std::array<std::uint32_t, 8>& cell : grid.cells) {
            const Vec3d middle = (grid.points_m[cell[0]] + grid.points_m[cell[7]]) / 2.0;
            const double away_m = glm::distance(middle, at);
            if (away_m >= nearest_m) continue;
            nearest_m = away_m;
            nearest = &cell;
        }
        Place& place = places_.emplace_back();
        if (nearest == nullptr) continue;
        place.points = *nearest;
        const Vec3d low = grid.points_m[(*nearest)[0]];
        const Vec3d share = (at - low) / (grid.points_m[(*nearest)[7]] - low);
        for (std::uint32_t i = 0; i < 8; ++i) {
            double weight = 1;
            for (int axis = 0; axis < 3; ++axis)
                weight *= (i >> static_cast<std::uint32_t>(axis) & 1U) != 0 ? share[axis]
                                                                            : 1 - share[axis];
            place.weights[i] = static_cast<float>(weight);
        }
    }
}

void SoftModel::shape(std::span<const Vec3d> points_m, assets::MeshData& mesh) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        Vec3f at{0.0F};
        for (std::size_t k = 0; k < 8; ++k)
            at += Vec3f(points_m[places_[i].points[k]]) * places_[i].weights[k];
        mesh.vertices[i].position_body = at;
    }
    finish(mesh);
}

bool is_inside(const assets::MeshData& mesh, const Vec3d& place) {
    bool inside = false;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<Vec3d, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = Vec3d(mesh.vertices[mesh.indices[i + k]].position_body) - place;
        // Signs of the areas that the edges make with the origin, seen along x.
        std::array<double, 3> areas{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& a = corners[(k + 1) % 3];
            const Vec3d& b = corners[(k + 2) % 3];
            areas[k] = a.y * b.z - a.z * b.y;
        }
        const bool all_left = areas[0] > 0 && areas[1] > 0 && areas[2] > 0;
        const bool all_right = areas[0] < 0 && areas[1] < 0 && areas[2] < 0;
        if (!all_left && !all_right) continue;
        const double x =
            (areas[0] * corners[0].x + areas[1] * corners[1].x + areas[2] * corners[2].x) /
            (areas[0] + areas[1] + areas[2]);
        if (x > 0) inside = !inside;
    }
    return inside;
}

}  // namespace plumbline::scene

#include "engine/assets/model/mesh_simplify.h"

#include <meshoptimizer.h>

#include <array>
#include <cstddef>
#include <span>

namespace plumbline::assets {
namespace {

/// The part of a mesh that some indices use, numbered by itself.
struct OwnVertices {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> colors;
    std::vector<std::uint32_t> in_mesh;  ///< by own number
    std::vector<std::uint32_t> indices;
};

OwnVertices own_vertices(const std::vector<Vertex>& vertices,
                         const std::vector<std::uint32_t>& indices) {
    constexpr std::uint32_t kNone = ~0U;
    std::vector<std::uint32_t> number(vertices.size(), kNone);
    OwnVertices own;
    own.indices.reserve(indices.size());
    for (const std::uint32_t index : indices) {
        if (number[index] == kNone) {
            number[index] = static_cast<std::uint32_t>(own.in_mesh.size());
            own.in_mesh.push_back(index);
            own.positions.push_back(vertices[index].position_body);
            own.colors.push_back(vertices[index].color);
        }
        own.indices.push_back(number[index]);
    }
    return own;
}

std::vector<std::uint32_t> collapsed(const std::vector<Vec3f>& positions,
                                     const std::vector<std::uint32_t>& indices,
                                     float error_m) {
    const float scale_m = meshopt_simplifyScale(&positions[0].x, positions.size(), sizeof(Vec3f));
    if (!(scale_m > 0.0F)) return indices;
    std::vector<std::uint32_t> fewer(indices.size());
    fewer.resize(meshopt_simplify(fewer.data(),
                                  indices.data(),
                                  indices.size(),
                                  &positions[0].x,
                                  positions.size(),
                                  sizeof(Vec3f),
                                  0,
                                  error_m / scale_m));
    return fewer;
}

/// Vertices by the place where they are; where colours meet are several.
class Places {
public:
    explicit Places(const OwnVertices& own) : place_of_(own.positions.size()) {
        const std::array<meshopt_Stream, 2> streams{
            {{own.positions.data(), sizeof(Vec3f), sizeof(Vec3f)},
             {own.colors.data(), sizeof(Vec3f), sizeof(Vec3f)}}};
        const std::size_t count = meshopt_generateVertexRemapMulti(place_of_.data(),
                                                                   own.indices.data(),
                                                                   own.indices.size(),
                                                                   own.positions.size(),
                                                                   streams.data(),
                                                                   streams.size());
        first_.resize(count + 1);
        for (const std::uint32_t place : place_of_) ++first_[place + 1];
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        there_.resize(own.positions.size());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t i = 0; i < place_of_.size(); ++i) there_[next[place_of_[i]]++] = i;
    }

    std::size_t count() const { return first_.size() - 1; }
    std::uint32_t of(std::uint32_t vertex) const { return place_of_[vertex]; }
    std::span<const std::uint32_t> vertices_at(std::uint32_t place) const {
        return std::span{there_}.subspan(first_[place], first_[place + 1] - first_[place]);
    }

private:
    std::vector<std::uint32_t> place_of_;  ///< by vertex
    std::vector<std::uint32_t> first_;     ///< by place, into there_
    std::vector<std::uint32_t> there_;
};

/// Where faces meet in sharp edges each has vertices of its own, and no edge can be collapsed: so the
/// places are collapsed, and each face takes of the vertices there those that face as it does.
std::vector<std::uint32_t> collapsed_places(const std::vector<Vertex>& vertices,
                                            const OwnVertices& own,
                                            float error_m) {
    const Places places(own);
    std::vector<Vec3f> positions(places.count());
    for (std::uint32_t i = 0; i < own.positions.size(); ++i)
        positions[places.of(i)] = own.positions[i];
    std::vector<std::uint32_t> corners;
    corners.reserve(own.indices.size());
    for (const std::uint32_t index : own.indices) corners.push_back(places.of(index));
    std::vector<std::uint32_t> fewer = collapsed(positions, corners, error_m);
    for (std::size_t i = 0; i + 2 < fewer.size(); i += 3) {
        const Vec3f& a = positions[fewer[i]];
        const Vec3f facing = glm::cross(positions[fewer[i + 1]] - a, positions[fewer[i + 2]] - a);
        for (std::size_t k = i; k < i + 3; ++k) {
            const auto there = places.vertices_at(fewer[k]);
            std::uint32_t best = there.front();
            const auto agrees = [&](std::uint32_t vertex) {
                return glm::dot(vertices[own.in_mesh[vertex]].normal_body, facing);
            };
            for (const std::uint32_t vertex : there)
                if (agrees(vertex) > agrees(best)) best = vertex;
            fewer[k] = best;
        }
    }
    return fewer;
}

}  // namespace

std::vector<std::uint32_t> simplified(const std::vector<Vertex>& vertices,
                                      const std::vector<std::uint32_t>& indices,
                                      float error_m) {
    if (indices.empty()) return indices;
    const OwnVertices own = own_vertices(vertices, indices);
    std::vector<std::uint32_t> fewer = collapsed(own.positions, own.indices, error_m);
    if (fewer.size() * 4 > indices.size() * 3) {
        std::vector<std::uint32_t> by_place = collapsed_places(vertices, own, error_m);
        if (by_place.size() < fewer.size()) fewer = std::move(by_place);
    }
    for (std::uint32_t& index : fewer) index = own.in_mesh[index];
    return fewer;
}

}  // namespace plumbline::assets

#include "engine/render/culling/mesh_lods.h"

#include "engine/assets/model/mesh_simplify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace plumbline::render {
namespace {

using assets::MeshData;
using assets::SubMesh;
using assets::Vertex;

constexpr std::size_t kCheapTriangles = 300;
/// A loose piece of foliage with no more triangles than this is a card.
constexpr std::uint32_t kCardTriangles = 32;
/// Where there are fewer cards than this each is seen by itself, and none may go.
constexpr std::size_t kManyCards = 300;

struct Detail {
    float error_share;  ///< of the mesh's diagonal
    float kept_cards;   ///< share
    float card_scale;   ///< the kept ones cover what all did, nearly
};
constexpr std::array<Detail, 6> kDetails{{{1.0F / 1200.0F, 1.0F, 1.0F},
                                          {1.0F / 600.0F, 1.0F, 1.0F},
                                          {1.0F / 300.0F, 0.4F, 1.45F},
                                          {1.0F / 150.0F, 0.25F, 1.7F},
                                          {1.0F / 75.0F, 0.15F, 2.0F},
                                          {1.0F / 37.0F, 0.09F, 2.5F}}};
/// Each version is made from the one before, which was off by half as much.
constexpr float kOwnShare = 0.5F;

/// Sets of vertices that triangles join.
class Pieces {
public:
    explicit Pieces(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> parent_;
};

struct Piece {
    std::uint32_t corners{0};
    Vec3f sum{0.0F};
};

/// Evenly spread over 0…1, the same for the same number.
float share_of(std::uint32_t number) {
    std::uint32_t h = number * 0x9E3779B9U;
    h ^= h >> 16U;
    h *= 0x85EBCA6BU;
    h ^= h >> 13U;
    return static_cast<float>(h >> 8U) / static_cast<float>(1U << 24U);
}

/// The loose pieces of which some triangles are made.
class Cards {
public:
    Cards(const MeshData& mesh, const std::vector<std::uint32_t>& indices)
        : joined_(mesh.vertices.size()) {
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            joined_.join(indices[i], indices[i + 1]);
            joined_.join(indices[i], indices[i + 2]);
        }
        for (const std::uint32_t index : indices) {
            Piece& piece = pieces_[joined_.find(index)];
            ++piece.corners;
            piece.sum += mesh.vertices[index].position_body;
        }
    }
    std::size_t count() const { return pieces_.size(); }
    /// A number that is the card's own, and what it is.
    std::pair<std::uint32_t, const Piece&> of(std::uint32_t index) {
        const std::uint32_t root = joined_.find(index);
        return {root, pieces_[root]};
    }

private:
    Pieces joined_;
    std::unordered_map<std::uint32_t, Piece> pieces_;
};

/// Appends a share of the cards in `indices`, enlarged, and all that is no card.
void append_cards(MeshData& mesh, const std::vector<std::uint32_t>& indices, const Detail& detail) {
    Cards cards(mesh, indices);
    std::unordered_map<std::uint32_t, std::uint32_t> enlarged;
    for (const std::uint32_t index : indices) {
        const auto [number, piece] = cards.of(index);
        if (piece.corners > 3 * kCardTriangles) {
            mesh.indices.push_back(index);
            continue;
        }
        if (share_of(number) > detail.kept_cards) continue;
        const auto [found, is_new] =
            enlarged.emplace(index, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (is_new) {
            Vertex vertex = mesh.vertices[index];
            const Vec3f center = piece.sum / static_cast<float>(piece.corners);
            vertex.position_body = center + (vertex.position_body - center) * detail.card_scale;
            mesh.vertices.push_back(vertex);
        }
        mesh.indices.push_back(found->second);
    }
}

bool has_colors(const MeshData& mesh, const std::vector<std::uint32_t>& indices) {
    return std::ranges::any_of(indices, [&](std::uint32_t index) {
        return mesh.vertices[index].color != mesh.vertices[indices.front()].color;
    });
}

/// The parts of a mesh on their way to the coarsest version.
class Coarser {
public:
    Coarser(MeshData& mesh, const std::vector<bool>& is_foliage) : mesh_(mesh) {
        for (const SubMesh& part : mesh.sub_meshes) {
            const auto first = mesh.indices.begin() + part.first_index;
            const std::size_t number = parts_.size();
            Part& own = parts_.emplace_back(
                Part{.indices = {first, first + part.index_count}, .drawn = part});
            const bool foliage = number < is_foliage.size() && is_foliage[number];
            own.thins_out = foliage && Cards(mesh, own.indices).count() >= kManyCards;
            own.stays = !foliage && has_colors(mesh, own.indices);
        }
    }

    /// Appends the next version.
    std::vector<SubMesh> add(const Detail& detail, float error_m) {
        std::vector<SubMesh> drawn;
        for (Part& part : parts_) {
            const bool thins_out = part.thins_out && detail.kept_cards < 1.0F;
            // Bent cards become flat; coarser than that they would vanish.
            const std::size_t before = part.indices.size();
            if (!thins_out && !part.stays)
                part.indices = assets::simplified(mesh_.vertices, part.indices, error_m);
            if (thins_out || part.indices.size() < before) {
                part.drawn.first_index = static_cast<std::uint32_t>(mesh_.indices.size());
                if (thins_out) {
                    append_cards(mesh_, part.indices, detail);
                } else {
                    mesh_.indices.insert(
                        mesh_.indices.end(), part.indices.begin(), part.indices.end());
                }
                part.drawn.index_count =
                    static_cast<std::uint32_t>(mesh_.indices.size()) - part.drawn.first_index;
            }
            drawn.push_back(part.drawn);
        }
        return drawn;
    }

private:
    struct Part {
        std::vector<std::uint32_t> indices;
        SubMesh drawn;
        bool thins_out{false};  ///< a crown of many cards
        bool stays{false};      ///< what is painted on vertices goes with them
    };
    MeshData& mesh_;
    std::vector<Part> parts_;
};

std::size_t index_count(const std::vector<SubMesh>& parts) {
    std::size_t count = 0;
    for (const SubMesh& part : parts) count += part.index_count;
    return count;
}

}  // namespace

std::vector<MeshLod> add_lods(MeshData& mesh, const std::vector<bool>& is_foliage) {
    if (mesh.indices.size() / 3 <= kCheapTriangles) return {};
    const float diagonal_m = glm::length(mesh.bounds.size());
    if (!(diagonal_m > 0.0F) || !std::isfinite(diagonal_m)) return {};
    std::vector<MeshLod> lods;
    Coarser coarser(mesh, is_foliage);
    std::size_t before = mesh.indices.size();
    for (const Detail& detail : kDetails) {
        const float error_m = diagonal_m * detail.error_share;
        std::vector<SubMesh> parts = coarser.add(detail, kOwnShare * error_m);
        // A version that saves little is not worth a change of image.
        if (index_count(parts) * 10 > before * 9) continue;
        before = index_count(parts);
        lods.push_back({.error_m = error_m, .sub_meshes = std::move(parts)});
    }
    return lods;
}

}  // namespace plumbline::render

#include "engine/render/mesh_lods.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <unordered_map>

namespace plumbline::render {
namespace {

using assets::MeshData;
using assets::SubMesh;
using assets::Vertex;

constexpr std::size_t kCheapTriangles = 300;
/// A loose piece of foliage with no more triangles than this is a card.
constexpr std::uint32_t kCardTriangles = 32;

/// Of the error, for what is no foliage: thin boards and tiles fall into their neighbours early.
constexpr float kCell = 0.6F;

struct Detail {
    float error_share;  ///< of the mesh's diagonal
    float kept_cards;   ///< share
    float card_scale;   ///< the kept ones cover what all did, nearly
};
constexpr std::array<Detail, 4> kDetails{{{1.0F / 300.0F, 0.4F, 1.45F},
                                          {1.0F / 150.0F, 0.25F, 1.7F},
                                          {1.0F / 75.0F, 0.15F, 2.0F},
                                          {1.0F / 37.0F, 0.09F, 2.5F}}};

std::uint64_t key_of(const Vec3f& position, float cell_m) {
    const auto part = [&](float value) {
        const auto cell = static_cast<std::int64_t>(std::floor(value / cell_m));
        return static_cast<std::uint64_t>(cell) & 0x7FFFFU;
    };
    return part(position.x) | part(position.y) << 19U | part(position.z) << 38U;
}

/// Which of 24 directions a normal is nearest to: the sharp edges of a box stay sharp.
std::uint64_t facing_of(const Vec3f& normal) {
    const Vec3f size = glm::abs(normal);
    const std::uint64_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return axis << 3U | (normal.x < 0.0F ? 4U : 0U) | (normal.y < 0.0F ? 2U : 0U) |
           (normal.z < 0.0F ? 1U : 0U);
}

/// Numbers by key, with open addressing: a first picture waits for a million askings.
template <class Number>
class NumberTable {
public:
    /// For `most` keys, none of which is ~0; `initial` is the number of one not asked before.
    NumberTable(std::size_t most, Number initial)
        : slots_(std::bit_ceil(most * 2 + 1), {kNoKey, initial}) {}

    Number& operator[](std::uint64_t key) {
        std::uint64_t place = key * 0x9E3779B97F4A7C15ULL;
        place ^= place >> 32U;
        for (;; ++place) {
            Slot& slot = slots_[place & (slots_.size() - 1)];
            if (slot.key == kNoKey) slot.key = key;
            if (slot.key == key) return slot.number;
        }
    }

    template <class Visit>
    void each(Visit&& visit) const {
        for (const Slot& slot : slots_)
            if (slot.key != kNoKey) visit(slot.key, slot.number);
    }

private:
    static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};
    struct Slot {
        std::uint64_t key;
        Number number;
    };
    std::vector<Slot> slots_;
};

/// For each key the place of the first equal one.
std::vector<std::uint32_t> first_with(const std::vector<std::uint64_t>& keys) {
    constexpr std::uint32_t kNone = ~0U;
    NumberTable<std::uint32_t> first_of_key(keys.size(), kNone);
    std::vector<std::uint32_t> first(keys.size());
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        std::uint32_t& known = first_of_key[keys[i]];
        if (known == kNone) known = i;
        first[i] = known;
    }
    return first;
}

/// By vertex.
std::vector<std::uint64_t> cells_of(const std::vector<Vertex>& vertices, float cell_m) {
    std::vector<std::uint64_t> cells(vertices.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = key_of(vertices[i].position_body, cell_m);
    return cells;
}

/// For each vertex of its cell the first one that faces as it does.
std::vector<std::uint32_t> first_facing_so(const std::vector<Vertex>& vertices,
                                           std::vector<std::uint64_t> cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] |= facing_of(vertices[i].normal_body) << 57U;
    return first_with(cells);
}

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
    std::uint32_t triangles{0};
    std::int64_t open_edges{0};  ///< an edge of two triangles counts once there and once back
    Vec3f sum{0.0F};
    std::uint32_t corners{0};
};

/// What the pieces of a mesh are, by the vertex that stands for them.
struct Analysis {
    std::vector<std::uint32_t> piece_of;  ///< by vertex
    std::vector<Piece> pieces;            ///< by piece; most are empty
    bool is_card(std::uint32_t vertex) const {
        const Piece& piece = pieces[piece_of[vertex]];
        return piece.triangles <= kCardTriangles && piece.open_edges != 0;
    }
};

Analysis analysed(const MeshData& mesh, float weld_m) {
    const std::vector<std::uint32_t> welded = first_with(cells_of(mesh.vertices, weld_m));
    Pieces joined(mesh.vertices.size());
    NumberTable<std::int32_t> edge_use(mesh.indices.size(), 0);
    const auto edge = [&](std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = welded[mesh.indices[i + k]];
            const std::uint32_t b = welded[mesh.indices[i + (k + 1) % 3]];
            joined.join(a, b);
            edge_use[edge(a, b)] += a < b ? 1 : -1;
        }
    }
    Analysis analysis;
    analysis.pieces.resize(mesh.vertices.size());
    for (const std::uint32_t vertex : welded) analysis.piece_of.push_back(joined.find(vertex));
    edge_use.each([&](std::uint64_t ends, std::int32_t use) {
        const auto vertex = static_cast<std::uint32_t>(ends);
        analysis.pieces[analysis.piece_of[vertex]].open_edges += std::abs(use);
    });
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        Piece& piece = analysis.pieces[analysis.piece_of[mesh.indices[i]]];
        if (i % 3 == 0) ++piece.triangles;
        piece.sum += mesh.vertices[mesh.indices[i]].position_body;
        ++piece.corners;
    }
    return analysis;
}

/// Evenly spread over 0…1, the same for the same number.
float share_of(std::uint32_t number) {
    std::uint32_t h = number * 0x9E3779B9U;
    h ^= h >> 16U;
    h *= 0x85EBCA6BU;
    h ^= h >> 13U;
    return static_cast<float>(h >> 8U) / static_cast<float>(1U << 24U);
}

class Coarser {
public:
    /// `cells`: of the mesh's vertices.
    Coarser(MeshData& mesh,
            const Analysis& analysis,
            const Detail& detail,
            const std::vector<std::uint64_t>& cells)
        : mesh_(mesh),
          analysis_(analysis),
          detail_(detail),
          cell_of_(first_with(cells)),
          stand_in_(first_facing_so(mesh.vertices, cells)) {}

    /// Appends what is left of one part.
    SubMesh add(const SubMesh& part, bool is_foliage) {
        SubMesh coarse{part};
        coarse.first_index = static_cast<std::uint32_t>(mesh_.indices.size());
        for (std::uint32_t i = 0; i + 2 < part.index_count; i += 3) {
            const std::array<std::uint32_t, 3> corners{mesh_.indices[part.first_index + i],
                                                       mesh_.indices[part.first_index + i + 1],
                                                       mesh_.indices[part.first_index + i + 2]};
            if (is_foliage && analysis_.is_card(corners[0])) {
                add_card(corners);
            } else {
                add_clustered(corners);
            }
        }
        coarse.index_count = static_cast<std::uint32_t>(mesh_.indices.size()) - coarse.first_index;
        return coarse;
    }

private:
    void add_card(const std::array<std::uint32_t, 3>& corners) {
        const std::uint32_t piece_index = analysis_.piece_of[corners[0]];
        if (share_of(piece_index) > detail_.kept_cards) return;
        const Piece& piece = analysis_.pieces[piece_index];
        const Vec3f center = piece.sum / static_cast<float>(piece.corners);
        for (const std::uint32_t corner : corners) {
            const auto [found, is_new] =
                enlarged_.emplace(corner, static_cast<std::uint32_t>(mesh_.vertices.size()));
            if (is_new) {
                Vertex vertex = mesh_.vertices[corner];
                vertex.position_body =
                    center + (vertex.position_body - center) * detail_.card_scale;
                mesh_.vertices.push_back(vertex);
            }
            mesh_.indices.push_back(found->second);
        }
    }

    void add_clustered(const std::array<std::uint32_t, 3>& corners) {
        const std::uint32_t a = cell_of_[corners[0]];
        const std::uint32_t b = cell_of_[corners[1]];
        const std::uint32_t c = cell_of_[corners[2]];
        if (a == b || b == c || c == a) return;
        for (const std::uint32_t corner : corners) mesh_.indices.push_back(stand_in_[corner]);
    }

    MeshData& mesh_;
    const Analysis& analysis_;
    const Detail& detail_;
    std::vector<std::uint32_t> cell_of_;
    std::vector<std::uint32_t> stand_in_;
    std::unordered_map<std::uint32_t, std::uint32_t> enlarged_;
};

}  // namespace

std::vector<MeshLod> add_lods(MeshData& mesh, const std::vector<bool>& is_foliage) {
    if (mesh.indices.size() / 3 <= kCheapTriangles) return {};
    const float diagonal_m = glm::length(mesh.bounds.size());
    if (!(diagonal_m > 0.0F) || !std::isfinite(diagonal_m)) return {};
    const Analysis analysis = analysed(mesh, diagonal_m * 1e-5F);
    const std::vector<SubMesh> parts = mesh.sub_meshes;
    std::vector<MeshLod> lods;
    std::size_t before = mesh.indices.size();
    for (const Detail& detail : kDetails) {
        MeshLod lod{.error_m = diagonal_m * detail.error_share, .sub_meshes = {}};
        const std::size_t first = mesh.indices.size();
        Coarser coarser(mesh, analysis, detail, cells_of(mesh.vertices, kCell * lod.error_m));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            lod.sub_meshes.push_back(coarser.add(parts[i], i < is_foliage.size() && is_foliage[i]));
        }
        const std::size_t count = mesh.indices.size() - first;
        // A version that saves little is not worth a change of picture.
        if (count * 10 > before * 9) {
            mesh.indices.resize(first);  // vertices made for it stay, unused
            continue;
        }
        before = count;
        lods.push_back(std::move(lod));
    }
    return lods;
}

}  // namespace plumbline::render

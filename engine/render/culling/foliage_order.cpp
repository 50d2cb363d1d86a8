#include "engine/render/culling/foliage_order.h"

#include <algorithm>
#include <cmath>

namespace plumbline::render {
namespace {

/// Smaller things hide too little of themselves to be drawn apart for each side.
constexpr std::uint32_t kDenseIndices = 3000;

/// Neighbouring triangles that share a corner: two halves of a card stay together, and their
/// vertices are computed once.
struct Card {
    std::uint32_t first{0};
    std::uint32_t count{0};  ///< indices
    Vec3f center_body{0.0F};
};

std::vector<Card> cards_of(const std::vector<assets::Vertex>& vertices,
                           const std::vector<std::uint32_t>& indices,
                           const assets::SubMesh& part) {
    std::vector<Card> cards;
    for (std::uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
        const auto is_in_last = [&](std::uint32_t index) {
            const auto last = indices.begin() + cards.back().first;
            return std::find(last, last + cards.back().count, index) != last + cards.back().count;
        };
        const bool goes_on =
            !cards.empty() &&
            (is_in_last(indices[i]) || is_in_last(indices[i + 1]) || is_in_last(indices[i + 2]));
        if (!goes_on) cards.push_back({.first = i});
        cards.back().count += 3;
        for (std::uint32_t k = 0; k < 3; ++k)
            cards.back().center_body += vertices[indices[i + k]].position_body;
    }
    for (Card& card : cards) card.center_body /= static_cast<float>(card.count);
    return cards;
}

Vec3f to_eye_of(std::size_t side) {
    const float turn = glm::two_pi<float>() * static_cast<float>(side) / kFoliageSides;
    return {std::cos(turn), 0.0F, std::sin(turn)};
}

void append_sides(const std::vector<assets::Vertex>& vertices,
                  std::vector<std::uint32_t>& indices,
                  MeshLod& lod,
                  std::size_t part) {
    std::vector<Card> cards = cards_of(vertices, indices, lod.sub_meshes[part]);
    for (std::size_t side = 0; side < kFoliageSides; ++side) {
        const Vec3f to_eye = to_eye_of(side);
        std::ranges::stable_sort(cards, std::greater{}, [&](const Card& card) {
            return glm::dot(card.center_body, to_eye);
        });
        lod.by_side[side][part].first_index = static_cast<std::uint32_t>(indices.size());
        for (const Card& card : cards) {
            for (std::uint32_t k = 0; k < card.count; ++k)
                indices.push_back(indices[card.first + k]);
        }
    }
}

}  // namespace

std::size_t side_seen_from(const Vec3f& to_eye_body) {
    const float turns = std::atan2(to_eye_body.z, to_eye_body.x) / glm::two_pi<float>();
    const auto side = static_cast<int>(std::lround(turns * static_cast<float>(kFoliageSides)));
    return static_cast<std::size_t>(side + static_cast<int>(kFoliageSides)) % kFoliageSides;
}

void add_foliage_order(const std::vector<assets::Vertex>& vertices,
                       const std::vector<bool>& is_foliage,
                       std::vector<std::uint32_t>& indices,
                       std::vector<MeshLod>& lods) {
    for (MeshLod& lod : lods) {
        for (std::size_t i = 0; i < std::min(lod.sub_meshes.size(), is_foliage.size()); ++i) {
            if (!is_foliage[i] || lod.sub_meshes[i].index_count < kDenseIndices) continue;
            if (lod.by_side.empty()) lod.by_side.assign(kFoliageSides, lod.sub_meshes);
            const MeshLod* before = &lod == &lods.front() ? nullptr : &lod - 1;
            if (before != nullptr &&
                before->sub_meshes[i].first_index == lod.sub_meshes[i].first_index) {
                for (std::size_t side = 0; side < kFoliageSides; ++side)
                    lod.by_side[side][i] = before->by_side[side][i];
                continue;
            }
            append_sides(vertices, indices, lod, i);
        }
    }
}

}  // namespace plumbline::render

#include "engine/effects/nature/grass_tufts.h"

#include "engine/core/random.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

/// Spreads the two numbers of a cell, or a variant, over all seeds.
std::uint64_t seed_of(int x, int z) {
    const auto bits = [](int n) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(n));
    };
    return (bits(x) << 32U | bits(z)) * 0x9E3779B97F4A7C15ULL;
}

struct Blade {
    Vec3f root;
    Vec3f lean;  ///< way of its tip from above its root
    Vec3f side;  ///< half its width at the root
    float height;
    std::uint8_t phase;
    float tone;
};

void add_vertex(assets::MeshData& mesh, const Blade& blade, float up, float aside) {
    const Vec3f position = blade.root + Vec3f{0.0F, blade.height * up, 0.0F} +
                           blade.lean * (up * up) + blade.side * aside;
    // Lit as the lawn is: blades that show their own normals look like scattered straw.
    const Vec3f normal =
        glm::normalize(Vec3f{0.0F, 1.0F, 0.0F} + 0.25F * glm::normalize(blade.lean + Vec3f{1e-4F}));
    const float light = blade.tone * (0.6F + 1.0F * up);
    mesh.vertices.push_back(
        {.position_body = position,
         .normal_body = normal,
         .color = Vec3f{light * (0.95F + 0.25F * up), light, light * (1.0F - 0.15F * up)},
         .wind = {.sway = static_cast<std::uint8_t>(110.0F * up),
                  .phase = blade.phase,
                  .flutter = static_cast<std::uint8_t>(40.0F * up)}});
}

}  // namespace

assets::MeshData tuft_mesh(std::uint32_t variant, bool near) {
    constexpr float kSpread_m = 2.0F;  // of a tuft 1 m high
    Random random(seed_of(static_cast<int>(variant), near ? 1 : 2));
    assets::MeshData mesh;
    const int blades = near ? 26 : 12;
    const float half_width_m = near ? 0.035F : 0.07F;
    for (int i = 0; i < blades; ++i) {
        const float angle = random.uniform(0.0F, 2.0F * glm::pi<float>());
        const float off_m = kSpread_m * std::sqrt(random.uniform());
        const float facing = random.uniform(0.0F, 2.0F * glm::pi<float>());
        const float height = random.uniform(0.55F, 1.25F);
        const float lean = random.uniform(0.1F, 0.65F) * height;
        const float towards = angle + random.uniform(-1.2F, 1.2F);
        const Blade blade{.root = {off_m * std::cos(angle), 0.0F, off_m * std::sin(angle)},
                          .lean = {lean * std::cos(towards), 0.0F, lean * std::sin(towards)},
                          .side = Vec3f{std::cos(facing), 0.0F, std::sin(facing)} * half_width_m,
                          .height = height,
                          .phase = static_cast<std::uint8_t>(random.below(256)),
                          .tone = random.uniform(0.8F, 1.25F)};
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        add_vertex(mesh, blade, 0.0F, -1.0F);
        add_vertex(mesh, blade, 0.0F, 1.0F);
        if (near) {
            add_vertex(mesh, blade, 0.55F, -0.7F);
            add_vertex(mesh, blade, 0.55F, 0.7F);
        }
        add_vertex(mesh, blade, 1.0F, 0.0F);
        const auto corners = near ? std::vector<std::uint32_t>{0, 1, 3, 0, 3, 2, 2, 3, 4}
                                  : std::vector<std::uint32_t>{0, 1, 2};
        for (const std::uint32_t corner : corners) mesh.indices.push_back(first + corner);
    }
    return assets::finished(std::move(mesh));
}

std::vector<Tuft> GrassField::grow(int x, int z, const LawnAt& lawn) const {
    Random random(seed_of(x, z));
    const float expected = static_cast<float>(grass_.density_perm2) * kGrassCell_m * kGrassCell_m;
    const int count = static_cast<int>(expected + random.uniform());
    std::vector<Tuft> tufts;
    for (int i = 0; i < count; ++i) {
        Tuft tuft{.root_world = {(static_cast<float>(x) + random.uniform()) * kGrassCell_m,
                                 0.0F,
                                 (static_cast<float>(z) + random.uniform()) * kGrassCell_m},
                  .yaw_rad = random.uniform(0.0F, 2.0F * glm::pi<float>()),
                  .scale = static_cast<float>(grass_.height_m) * random.uniform(0.65F, 1.35F),
                  .shade = random.uniform(0.85F, 1.2F),
                  .rank = random.uniform(),
                  .variant = random.below(kTuftVariants)};
        const auto height = lawn(tuft.root_world.x, tuft.root_world.z);
        if (!height) continue;
        tuft.root_world.y = *height;
        tufts.push_back(tuft);
    }
    return tufts;
}

void GrassField::follow(const Vec3f& eye_world,
                        float reach_m,
                        std::size_t most_new,
                        const LawnAt& lawn) {
    const auto distance_m = [&](const std::pair<int, int>& cell) {
        const float x = (static_cast<float>(cell.first) + 0.5F) * kGrassCell_m - eye_world.x;
        const float z = (static_cast<float>(cell.second) + 0.5F) * kGrassCell_m - eye_world.z;
        return std::hypot(x, z);
    };
    std::erase_if(cells_, [&](const auto& cell) {
        return distance_m(cell.first) > reach_m + 3.0F * kGrassCell_m;
    });
    const int span = static_cast<int>(std::ceil(reach_m / kGrassCell_m));
    const int middle_x = static_cast<int>(std::floor(eye_world.x / kGrassCell_m));
    const int middle_z = static_cast<int>(std::floor(eye_world.z / kGrassCell_m));
    std::vector<std::pair<int, int>> missing;
    for (int x = middle_x - span; x <= middle_x + span; ++x) {
        for (int z = middle_z - span; z <= middle_z + span; ++z) {
            const std::pair cell{x, z};
            if (distance_m(cell) <= reach_m + kGrassCell_m && !cells_.contains(cell))
                missing.push_back(cell);
        }
    }
    std::ranges::sort(missing, {}, distance_m);
    for (std::size_t i = 0; i < std::min(missing.size(), most_new); ++i)
        cells_.emplace(missing[i], grow(missing[i].first, missing[i].second, lawn));
}

std::size_t GrassField::bytes() const {
    std::size_t bytes = 0;
    for (const auto& [cell, tufts] : cells_)
        bytes += tufts.capacity() * sizeof(Tuft) + sizeof(cell);
    return bytes;
}

}  // namespace plumbline::effects

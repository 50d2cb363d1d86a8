// Birds and butterflies: decoration. They fly smooth ways of their own through the air and touch
// nothing.
#include "engine/core/random.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

#include <array>
#include <cmath>
#include <utility>

namespace plumbline::effects {
namespace {

using scene::FlockKind;

/// What tells the kinds apart.
struct Kind {
    float half_span_m;
    float body_m;  ///< length
    float speed_mps;
    float beat_hz;    ///< of the wings
    float beat_rad;   ///< up and down from level
    float glides;     ///< share of the time
    float wander_hz;  ///< of small turns, as butterflies make them
    float wander_m;
};
constexpr Kind kBird{0.3F, 0.28F, 7.0F, 3.6F, 0.75F, 0.5F, 0.0F, 0.0F};
constexpr Kind kButterfly{0.045F, 0.03F, 0.8F, 8.5F, 1.15F, 0.15F, 0.9F, 0.12F};

const Kind& kind_of(FlockKind kind) {
    return kind == FlockKind::Birds ? kBird : kButterfly;
}

/// A closed, smooth way: three sines an axis that repeat together very late.
struct Flyer {
    std::array<Vec3f, 3> turn_rad;  ///< at time 0
    std::array<float, 3> rate_radps;
    float beat_turn{0.0F};
    float pace{1.0F};
    assets::MaterialId wing{};
};

/// A flat wing out along +X from the body, its front towards -Z.
assets::MeshData wing_mesh(FlockKind kind) {
    assets::MeshData mesh;
    const auto corner = [&](float x, float z, const Vec3f& color) {
        mesh.vertices.push_back({.position_body = {x, 0.0F, z}, .color = color});
    };
    const Vec3f light{1.0F};
    const Vec3f dark{0.25F};
    if (kind == FlockKind::Birds) {
        corner(0.0F, -0.22F, light);
        corner(0.0F, 0.24F, light);
        corner(0.5F, -0.3F, light);
        corner(0.5F, 0.14F, light);
        corner(1.0F, -0.02F, dark);
        mesh.indices = {0, 1, 2, 2, 1, 3, 2, 3, 4};
    } else {
        corner(0.0F, 0.0F, light);
        corner(0.75F, -0.85F, light);
        corner(1.0F, -0.45F, dark);
        corner(0.55F, 0.1F, light);
        corner(0.8F, 0.55F, dark);
        corner(0.25F, 0.75F, light);
        mesh.indices = {0, 3, 1, 1, 3, 2, 0, 5, 3, 3, 5, 4};
    }
    return assets::finished(std::move(mesh));
}

/// A spindle along -Z, 1 m long.
assets::MeshData body_mesh() {
    assets::MeshData mesh;
    constexpr std::array<Vec2f, 4> kProfile{
        {{0.0F, -0.5F}, {0.13F, -0.3F}, {0.11F, 0.1F}, {0.02F, 0.5F}}};
    constexpr std::uint32_t kSides = 6;
    for (const Vec2f& ring : kProfile) {
        for (std::uint32_t i = 0; i < kSides; ++i) {
            const float angle = 2.0F * glm::pi<float>() * static_cast<float>(i) / kSides;
            mesh.vertices.push_back(
                {.position_body = {ring.x * std::cos(angle), ring.x * std::sin(angle), ring.y}});
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < kProfile.size(); ++ring) {
        for (std::uint32_t i = 0; i < kSides; ++i) {
            const std::uint32_t a = ring * kSides + i;
            const std::uint32_t b = ring * kSides + (i + 1) % kSides;
            for (const std::uint32_t c : {a, b, a + kSides, b, b + kSides, a + kSides})
                mesh.indices.push_back(c);
        }
    }
    assets::compute_normals(mesh);
    return assets::finished(std::move(mesh));
}

/// One `[[flock]]`.
class Flight {
public:
    Flight(const scene::FlockDescription& flock, std::uint64_t seed, assets::AssetLibrary& library)
        : flock_(flock), kind_(kind_of(flock.kind)) {
        const bool birds = flock.kind == FlockKind::Birds;
        wing_ = library.add_mesh(birds ? "bird's wing" : "butterfly's wing", wing_mesh(flock.kind));
        body_ = library.add_mesh("flyer's body", body_mesh());
        const auto material = [&](const Vec3f& color) {
            return library.add_material({.name = "feathers",
                                         .base_color = color,
                                         .roughness = 0.9F,
                                         .vertex_colors = true,
                                         .two_sided = true});
        };
        constexpr std::array<Vec3f, 4> kButterflies{
            {{0.85F, 0.8F, 0.6F}, {0.8F, 0.3F, 0.04F}, {0.75F, 0.6F, 0.05F}, {0.2F, 0.35F, 0.8F}}};
        dark_ = material(Vec3f{0.045F, 0.04F, 0.04F});
        Random random(seed);
        for (int i = 0; i < flock.count; ++i) {
            Flyer flyer{.beat_turn = random.uniform(0.0F, 6.28F),
                        .pace = random.uniform(0.85F, 1.15F),
                        .wing = birds ? dark_ : material(kButterflies[random.below(4)])};
            for (std::size_t k = 0; k < 3; ++k) {
                for (int axis = 0; axis < 3; ++axis)
                    flyer.turn_rad[k][axis] = random.uniform(0.0F, 6.28F);
                // The first carries it round; the others are a golden ratio faster each.
                flyer.rate_radps[k] = kind_.speed_mps / static_cast<float>(flock.radius_m) *
                                      std::pow(1.618F, static_cast<float>(k)) * flyer.pace;
            }
            flyers_.push_back(flyer);
        }
    }

    void add_items(float time_s, render::RenderFrame& frame) const {
        for (const Flyer& flyer : flyers_) {
            const Vec3f place = place_of(flyer, time_s);
            const Vec3f displacement = place_of(flyer, time_s + 0.05F) - place;
            const Vec3f ahead = glm::normalize(displacement + Vec3f{0.0F, 0.0F, 1e-5F});
            const Vec3f right = glm::normalize(glm::cross(ahead, Vec3f{0.0F, 1.0F, 1e-4F}));
            const Mat4f pose{Vec4f{right, 0.0F},
                             Vec4f{glm::cross(right, ahead), 0.0F},
                             Vec4f{-ahead, 0.0F},
                             Vec4f{place, 1.0F}};
            const float beat = beat_of(flyer, time_s);
            for (const float side : {1.0F, -1.0F}) {
                const Mat4f raised = glm::rotate(pose, side * beat, Vec3f{0.0F, 0.0F, 1.0F});
                const Vec3f size = kind_.half_span_m * Vec3f{side, 1.0F, 1.0F};
                add(wing_, flyer.wing, glm::scale(raised, size), frame);
            }
            add(body_, dark_, glm::scale(pose, Vec3f{kind_.body_m}), frame);
        }
    }

    std::size_t bytes() const { return flyers_.capacity() * sizeof(Flyer); }

private:
    Vec3f place_of(const Flyer& flyer, float time_s) const {
        constexpr std::array<float, 3> kShares{0.62F, 0.26F, 0.12F};
        Vec3f share{0.0F};
        for (std::size_t k = 0; k < 3; ++k)
            share += kShares[k] * glm::sin(flyer.turn_rad[k] + flyer.rate_radps[k] * time_s);
        // Each of two axes goes so far.
        const float radius_m =
            static_cast<float>(flock_.radius_m) * glm::one_over_root_two<float>();
        const auto height_m = static_cast<float>(flock_.height_m);
        Vec3f place = Vec3f(flock_.center_m) + share * Vec3f{radius_m, 0.5F * height_m, radius_m};
        const float wander = 2.0F * glm::pi<float>() * kind_.wander_hz * time_s + flyer.beat_turn;
        place += kind_.wander_m *
                 Vec3f{std::sin(1.3F * wander), std::sin(2.1F * wander), std::cos(wander)};
        return place;
    }

    /// The wings' angle above level. Between strokes it glides with wings a little up.
    float beat_of(const Flyer& flyer, float time_s) const {
        const float spell = std::sin(0.9F * time_s * flyer.pace + 3.0F * flyer.beat_turn);
        const float limit = 1.0F - 2.0F * kind_.glides;
        const float strength = glm::smoothstep(-limit - 0.2F, -limit + 0.2F, spell);
        const float turn =
            2.0F * glm::pi<float>() * kind_.beat_hz * flyer.pace * time_s + flyer.beat_turn;
        return 0.15F + strength * kind_.beat_rad * std::sin(turn);
    }

    static void add(assets::MeshId mesh,
                    assets::MaterialId material,
                    const Mat4f& world_from_body,
                    render::RenderFrame& frame) {
        render::add_item(frame,
                         {.mesh = mesh, .world_from_body = world_from_body, .casts_shadow = false},
                         {&material, 1});
    }

    scene::FlockDescription flock_;
    Kind kind_;
    assets::MeshId wing_{};
    assets::MeshId body_{};
    assets::MaterialId dark_{};
    std::vector<Flyer> flyers_;
};

class Flock final : public Effect {
public:
    explicit Flock(scene::Simulation& simulation) {
        std::uint64_t seed = 1;
        for (const scene::FlockDescription& flock : simulation.description().flocks)
            flights_.emplace_back(flock, seed++, simulation.library());
    }

    void extract(const scene::Simulation&,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        for (const Flight& flight : flights_) flight.add_items(frame.time_s, frame);
        ++work_.calls;
    }

    std::uint64_t bytes_held() const override {
        std::size_t bytes = flights_.capacity() * sizeof(Flight);
        for (const Flight& flight : flights_) bytes += flight.bytes();
        return bytes;
    }

private:
    std::vector<Flight> flights_;
};

Callers callers_of_flock(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("flock", true)) return {};
    Callers callers;
    for (const scene::FlockDescription& flock : simulation.description().flocks)
        callers.push_back(setting("[[flock]]", flock.location));
    return callers;
}

}  // namespace

EffectRow flock() {
    return with_effect<Flock>({.called_for_by = &callers_of_flock});
}

}  // namespace plumbline::effects

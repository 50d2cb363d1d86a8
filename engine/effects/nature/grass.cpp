// Grass round the eye: dense near, smaller and fewer towards its edge.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/nature/grass_tufts.h"
#include "engine/physics/query.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

namespace plumbline::effects {
namespace {

/// Tufts nearer than this are drawn with all their blades.
constexpr float kNear_m = 3.5F;
/// Cells that a frame may grow: rays are cast for each.
constexpr std::size_t kCellsAFrame = 4;

class Grass final : public Effect {
public:
    explicit Grass(scene::Simulation& simulation)
        : grass_(*simulation.description().grass),
          field_(grass_),
          material_(simulation.library().add_material({.name = "grass blades",
                                                       .base_color = grass_.color,
                                                       .roughness = 1.0F,
                                                       .vertex_colors = true})) {
        for (std::uint32_t i = 0; i < kTuftVariants; ++i) {
            near_[i] =
                simulation.library().add_mesh(fmt::format("grass tuft {}", i), tuft_mesh(i, true));
            far_[i] = simulation.library().add_mesh(fmt::format("grass tuft {} from afar", i),
                                                    tuft_mesh(i, false));
        }
        for (const std::string& name : grass_.on) {
            const ecs::Entity entity = simulation.find(name);
            if (simulation.registry.alive(entity)) lawns_.insert(scene::mark_of(entity));
        }
    }

    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const float share = frame.quality.ground_cover;
        if (share <= 0.0F) return;
        const float reach_m = static_cast<float>(grass_.distance_m) * share;
        const Vec3f eye = frame.camera.position_world;
        field_.follow(
            eye,
            reach_m,
            std::exchange(first_, false) ? std::numeric_limits<std::size_t>::max() : kCellsAFrame,
            [&](float x, float z) { return lawn_at(simulation, eye.y, x, z); });
        for (const auto& [cell, tufts] : field_.cells()) {
            for (const Tuft& tuft : tufts) add(tuft, eye, reach_m, share, frame);
        }
        ++work_.calls;
    }

    std::uint64_t bytes_held() const override { return field_.bytes(); }

private:
    /// Looked for from above the trees down to well below the eye: under a roof grows nothing.
    std::optional<float> lawn_at(const scene::Simulation& simulation,
                                 float eye_y,
                                 float x,
                                 float z) const {
        constexpr float kUp_m = 30.0F;
        const Vec3 from{Real{x}, Real{eye_y + kUp_m}, Real{z}};
        const Vec3 to{Real{x}, Real{eye_y - kUp_m}, Real{z}};
        const auto hit = cast_ray(simulation.physics, from, to);
        if (!hit || !lawns_.contains(hit->user)) return {};
        return static_cast<float>(hit->point_world.y);
    }

    void add(const Tuft& tuft,
             const Vec3f& eye,
             float reach_m,
             float share,
             render::RenderFrame& frame) const {
        const float distance_m = glm::distance(tuft.root_world, eye);
        // From half way they thin out and grow smaller, so that no edge is seen.
        const float fade = std::clamp(2.0F - 2.0F * distance_m / reach_m, 0.0F, 1.0F);
        if (tuft.rank > share * (0.25F + 0.75F * fade) || fade <= 0.02F) return;
        const float scale = tuft.scale * (0.4F + 0.6F * fade);
        const Mat4f placed = glm::translate(Mat4f{1.0F}, tuft.root_world);
        const Mat4f turned = glm::rotate(placed, tuft.yaw_rad, Vec3f{0.0F, 1.0F, 0.0F});
        const auto& meshes = distance_m < kNear_m ? near_ : far_;
        render::add_item(frame,
                         {.mesh = meshes[tuft.variant],
                          .world_from_body = glm::scale(turned, Vec3f{scale}),
                          .tint = Vec3f{tuft.shade},
                          .casts_shadow = false},
                         {&material_, 1});
    }

    const scene::GrassDescription grass_;
    GrassField field_;
    assets::MaterialId material_;
    std::array<assets::MeshId, kTuftVariants> near_{};
    std::array<assets::MeshId, kTuftVariants> far_{};
    std::set<std::uint64_t> lawns_;
    bool first_{true};
};

Callers callers_of_grass(const scene::Simulation& simulation) {
    const auto& grass = simulation.description().grass;
    if (!grass || !simulation.switches.is_on("grass", true)) return {};
    return {setting("[grass]", grass->location)};
}

}  // namespace

EffectRow grass() {
    return with_effect<Grass>({.called_for_by = &callers_of_grass});
}

}  // namespace plumbline::effects
